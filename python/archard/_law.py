"""Laws of wear and friction as Python functions."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from archard._log import log

Array = NDArray[np.float64]
WearFunction = Callable[..., ArrayLike | tuple[ArrayLike, ArrayLike]]
FrictionFunction = Callable[[Array], ArrayLike]


class Law(NamedTuple):
    """A wear law: ``f(p, s, **columns) -> depth`` or ``-> (depth, slope)``.

    ``p`` (Pa) and ``s`` (m) are arrays of pressures and of distances slid while the step lasts; the function
    returns the depth (m) of each point and, if it can, its derivative with respect to the pressure (m/Pa), the
    work of friction following its limit. Without, differences do. Further arguments without a default are
    columns by their names:

    - ``work``: work of friction on that slip (J/m^2); ``mu``: coefficient of friction
    - ``v``: speed of sliding (m/s); ``rolled``: distance rolled meanwhile (m)
    - ``temperature``: of the surfaces (K); ``cs``: share of the slip of a cycle across its main direction
    - ``distance``, ``worn``: distance slid (m) and depth worn (m) there before
    - ``slip_vector``, ``traction``: slip of body 2 over body 1 (m) and traction on body 1 (Pa), shape (2, n)

    With ``**columns`` it gets all that the case has but the temperature. A law is tried before the run: its depth
    has to be finite, not negative, zero without pressure or slip, must not fall as the pressure grows and, per
    increment, has to be in proportion to the slip. Points are independent of each other: a call may be for one, or
    any number of them.
    """

    function: WearFunction
    """The function."""
    per: Literal["increment", "cycle"] = "increment"
    """What it takes at once: any part of a motion, or a whole cycle of it."""


def given(body: str, law: WearFunction | Law) -> tuple[str, WearFunction, str, list[str] | None, bool]:
    """A law as the compiled part takes it."""
    law = law if isinstance(law, Law) else Law(law)
    if not callable(law.function):
        raise TypeError(f"the wear law of `{body}` is no function: {law.function!r}")
    if law.per not in ("increment", "cycle"):
        raise ValueError(f'the wear law of `{body}` takes an "increment" or a "cycle", not {law.per!r}')
    function = law.function
    return body, _by_name(function), name(function), _columns(function), law.per == "cycle"


def remark(laws: Mapping[str, WearFunction | Law] | None, friction: FrictionFunction | None) -> str:
    """What the case in a result folder says of laws that are functions."""
    named = [(body, given(body, law)[2]) for body, law in (laws or {}).items()]
    lines = [f"wear of `{body}`: the Python function `{function}`" for body, function in named]
    if friction is not None:
        lines.append(f"friction: the Python function `{name(friction)}`")
    return "".join(f"# {line}; not in this file.\n" for line in lines)


def name(function: Callable[..., Any]) -> str:
    """What a function is called."""
    function = _written(function)
    found = getattr(function, "__qualname__", None) or type(function).__qualname__
    return str(found)


def _columns(function: Callable[..., Any]) -> list[str] | None:
    """The arguments after pressure and slip; ``None`` for all there are."""
    try:
        parameters = list(inspect.signature(_written(function)).parameters.values())
    except (TypeError, ValueError):  # compiled functions
        return []
    if any(one.kind is one.VAR_KEYWORD for one in parameters):
        return None
    named = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return [one.name for one in parameters[2:] if one.kind in named and one.default is one.empty]


def _written(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function in Python that a compiled one was made of, where it tells, as those of numba do."""
    for holder in (function, getattr(function, "_dispatcher", None)):
        written = getattr(holder, "py_func", None)
        if callable(written):
            return written  # type: ignore[no-any-return]
    return function


def _by_name(function: WearFunction) -> WearFunction:
    """The function, which takes its columns by their names; ufuncs take them by their place."""
    columns = _columns(function) if hasattr(function, "nin") else None
    if not columns:
        return function
    return lambda p, s, **given: function(p, s, *(given[one] for one in columns))


#: Pressures (Pa) between which friction is sampled, and the error it is sampled to, relative.
_LEAST, _MOST, _ERROR = 1.0, 1e12, 1e-9
_START, _ROUNDS, _POINTS = 241, 40, 20_000


def sampled(function: FrictionFunction) -> tuple[list[float], list[float], float]:
    """Limits of friction at rising pressures, straight lines between which meet the function, and how well.

    Intervals are halved until the limit in their middle is met to 1e-9, or there are 20,000 points. Below 1 Pa and
    above 1 TPa the coefficient of friction is held.
    """
    pressures = np.geomspace(_LEAST, _MOST, _START)
    limits = _limit(function, pressures)
    worst = 0.0
    for _ in range(_ROUNDS):
        middle = 0.5 * (pressures[1:] + pressures[:-1])
        found = _limit(function, middle)
        straight = 0.5 * (limits[1:] + limits[:-1])
        error = np.abs(found - straight) / np.maximum(found, np.finfo(float).tiny)
        worst = float(error.max())
        coarse = np.flatnonzero(error > _ERROR)
        if not coarse.size or pressures.size + coarse.size > _POINTS:
            break
        pressures = np.insert(pressures, coarse + 1, middle[coarse])
        limits = np.insert(limits, coarse + 1, found[coarse])
    falls = np.flatnonzero(np.diff(limits) < -1e-9 * limits[1:])
    if falls.size:
        raise ValueError(
            f"the friction law `{name(function)}` falls as the pressure grows, beyond {pressures[falls[0]]:g} Pa"
        )
    log.info("friction of %s by %d points, error %.1e", name(function), pressures.size, worst)
    return pressures.tolist(), np.maximum.accumulate(limits).tolist(), worst


def _limit(function: FrictionFunction, pressures: Array) -> Array:
    returned = function(pressures.copy())
    if np.ma.is_masked(returned):
        raise ValueError(
            f"the friction law `{name(function)}` returned masked points, which have no limit; "
            "fill them, as by `.filled(0.0)`"
        )
    limit = np.asarray(returned, dtype=float)
    if limit.shape != pressures.shape:
        raise ValueError(
            f"the friction law `{name(function)}` returned an array of shape {limit.shape}; "
            f"one limit a pressure has shape {pressures.shape}"
        )
    wrong = ~np.isfinite(limit) | (limit < 0.0)
    if wrong.any():
        at = int(np.argmax(wrong))
        raise ValueError(
            f"the friction law `{name(function)}` returned {limit[at]:g} Pa at {pressures[at]:g} Pa; "
            "a limit is finite and not negative"
        )
    return limit
