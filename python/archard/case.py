"""Cases: what is computed, as the file of a case says it."""

from __future__ import annotations

import difflib
import os
import re
import warnings
from collections.abc import Callable, Mapping
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from archard import _archard, _html, _surface, _toml
from archard._errors import CaseWarning, Problem
from archard._law import FrictionFunction, Law, WearFunction

if TYPE_CHECKING:
    from archard.result import Result
    from archard.run import Run, State

_CASES = Path(str(resources.files("archard"))) / "cases"


def cases() -> dict[str, str]:
    """The built-in cases and what each is about."""
    files = sorted(_CASES.glob("*/case.toml"))
    return {file.parent.name: _toml.read(file.read_text("utf-8"))["title"] for file in files}


class Forecast(NamedTuple):
    """What ``archard check`` says of a case; it prints the same."""

    text: str
    """What closed forms expect, what the run costs, and what of the verdict can be foreseen."""
    warnings: list[Problem]
    """What is doubtful about the case."""
    toml: str
    """The case in SI, as a case file."""

    def __repr__(self) -> str:
        return "\n".join([self.text, *map(str, self.warnings)])

    def _repr_html_(self) -> str:
        parts: list[str] = []
        rows: list[list[str]] = []
        for line in [*map(str.strip, self.text.splitlines()), ""]:
            row = re.split(r"\s{2,}", line, maxsplit=1)
            if len(row) == 2:
                rows.append(row)
                continue
            if rows and line:
                parts.append(_html.table([], rows))
                rows = []
            if line.startswith("# "):
                parts.append(_html.title(line.removeprefix("# ")))
            elif line:
                parts.append(_html.lines([line]))
        doubts = _html.lines(map(str, self.warnings))
        return _html.block(*parts, _html.table([], rows), doubts, _html.folded("in SI", _html.words(self.toml)))


class Case:
    """A case: a built-in name, a path, TOML text or a dict with the keys of a case file.

    Values are set and read by their dotted key, ``case["motion.sliding.load"] = "20 N"``. Those with a
    dimension are text with a unit, or anything with ``magnitude`` and ``units`` (pint); a bare number is refused
    where a unit belongs. Files that a case names are looked for from its folder on. A measured surface may be
    given in place of its file: ``profile.surface.file`` takes a NumPy array (with ``pixel`` and ``unit``), an
    xarray ``DataArray``, or a surface of SurfaceTopography or surfalize.
    """

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any] | Case) -> None:
        self._name: str
        self._text: str
        self._folder: Path
        self._options: list[str] = []
        # Arrays of surfaces by the files that stand for them.
        self._held: dict[str, Any] = {}
        if isinstance(source, Case):
            self._name, self._text, self._folder = source._name, source._text, source._folder
            self._options = list(source._options)
            self._held = dict(source._held)
        elif isinstance(source, Mapping):
            tree = _surface.laid(source, self._held)
            self._name, self._text, self._folder = "case", _toml.document(tree), Path.cwd()
        elif isinstance(source, str) and "\n" in source:
            self._name, self._text, self._folder = "case", source, Path.cwd()
        else:
            file = _file(source)
            self._name, self._text = str(file), file.read_text("utf-8")
            self._folder = file.absolute().parent
        try:
            self._tree = _toml.read(self._text)
        except ValueError:
            self._compiled().check()  # Says where and why, for all mistakes at once.
            raise
        for option in self._options:
            self._lay(*option.split("=", 1))

    def __setitem__(self, key: str, value: object) -> None:
        """Set a value, or a table, at a dotted key; what stands there is replaced."""
        for name, entry in _surface.laid({key: value}, self._held).items():
            text = _toml.value(entry)
            self._lay(name, text)
            self._options.append(f"{name}={text}")

    def __setattr__(self, name: str, value: object) -> None:
        """Refuse what would be lost: values of a case are set by their keys."""
        if not name.startswith("_"):
            keys = [key for key, _ in _toml.leaves(self._tree) if key.rpartition(".")[2] == name]
            said = " or ".join(f"case[{key!r}] = ..." for key in keys or [f"KEY.{name}"])
            raise AttributeError(f"a case has no attribute `{name}`; set a value by its key: {said}")
        super().__setattr__(name, value)

    def __getitem__(self, key: str) -> Any:
        """Return the value at a dotted key as it was written; tables and lists cannot be changed."""
        found: Any = self._tree
        for name in _toml.path(key):
            if not isinstance(found, dict) or name not in found:
                raise KeyError(key)
            found = found[name]
        return _toml.frozen(found)

    def __delitem__(self, key: str) -> None:
        """Remove a value or a table, as to go from one of two that exclude each other to the other."""
        self[key]
        self._lay(key, "")
        self._options.append(f"{key}=")

    def __contains__(self, key: str) -> bool:
        try:
            self[key]
        except KeyError:
            return False
        return True

    def __repr__(self) -> str:
        title = self._tree.get("title", "")
        return f"Case({self._name!r}{f': {title}' if title else ''})"

    def _repr_html_(self) -> str:
        leaves = [(key, entry) for key, entry in _toml.leaves(self._tree) if key != "title"]
        rows = [[key, entry if isinstance(entry, str) else _toml.value(entry)] for key, entry in leaves]
        return _html.block(_html.title(str(self._tree.get("title") or self._name)), _html.table([], rows))

    def copy(self) -> Case:
        """Another case like it."""
        return Case(self)

    def check(self) -> Forecast:
        """Read and check the case.

        Raises:
            CaseError: all that is wrong with it.

        """
        checked = self._compiled().check()
        problems = [Problem(*problem) for problem in checked.warnings]
        return Forecast(checked.expectations(), problems, checked.toml)

    def run(
        self,
        *,
        progress: bool = False,
        threads: int | None = None,
        out: str | os.PathLike[str] | None = None,
        resume: str | os.PathLike[str] | Result | None = None,
        laws: Mapping[str, WearFunction | Law] | None = None,
        friction: FrictionFunction | None = None,
        on_step: Callable[[State], object] | None = None,
        force: bool = False,
        cache: str | os.PathLike[str] | None = None,
    ) -> Result:
        """Run the case through to its result.

        Args:
            progress: show a bar, by tqdm where it is installed, otherwise by log messages.
            threads: number of threads; one for small frames, else as many as there are processors if not given.
            out: folder for the results, with the same files as the command writes; kept in memory if not given.
            resume: folder, or partial result, of a run that was interrupted, to go on with.
            laws: wear laws by the name of their body: ``f(p, s, **columns) -> depth (m)``, or a :class:`Law`.
                They take the place of the ones in the case.
            friction: a friction law: ``f(p) -> limit (Pa)``, the largest traction under pressures p (Pa). It
                takes the place of the one in the case.
            on_step: called with every :class:`State`, the initial contact first.
            force: whether results of another case in the folder are replaced.
            cache: where compliances of meshed bodies are kept; the user's folder of caches if not given.

        Raises:
            CaseError: all that is wrong with the case.
            NotConverged: a step did not converge.
            RunError: the run stopped before its end for another reason.
            WrongResult: the verdict on the result is that it is wrong.
            KeyboardInterrupt: Ctrl-C. This and whatever a law or ``on_step`` raises have the partial result
                as their attribute ``result``, as the errors above do.

        """
        from archard.run import Run, solve

        stepped = resume is not None or laws or friction is not None or on_step is not None
        if stepped and len(self._tree.get("body", {})) == 1:
            raise ValueError("a body by itself is solved at once: it has no steps and no laws")
        if self._compiled_check(laws, friction).elastic:
            return solve(self, threads=threads, out=out, force=force)
        run = Run(
            self,
            threads=threads,
            out=out,
            resume=resume,
            laws=laws,
            friction=friction,
            force=force,
            cache=cache,
        )
        return run.through(progress=progress, on_step=on_step)

    def steps(
        self,
        *,
        threads: int | None = None,
        out: str | os.PathLike[str] | None = None,
        resume: str | os.PathLike[str] | Result | None = None,
        laws: Mapping[str, WearFunction | Law] | None = None,
        friction: FrictionFunction | None = None,
        force: bool = False,
        cache: str | os.PathLike[str] | None = None,
    ) -> Run:
        """Return the run to be stepped, ``for state in case.steps(): ...``; arguments as of :meth:`run`."""
        from archard.run import Run

        self._compiled_check(laws, friction)
        return Run(
            self,
            threads=threads,
            out=out,
            resume=resume,
            laws=laws,
            friction=friction,
            force=force,
            cache=cache,
        )

    def _in(self, folder: Path) -> Case:
        """Return the case with the arrays of its surfaces as files in a folder, which its results keep."""
        case = self.copy()
        for key, path in _toml.leaves(self._tree):
            if isinstance(path, str) and path in self._held:
                case[key] = _surface.write(self._held[path], folder.absolute())
        return case

    def _lay(self, key: str, text: str) -> None:
        """Do to the tree what an option does to the case."""
        *names, last = _toml.path(key)
        table: Any = self._tree
        for name in names:
            table = table.setdefault(name, {}) if isinstance(table, dict) else None
        if not isinstance(table, dict):
            raise KeyError(f"{key}: nothing can be set inside a value")
        if text:
            table[last] = _toml.read(f"value = {text}")["value"]
        else:
            table.pop(last, None)

    def _compiled(self, *options: str) -> _archard.CaseFile:
        return _archard.CaseFile(self._name, self._text, self._folder, [*self._options, *options])

    def _with_laws(self, laws: Mapping[str, Any] | None, friction: FrictionFunction | None) -> _archard.CaseFile:
        """Return the case; for a wear law that is a function stands Archard's with a coefficient of zero."""
        bodies = self._tree.get("body", {})
        for body in laws or {}:
            if body not in bodies:
                known = ", ".join(f"`{name}`" for name in bodies)
                raise ValueError(f"laws: no body is called `{body}`; there are {known}")
        if friction is not None and "friction" not in self._tree:
            raise ValueError(
                "friction: the case has no `friction` table; give it one, whose law the function replaces"
            )
        stand_in = '.wear={ archard = { coefficient = "0 1/Pa" } }'
        return self._compiled(*(f"body.{_toml.key(body)}{stand_in}" for body in laws or {}))

    def _compiled_check(
        self, laws: Mapping[str, Any] | None, friction: FrictionFunction | None
    ) -> _archard.Checked:
        """Check the case as it is run, and warn of what is doubtful."""
        checked = self._with_laws(laws, friction).check()
        for problem in checked.warnings:
            warnings.warn(str(Problem(*problem)), CaseWarning, stacklevel=3)
        return checked


def _file(source: str | os.PathLike[str]) -> Path:
    """The file of a case: a plain name is that of a built-in one."""
    path = Path(source)
    built_in = _CASES / str(source) / "case.toml"
    if isinstance(source, str) and os.path.basename(source) == source and built_in.is_file():
        if path.exists():
            message = f"`{source}` is the built-in case; the file of that name is Path({source!r})"
            warnings.warn(message, CaseWarning, stacklevel=3)
        return built_in
    if path.is_dir():
        path = path / "case.toml"
    if not path.is_file():
        near = difflib.get_close_matches(str(source), cases(), n=3)
        hint = f"; did you mean {' or '.join(map(repr, near))}?" if near else ""
        raise FileNotFoundError(f"no case file and no built-in case: `{source}`{hint}")
    return path
