"""The page `book/src/peers.md` by its sections, and processes with their cost."""

import os
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PAGE = ROOT / "book" / "src" / "peers.md"
ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "RAYON_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")


def put(title, lines):
    """Put a section in the place of that of the same title, or after all others."""
    head, *sections = PAGE.read_text("utf-8").split("\n## ")
    own = f"{title}\n\n" + "\n".join(lines).rstrip() + "\n"
    titles = [section.partition("\n")[0] for section in sections]
    if title in titles:
        sections[titles.index(title)] = own
    else:
        sections.append(own)
    PAGE.write_text("\n\n## ".join([head.rstrip(), *(section.rstrip() for section in sections)]) + "\n", "utf-8")


def table(heads, rows):
    """Lines of a table."""
    lines = [heads, ["---"] * len(heads), *rows]
    return ["| " + " | ".join(str(cell) for cell in line) + " |" for line in lines]


def archard():
    """The command of this repository, as it is shipped; another one may be named by ARCHARD."""
    if "ARCHARD" in os.environ:
        return Path(os.environ["ARCHARD"]).resolve()
    subprocess.run(["cargo", "build", "--release", "--bin", "archard"], cwd=ROOT, check=True)
    return ROOT / "target" / "release" / "archard"


def timed(command, folder):
    """CPU seconds and the most memory (MB) of a process on one thread."""
    with subprocess.Popen(
        command, cwd=folder, env=os.environ | ONE_THREAD, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{command} failed")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def lasting(command, folder, turns):
    """The least CPU seconds of some turns, and the most memory (MB)."""
    found = [timed(command, folder) for _ in range(turns)]
    return min(seconds for seconds, _ in found), max(memory for _, memory in found)
