"""One contact, solved once: pressures, gaps and tractions as arrays."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from archard import _archard
from archard.case import Case

Array = NDArray[np.float64]


class Derivative(NamedTuple):
    """Derivative of a contact by its load (N; of a line N/m), or by a parameter of the shape (in its unit)."""

    pressure: Array
    """Of the pressure (Pa over the unit), shaped like it."""
    approach: float
    """Of the approach (m over the unit), from the first touch of the bodies as they are."""


@dataclass(frozen=True)
class Contact:
    """A contact that was solved; all in SI.

    Fields have a value for each pair: on a grid in rows along x, the first of the lowest y; on a mesh one after
    the other.
    """

    x: Array
    """Places (m) of the pairs along x."""
    y: Array
    """Places (m) of the pairs along y."""
    pressure: Array
    """Normal pressure (Pa)."""
    gap: Array
    """Normal gap (m), zero in contact."""
    traction: tuple[Array, Array] | None
    """Tractions of friction (Pa) on body 1 along x and y; ``None`` without friction."""
    approach: float
    """Approach (m) of the bodies from first touch."""
    load: float
    """Normal force (N)."""
    area: float
    """Area (m^2) under pressure."""
    force: tuple[float, float]
    """Force of friction (N) on body 1 along x and y."""
    _inside: tuple[_archard.Inside, ...] = field(repr=False, compare=False)

    @property
    def peak_pressure(self) -> float:
        """Largest pressure (Pa) of a pair."""
        return float(self.pressure.max())

    def by_load(self) -> Derivative:
        """Return the derivative by the load, from one more solve; exact for the elements.

        Raises:
            RunError: if the solve does not converge.
            ValueError: where pairs yield or lose pressure as the load grows, where friction moves the pressures,
                and on conforming surfaces.

        """
        return self._derivative(_archard.by_load(self._inside[0]))

    def by_shape(self, gap: ArrayLike) -> Derivative:
        """Return the derivative by a parameter of the shape, at the same load, to the root of the tolerance.

        Args:
            gap: the derivative of the gap by it (m over its unit), positive where bodies part, shaped as the
                pressure: by the radius of a ball ``-(x**2 + y**2) / (2 * radius**2)``, by the distance that bodies
                wear over ``k * contact.pressure``.

        Raises:
            RunError: if the solve does not converge.
            ValueError: where :meth:`by_load` is not known, and if the gap is shaped otherwise.

        """
        values = np.asarray(gap, dtype=float)
        if values.shape != self.pressure.shape or not np.isfinite(values).all():
            raise ValueError(f"the gap is an array of finite values of shape {self.pressure.shape}")
        return self._derivative(_archard.by_shape(self._inside[0], values.ravel().tolist()))

    def _derivative(self, found: tuple[Array, float] | None) -> Derivative:
        if found is None:
            raise ValueError(
                "derivatives are not known where pairs yield or lose pressure as the load grows, "
                "where friction moves the pressures, and on conforming surfaces"
            )
        pressure, approach = found
        return Derivative(pressure.reshape(self.pressure.shape), approach)

    def stress_at(self, points: ArrayLike, body: str) -> Array:
        """Return the stresses (Pa) at places in a half-space: xx, yy, zz, xy, xz, yz, positive in tension.

        Args:
            points: x, y and z (m) of each place, z negative in the body.
            body: the body's name in the case.

        The result has a row of six a place. It is exact for the tractions of the elements; a run with
        ``output.stress`` says how far these are off.

        Raises:
            ValueError: if the body is rigid, meshed or none of this contact, or a place lies above its surface or
                where pressures beyond the frame count.

        """
        places = np.atleast_2d(np.asarray(points, dtype=float))
        if places.ndim != 2 or places.shape[1] != 3 or not np.isfinite(places).all():
            raise ValueError(f"points are rows of x, y and z in m, not an array of shape {np.shape(points)}")
        return self._body(body).at(places.tolist())

    def stress(self, depth: float, body: str) -> Array:
        """Return the stresses (Pa) in a plane below all pairs of a grid, of shape (6, ny, nx).

        Components and errors are those of :meth:`stress_at`; NaN where pressures beyond the frame count.

        Args:
            depth: how deep the plane lies (m).
            body: the body's name in the case.

        """
        if not (np.isfinite(depth) and depth >= 0):
            raise ValueError(f"a depth in m is not negative, not {depth!r}")
        return self._body(body).plane(float(depth)).reshape(6, *self.pressure.shape)

    def _body(self, name: str) -> _archard.Inside:
        for own in self._inside:
            if own.name == name:
                return own
        names = " and ".join(repr(own.name) for own in self._inside)
        raise ValueError(f"no body {name!r} in this contact, which is between {names}")

    def __repr__(self) -> str:
        return (
            f"Contact(load={self.load:.6g} N, approach={self.approach:.6g} m, "
            f"peak_pressure={self.peak_pressure:.6g} Pa, area={self.area:.6g} m^2)"
        )


def contact(
    case: str | os.PathLike[str] | Mapping[str, Any] | Case,
    *,
    load: object | None = None,
    approach: object | None = None,
) -> Contact:
    """Solve the contact of a case before any wear.

    Bodies that roll, or fret from the beginning, do so with their friction; all others are pressed together by
    the load or approach of their motion.

    Args:
        case: what :class:`Case` takes. With a load or an approach it needs no ``motion``.
        load: normal force with its unit, as ``"10 N"``; the bodies are pressed together by it and not moved.
        approach: approach of the bodies from first touch with its unit, instead.

    What is doubtful about the case is a :class:`CaseWarning`, as of a run.

    Raises:
        CaseError: all that is wrong with the case.
        RunError: if a solve does not converge, or the contact fills the frame.
        ValueError: if both a load and an approach are given, or friction depends on the way to the load.

    >>> import archard
    >>> steel = {"material": {"young": "210 GPa", "poisson": 0.3}}
    >>> ball = {**steel, "profile": {"sphere": {"radius": "50 mm"}}}
    >>> flat = {**steel, "profile": {"flat": {}}}
    >>> frame = {"size": ["0.36 mm", "0.36 mm"], "elements": [48, 48]}
    >>> solved = archard.contact({"body": {"ball": ball, "flat": flat}, "frame": frame}, load="10.2 N")
    >>> round(solved.peak_pressure / 1e6), solved.pressure.shape
    (219, (48, 48))
    >>> f"{1 / solved.by_load().approach:.3g} N/m"
    '3.45e+07 N/m'

    """
    if load is not None and approach is not None:
        raise ValueError("load and approach exclude each other: keep one")
    own = Case(case)
    pressed = {"load": load} if load is not None else {"approach": approach}
    if load is not None or approach is not None:
        for key in ("motion", "friction", "output", "accuracy"):
            if key in own:
                del own[key]
        own["motion"] = {"indentation": pressed}
    own._compiled_check(None, None)
    elements, fields, values, inside = _archard.solve_contact(own._compiled())
    found, known = dict(fields), dict(values)
    if elements is not None:
        found = {name: field.reshape(elements[1], elements[0]) for name, field in found.items()}
    traction = (found["traction_x"], found["traction_y"]) if "traction_x" in found else None
    return Contact(
        x=found["x"],
        y=found["y"],
        pressure=found["pressure"],
        gap=found["gap"],
        traction=traction,
        approach=known["approach"],
        load=known["load"],
        area=known["area"],
        force=(known["force_x"], known["force_y"]),
        _inside=tuple(inside),
    )
