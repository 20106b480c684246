"""The compiled part of `archard`."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "UNITS",
    "CaseFile",
    "Checked",
    "Inside",
    "Run",
    "WheelRail",
    "__version__",
    "by_load",
    "by_shape",
    "command",
    "comparison",
    "fit",
    "free_memory",
    "knows_unit",
    "laws",
    "materials",
    "next_tests",
    "numbers",
    "page",
    "pictures",
    "quantity",
    "read_fields",
    "read_log",
    "read_surface",
    "scan_difference",
    "solve_contact",
    "solve_elastic",
    "validate",
    "verify",
    "wear_cam",
    "wear_gears",
]
__version__: str
UNITS: list[str]

def command(words: Sequence[str]) -> int: ...

_Told = tuple[str, str, str, str | None, str]
_Arrays = dict[str, NDArray[np.float64]]
_Given = tuple[str, Any, str, list[str] | None, bool]

@final
class CaseFile:
    """A case as written."""

    def __new__(cls, name: str, text: str, folder: str | PathLike[str], options: Sequence[str]) -> CaseFile: ...
    def check(self) -> Checked: ...

@final
class Inside:
    """A body of a contact below its surface."""

    @property
    def name(self) -> str: ...
    def at(self, places: Sequence[Sequence[float]]) -> NDArray[np.float64]: ...
    def plane(self, depth: float) -> NDArray[np.float64]: ...

@final
class Checked:
    """A case that passed every check."""

    @property
    def toml(self) -> str: ...
    def is_kept(self, toml: str) -> bool: ...
    def expectations(self) -> str: ...
    @property
    def warnings(self) -> list[_Told]: ...
    @property
    def elastic(self) -> bool: ...

@final
class Run:
    """A run and its result folder."""

    def __new__(
        cls,
        file: CaseFile,
        folder: str | PathLike[str],
        *,
        threads: int | None,
        resume: bool,
        force: bool,
        cache: str | PathLike[str] | None,
        laws: Sequence[_Given],
        friction: tuple[Sequence[float], Sequence[float]] | None,
        remark: str,
    ) -> Run: ...
    @property
    def doubts(self) -> list[str]: ...
    @property
    def threads(self) -> int: ...
    def step(self) -> bool: ...
    def keep(self) -> None: ...
    def state(self) -> tuple[list[tuple[str, float]], tuple[_Arrays, _Arrays]]: ...
    def progress(self) -> tuple[float, float]: ...
    def close(self) -> None: ...
    def finish(self, failure: str | None = None) -> None: ...

@final
class WheelRail:
    """A wheel over its rail."""

    def __new__(cls, file: CaseFile) -> WheelRail: ...
    def contact(self, values: list[tuple[str, float]]) -> list[tuple[str, list[tuple[str, float]]]]: ...
    def travel(
        self, route: list[tuple[str, list[float]]] | None, threads: int | None
    ) -> tuple[
        list[tuple[tuple[int, bool] | None, tuple[str, list[tuple[str, float]]]]],
        list[tuple[str, list[tuple[str, float]]]],
        list[tuple[str, str, list[tuple[str, list[float]]]]],
    ]: ...

def wear_cam(file: CaseFile) -> tuple[list[list[list[tuple[str, float]]]], tuple[str, float] | None]: ...
def wear_gears(file: CaseFile) -> tuple[list[list[list[tuple[str, float]]]], tuple[str, float] | None]: ...
def read_fields(name: str, bytes: bytes) -> tuple[_Arrays, _Arrays]: ...
def by_load(inside: Inside) -> tuple[NDArray[np.float64], float] | None: ...
def by_shape(inside: Inside, gap: list[float]) -> tuple[NDArray[np.float64], float] | None: ...
def solve_contact(
    file: CaseFile,
) -> tuple[
    tuple[int, int] | None, list[tuple[str, NDArray[np.float64]]], list[tuple[str, float]], list[Inside]
]: ...
def solve_elastic(file: CaseFile, folder: str | PathLike[str], *, threads: int | None, force: bool) -> None: ...
def fit(
    case: CaseFile,
    table: tuple[str, bytes, str | PathLike[str]],
    columns: Sequence[tuple[str, str]],
    parameters: list[str],
    told: tuple[Sequence[tuple[str, float]], Sequence[str]],
    dir: str | PathLike[str],
) -> tuple[str, str, str]: ...
def next_tests(
    coefficients: Sequence[tuple[float, float, float]], correlation: float, points: Sequence[Sequence[float]]
) -> list[list[float]]: ...
def validate(folder: str | PathLike[str], dir: str | PathLike[str]) -> list[tuple[str, str]]: ...
def read_log(
    file: str | PathLike[str], columns: Sequence[tuple[str, str]], values: Sequence[tuple[str, str]]
) -> str: ...
def read_surface(
    file: CaseFile,
) -> tuple[NDArray[np.float64], tuple[float, float], list[tuple[str, float]]]: ...
def scan_difference(
    files: Sequence[CaseFile], names: Sequence[str], options: tuple[str | None, float, bool]
) -> tuple[list[str], str, NDArray[np.float64], NDArray[np.int8], tuple[float, float]]: ...

_Options = tuple[Sequence[str], str | None, bool, str | PathLike[str]]

def page(
    dir: str | PathLike[str], others: Sequence[str | PathLike[str]], output: str | PathLike[str], options: _Options
) -> PathLike[str]: ...
def comparison(
    dir: str | PathLike[str], others: Sequence[str | PathLike[str]], options: _Options
) -> tuple[list[str], str]: ...
def verify(dir: str | PathLike[str]) -> None: ...
def knows_unit(symbol: str) -> bool: ...
def pictures(dir: str | PathLike[str]) -> str: ...
def numbers(dir: str | PathLike[str]) -> tuple[str, list[str], list[list[str]]]: ...
def quantity(value: float, unit: str) -> str: ...
def free_memory() -> float: ...
def materials() -> list[
    tuple[str, str, str, tuple[float, float, float], tuple[float | None, float | None, float | None]]
]: ...
def laws() -> list[tuple[str, str, list[tuple[str, str, str, bool]], str, str]]: ...
