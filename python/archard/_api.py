"""What a user of the package has: :mod:`archard` loads it where a name is first asked for."""

from archard import cams, gears, rail
from archard._archard import __version__
from archard._compare import Comparison
from archard._contact import Contact, contact
from archard._difference import Difference, Uncertain, difference
from archard._errors import (
    ArchardWarning,
    CaseError,
    CaseWarning,
    NotConverged,
    Problem,
    ResultWarning,
    RunError,
    WrongResult,
)
from archard._fit import Coefficient, Exponent, Fit, fit
from archard._known import Key, KnownLaw, Material, laws, materials
from archard._law import Law
from archard._snapshot import Snapshot
from archard._surface import Surface, surface
from archard._sweep import Row, Sweep, sweep
from archard._table import Table
from archard._tribometer import read_log
from archard._validate import Prediction, Validation, validate
from archard.case import Case, Forecast, cases
from archard.result import Profile, Result, Verdict
from archard.result import open as open  # Not in the list below: a star must not replace the one of Python.
from archard.run import Run, State

__all__ = [
    "ArchardWarning",
    "Case",
    "CaseError",
    "CaseWarning",
    "Coefficient",
    "Comparison",
    "Contact",
    "Difference",
    "Exponent",
    "Fit",
    "Forecast",
    "Key",
    "KnownLaw",
    "Law",
    "Material",
    "NotConverged",
    "Prediction",
    "Problem",
    "Profile",
    "Result",
    "ResultWarning",
    "Row",
    "Run",
    "RunError",
    "Snapshot",
    "State",
    "Surface",
    "Sweep",
    "Table",
    "Uncertain",
    "Validation",
    "Verdict",
    "WrongResult",
    "__version__",
    "cams",
    "cases",
    "contact",
    "difference",
    "fit",
    "gears",
    "laws",
    "materials",
    "rail",
    "read_log",
    "surface",
    "sweep",
    "validate",
]
