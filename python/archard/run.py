"""Runs: a case carried through, state by state."""

from __future__ import annotations

import contextlib
import importlib
import logging
import os
import tempfile
import warnings
import weakref
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from archard import _archard, _law
from archard._errors import ArchardWarning, ResultWarning, RunError, WrongResult
from archard._log import log
from archard._snapshot import Snapshot
from archard.case import Case
from archard.result import Result, read


class State(Snapshot):
    """What is known at the end of a step: fields, and the row of the history."""

    row: dict[str, float]
    """The columns of the history; each ends in its unit."""

    def __init__(self, row: dict[str, float], places: dict[str, Any], fields: dict[str, Any]) -> None:
        progress = next(iter(row))
        super().__init__(row[progress], places, fields)
        self.row = row


class Run:
    """A run under way: an iterator over its states, the initial contact first.

    :meth:`result` finishes it, wherever it is.
    """

    def __init__(
        self,
        case: Case,
        *,
        threads: int | None = None,
        out: str | os.PathLike[str] | None = None,
        resume: str | os.PathLike[str] | Result | None = None,
        laws: Mapping[str, Any] | None = None,
        friction: _law.FrictionFunction | None = None,
        force: bool = False,
        cache: str | os.PathLike[str] | None = None,
    ) -> None:
        self._case = repr(case)
        self._temporary: tempfile.TemporaryDirectory[str] | None = None
        self._result: Result | None = None
        self._failure: BaseException | None = None
        self._ended = False
        functions = [_law.given(body, law) for body, law in (laws or {}).items()]
        samples = None
        if friction is not None:
            pressures, limits, error = _law.sampled(friction)
            samples = (pressures, limits)
            if error > _COARSE:
                message = f"friction: lines between {len(pressures)} points are {error:.1e} off the function"
                warnings.warn(message, ArchardWarning, stacklevel=4)
        self._folder = _folder(case, self, out, resume)
        try:
            file = case._in(self._folder)._with_laws(laws, friction)
            self._run = _archard.Run(
                file,
                self._folder,
                threads=threads,
                resume=resume is not None,
                force=force,
                cache=_cache(cache),
                laws=functions,
                friction=samples,
                remark=_law.remark(laws, friction),
            )
        except BaseException:
            self._clean()
            raise
        # Wherever a run is left, it ends its writer before its folder goes.
        self._end = weakref.finalize(self, _given_up, self._run, self._temporary)
        for doubt in self._run.doubts:
            warnings.warn(doubt, ArchardWarning, stacklevel=4)
        log.info("%r begins with %d threads", case, self._run.threads)

    def __iter__(self) -> Iterator[State]:
        return self

    def __next__(self) -> State:
        if not self._advance():
            raise StopIteration
        return self.state

    @property
    def state(self) -> State:
        """The present state."""
        row, (places, fields) = self._run.state()
        return State(dict(row), places, fields)

    def through(self, *, progress: bool = False, on_step: Callable[[State], object] | None = None) -> Result:
        """Go on to the end of the motion; see :meth:`Case.run`."""
        try:
            with bar(progress) as show:
                while self._advance():
                    show(*self._run.progress())
                    if on_step is not None:
                        on_step(self.state)
        except BaseException as error:
            self._fail(error)
            raise
        result = self._told(stacklevel=4)
        if result.verdict.word == "wrong":
            raise _wrong(result)
        return result

    def result(self) -> Result:
        """Finish the run and return its result; one that is not at its end is incomplete, and says so."""
        return self._told(stacklevel=3)

    def _told(self, stacklevel: int) -> Result:
        """Return the result, with a warning where it is doubtful."""
        if self._result is None:
            if self._ended:
                self._finish(None)
            else:
                self._run.keep()
                self._finish("stopped")
        assert self._result is not None
        if not self._result.complete or self._result.verdict.word == "doubtful":
            warnings.warn(self._result.doubt, ResultWarning, stacklevel=stacklevel)
        return self._result

    def _advance(self) -> bool:
        if self._failure is not None or self._result is not None:
            raise RuntimeError("the run is over") from self._failure
        try:
            went = self._run.step()
        except BaseException as error:
            self._fail(error)
            raise
        self._ended = not went
        return went

    def _fail(self, error: BaseException) -> None:
        """Finish what there is of a run that failed, and hang it on the error."""
        if self._failure is not None:
            return
        self._failure = error
        cause = "interrupted" if isinstance(error, KeyboardInterrupt) else _cause(error)
        with contextlib.suppress(OSError, RunError):
            self._run.keep()
            self._finish(cause)
        with contextlib.suppress(AttributeError):
            error.result = self._result  # type: ignore[attr-defined]
        if hasattr(error, "add_note"):
            error.add_note("what was computed so far is in the attribute `result` of this exception")

    def _finish(self, failure: str | None) -> None:
        try:
            self._run.finish(failure)
            self._result = read(self._folder, keep=self._temporary is not None)
        finally:
            self._clean()
        summary = self._result.summary
        log.info("%s ends after %.2f s, %d steps", self._case, summary["seconds"], summary["steps"])
        _tell(self._case, self._result)

    def _clean(self) -> None:
        if self._temporary is not None:
            self._temporary.cleanup()


def _given_up(run: _archard.Run, temporary: tempfile.TemporaryDirectory[str] | None) -> None:
    run.close()
    if temporary is not None:
        temporary.cleanup()


#: Error of sampled friction, relative to the limit, that is worth a warning.
_COARSE = 1e-6


def solve(case: Case, *, threads: int | None, out: str | os.PathLike[str] | None, force: bool) -> Result:
    """Solve a body by itself."""
    with tempfile.TemporaryDirectory(prefix="archard-") as temporary:
        folder = Path(temporary if out is None else out)
        _keep_the_case(case, folder)
        _archard.solve_elastic(case._compiled(), folder, threads=threads, force=force)
        result = read(folder, keep=out is None)
    _tell(repr(case), result)
    if result.verdict.word == "wrong":
        raise _wrong(result)
    if result.verdict.word == "doubtful":
        warnings.warn(result.doubt, ResultWarning, stacklevel=3)
    return result


def _tell(case: str, result: Result) -> None:
    """Log what is to be thought of a result; what is doubtful about it is a warning besides."""
    verdict = result.verdict
    log.info("%s: the result is %s (%d checks)", case, verdict.word, len(verdict.lines))
    for line in verdict.lines:
        log.debug("%s: %s %.3g %s (%s)", case, line["subject"], line["value"], line["text"], line["word"])


def _folder(
    case: Case,
    run: Run,
    out: str | os.PathLike[str] | None,
    resume: str | os.PathLike[str] | Result | None,
) -> Path:
    """The folder of a run: the one given, the one it goes on in, or one for the time of the run."""
    if resume is not None and not isinstance(resume, Result):
        if out is not None:
            raise ValueError("a run goes on in its own folder: give `resume` without `out`")
        if not Path(resume).is_dir():
            raise FileNotFoundError(f"no folder to go on in: `{resume}`")
        return Path(resume)
    if out is None:
        run._temporary = tempfile.TemporaryDirectory(prefix="archard-")
        folder = Path(run._temporary.name)
    else:
        folder = Path(out)
        _keep_the_case(case, folder)
    if isinstance(resume, Result):
        resume.save(folder)
    return folder


def _keep_the_case(case: Case, folder: Path) -> None:
    written, source = folder / "case.toml", Path(case._name)
    if written.exists() and source.exists() and written.samefile(source):
        raise FileExistsError(f"the results would overwrite the case `{source}`")


def _cache(cache: str | os.PathLike[str] | None) -> Path | None:
    given = cache if cache is not None else os.environ.get("ARCHARD_CACHE")
    return Path(given) if given else None


def _wrong(result: Result) -> WrongResult:
    error = WrongResult(f"the result is wrong: {result.verdict.wrong}")
    error.result = result
    return error


def _cause(error: BaseException) -> str:
    lines = str(error).splitlines()
    kind = "" if isinstance(error, RunError) else f"{type(error).__name__}: "
    return f"{kind}{lines[0] if lines else ''}"


@contextlib.contextmanager
def bar(progress: bool) -> Iterator[Callable[[float, float], object]]:
    """A bar where it is asked for and can be had; log messages otherwise."""
    try:
        tqdm = importlib.import_module("tqdm.auto").tqdm if progress else None
    except ImportError:
        tqdm = None
    if tqdm is None:
        yield lambda done, extent: log.log(
            logging.INFO if progress else logging.DEBUG, "at %g of %g", done, extent
        )
        return
    with tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}<{remaining}") as bar:

        def show(done: float, extent: float) -> None:
            bar.n = 100.0 * done / extent if extent > 0.0 else 100.0
            bar.refresh() if done >= extent else bar.update(0)

        yield show
