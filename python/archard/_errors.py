"""What can be wrong with a case, a run or its result."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from archard.result import Result


class Problem(NamedTuple):
    """One thing that is wrong with a case, or doubtful."""

    severity: str
    """``"error"`` or ``"warning"``."""
    key: str
    """The dotted key it is about; empty where the text is not TOML."""
    message: str
    """What is wrong."""
    help: str | None
    """What to do about it, where that is known."""
    place: str
    """Where it stands: the file and its line, or the value that was set."""

    def __str__(self) -> str:
        key = f"`{self.key}`: " if self.key else ""
        help = f"\n    help: {self.help}" if self.help else ""
        return f"{self.severity}: {key}{self.message} ({self.place}){help}"


class CaseError(ValueError):
    """A case that cannot be run, with all that is wrong with it in :attr:`problems`."""

    def __init__(self, problems: Iterable[tuple[str, str, str, str | None, str]]) -> None:
        self.problems = [Problem(*problem) for problem in problems]
        super().__init__("\n".join(map(str, self.problems)))

    def __reduce__(self) -> tuple[type, tuple[list[Problem]]]:
        return type(self), (list(self.problems),)


class RunError(RuntimeError):
    """A run that stopped before its end; :attr:`result` has what was computed until then."""

    result: Result | None = None


class NotConverged(RunError):
    """A solve or a step did not converge, or came out as no number."""


class WrongResult(RunError):
    """A run that came to its end with a result that cannot be right; its verdict says why."""


class ArchardWarning(UserWarning):
    """Anything doubtful."""


class CaseWarning(ArchardWarning):
    """A case that may not be as it was meant."""


class ResultWarning(ArchardWarning):
    """A result that is doubtful, wrong or incomplete."""
