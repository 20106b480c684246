"""What distributes Archard: one version everywhere, notes of a release, the installer."""

import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

import archard

ROOT = Path(__file__).parents[2]
PACKAGING = ROOT / "packaging"

pytestmark = pytest.mark.skipif(os.name == "nt", reason="shells of POSIX")


@pytest.mark.parametrize(
    ("file", "pattern"),
    [
        ("Cargo.toml", r'^version = "(.*)"'),
        ("CITATION.cff", r"^version: (.*)"),
        ("packaging/conda/recipe.yaml", r'^  version: "(.*)"'),
        ("packaging/homebrew/archard.rb", r"archard-(.*)-source.tar.gz"),
        ("packaging/install.sh", r"ARCHARD_VERSION:-(.*)}"),
    ],
)
def test_versions_are_that_of_the_workspace(file, pattern):
    assert re.search(pattern, (ROOT / file).read_text(), re.MULTILINE)[1] == archard.__version__


def test_notes_are_the_section_of_a_version(tmp_path):
    script = tmp_path / "packaging" / "notes"
    script.parent.mkdir()
    shutil.copy(PACKAGING / "notes", script)
    sections = "## [Unreleased]\n\n## [0.2.0] - 2027-01-01\n\n### Added\n\n- One.\n\n## [0.1.0]\n\n- Two.\n"
    (tmp_path / "CHANGELOG.md").write_text(sections)

    def notes(version):
        return subprocess.run([script, version], capture_output=True, text=True)

    assert notes("0.2.0").stdout.strip() == "### Added\n\n- One."
    assert notes("0.1.0").stdout.strip() == "- Two."
    assert notes("0.3.0").returncode == 1
    assert "no section [0.3.0]" in notes("0.3.0").stderr


@pytest.mark.skipif(not shutil.which("curl"), reason="the installer takes curl")
@pytest.mark.parametrize("damaged", [False, True])
def test_the_installer_takes_what_has_its_digest(damaged, tmp_path):
    machine = {"arm64": "aarch64", "amd64": "x86_64"}.get(platform.machine(), platform.machine())
    system = {"Linux": "unknown-linux-gnu", "Darwin": "apple-darwin"}[platform.system()]
    name = f"archard-9.9.9-{machine}-{system}"
    program = tmp_path / "archard"
    program.write_text("#!/bin/sh\necho archard 9.9.9\n")
    program.chmod(0o755)
    archive = tmp_path / f"{name}.tar.gz"
    with tarfile.open(archive, "w:gz") as file:
        file.add(program, f"{name}/archard")
    digest = hashlib.sha256(archive.read_bytes()).hexdigest()
    archive.with_name(archive.name + ".sha256").write_text(f"{digest}  {archive.name}\n")
    if damaged:
        archive.write_bytes(archive.read_bytes() + b"more")
    environment = os.environ | {"ARCHARD_VERSION": "9.9.9", "ARCHARD_FROM": tmp_path.as_uri()}
    folder = tmp_path / "bin"
    command = ["sh", PACKAGING / "install.sh", folder]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    if damaged:
        assert done.returncode == 1
        assert "digest" in done.stderr
        assert not folder.exists()
    else:
        assert done.returncode == 0, done.stderr
        assert f"installed archard 9.9.9 as {folder}/archard" in done.stdout
        assert subprocess.check_output([folder / "archard"], text=True) == "archard 9.9.9\n"


@pytest.mark.skipif(sys.version_info < (3, 11), reason="the script reads TOML")
def test_the_owner_fills_in_one_file(tmp_path):
    """Address, authors and digest come from one file, and a second run changes nothing."""
    files = ["CITATION.cff", "Cargo.toml", ".zenodo.json", "paper/paper.md", "python/pyproject.toml"]
    files += [f"packaging/{name}" for name in ("conda/recipe.yaml", "homebrew/archard.rb", "install.sh", "owner")]
    for name in files:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    (tmp_path / "packaging/owner.toml").write_text(
        'address = "https://code.test/wear/archard"\n'
        '[[author]]\nname = "Ada Löwe"\norcid = "0000-0001-2345-6789"\naffiliation = "Institute of Wear"\n'
        '[[author]]\nname = "Bo Rigg"\n'
    )
    archive = tmp_path / "archard-0.1.0-source.tar.gz"
    archive.write_bytes(b"a source")

    def run():
        command = [sys.executable, tmp_path / "packaging/owner", archive]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    run()
    texts = {name: (tmp_path / name).read_text() for name in files if name != "packaging/owner"}
    assert not [name for name, text in texts.items() if "https://example.org" in text]
    assert 'repository = "https://code.test/wear/archard"' in texts["Cargo.toml"]
    digest = hashlib.sha256(b"a source").hexdigest()
    assert digest in texts["packaging/conda/recipe.yaml"]
    assert digest in texts["packaging/homebrew/archard.rb"]
    for name in ("CITATION.cff", ".zenodo.json", "paper/paper.md", "python/pyproject.toml"):
        assert "Ada Löwe" in texts[name]
        assert "Bo Rigg" in texts[name]
    assert "orcid: 0000-0001-2345-6789\n    affiliation: 1" in texts["paper/paper.md"]
    assert "To be named\n    index: 2" in texts["paper/paper.md"]
    assert run() == ""


def test_actions_are_pinned():
    """Every action of a workflow is one commit."""
    used = [
        line.split("uses:")[1].strip()
        for path in (ROOT / ".github/workflows").glob("*.yml")
        for line in path.read_text().splitlines()
        if "uses:" in line
    ]
    others = [one for one in used if not one.startswith("./")]
    assert others
    assert [one for one in others if not re.fullmatch(r"[\w./-]+@[0-9a-f]{40} # v[\d.]+", one)] == []
