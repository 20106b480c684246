"""Cases that say how accurate they have to be."""

from __future__ import annotations

import pytest

import archard

PIN = {
    "accuracy": 0.05,
    "body": {
        "pin": {
            "material": {"young": "210 GPa", "poisson": 0.3},
            "profile": {"sphere": {"radius": "50 mm"}},
            "wear": {"archard": {"coefficient": "1.33e-13 1/Pa"}},
        },
        "disc": {"material": {"young": "210 GPa", "poisson": 0.3}, "profile": {"flat": {}}},
    },
    "motion": {"sliding": {"load": "10.2 N", "distance": "100 mm"}},
}


def test_errors_stand_beside_the_results() -> None:
    """The history has them in the unit of each column; they are what was asked for."""
    history = archard.Case(PIN).run().history
    depth = history["wear_depth_m"][-1]
    error = sum(history[f"{kind}_error_of_wear_depth_m"][-1] for kind in ("time", "space"))
    assert 0 < error < 0.05 * depth
    assert 0 < history["space_error"][-1] < 0.05


def test_what_knows_no_accuracy_says_so() -> None:
    """Laws in Python and studies take cases with a frame."""
    with pytest.raises(ValueError, match="leave the `accuracy` out"):
        archard.Case(PIN).run(laws={"pin": lambda p, s: 1e-13 * p * s})
    with pytest.raises(ValueError, match="with an `accuracy`"):
        archard.sweep(PIN, {"motion.sliding.load": ["5 N", "10 N"]})
