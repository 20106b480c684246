"""Laws of wear and friction as Python functions, against the native ones."""

import functools

import numpy as np
import pytest

import archard
from archard import _law

K = 1.33e-13


def archard_law(p, s):
    return K * p * s


def with_slope(p, s):
    return K * p * s, K * s


def close(one, other, tolerance):
    for name in ("wear_depth_pin_m", "peak_pressure_Pa", "approach_m", "load_N"):
        np.testing.assert_allclose(one.history[name], other.history[name], rtol=tolerance)


@pytest.mark.parametrize("law", [archard_law, with_slope, functools.partial(archard_law)])
def test_archard_is_archard(case, law):
    """Steps are solved to 1e-9; differences of a straight line are exact but for rounding."""
    close(case.run(laws={"pin": law}), case.run(), 1e-7)


def test_slopes_follow_from_the_depth():
    """A law that is not straight gives the same with its slope and without."""
    case = archard.Case("pin_on_disc")
    del case["accuracy"]
    case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [24, 24]}
    case["motion.sliding"] = {"load": "10.2 N", "distance": "20 mm", "step": "5 mm"}
    case["body.pin.wear"] = {"expression": {"depth": "k*p0*s*(p/p0)^1.4", "k": "1.33e-13 1/Pa", "p0": "200 MPa"}}

    def law(p, s):
        return K * 2e8 * s * (p / 2e8) ** 1.4

    def steep(p, s):
        return law(p, s), 1.4 * K * s * (p / 2e8) ** 0.4

    native = case.run()
    close(case.run(laws={"pin": law}), native, 1e-7)
    close(case.run(laws={"pin": steep}), native, 1e-7)


def test_a_body_without_wear_may_wear_by_a_function(case):
    native = case.run()
    del case["body.pin.wear"]
    result = case.run(laws={"pin": archard_law})
    close(result, native, 1e-7)
    assert result.toml.startswith("# wear of `pin`: the Python function `archard_law`; not in this file.\n")
    assert result.verdict.word == native.verdict.word


@pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
def test_columns_are_those_that_are_named():
    case = archard.Case("fretting_sphere")
    case["frame.elements"] = [16, 16]
    case["motion.fretting.cycles"] = 3
    seen = {}

    def energy(p, s, work, mu):
        seen.update(work=work, mu=mu)
        return 1e-13 * work

    def everything(p, s, **columns):
        seen.update(columns)
        assert columns["slip_vector"].shape == (2, len(p))
        return 1e-13 * columns["work"]

    body = next(iter(case["body"]))
    one = case.run(laws={body: energy})
    assert set(seen) == {"work", "mu"}
    other = case.run(laws={body: everything})
    assert set(seen) == {"work", "mu", "distance", "worn", "slip_vector", "traction"}
    assert one.history["wear_depth_m"][-1] > 0
    np.testing.assert_allclose(other.history["wear_depth_m"], one.history["wear_depth_m"], rtol=1e-9)


def test_a_law_that_remembers(case):
    """Running in, as the native law does: k = k1 + (k0 - k1) exp(-distance / s0)."""
    k0, k1, s0 = 4e-13, 1e-13, 10e-3
    case["body.pin.wear"] = {
        "running_in": {
            "initial_coefficient": f"{k0} 1/Pa",
            "final_coefficient": f"{k1} 1/Pa",
            "running_in_distance": f"{s0} m",
        }
    }

    def running_in(p, s, distance):
        return p * (k1 * s + (k0 - k1) * s0 * -np.expm1(-s / s0) * np.exp(-distance / s0))

    close(case.run(laws={"pin": running_in}), case.run(), 1e-7)


class Enough(Exception):
    pass


def failing(p, s):
    if len(p) > 1 and s.max() == 2e-3 and p.max() < 190e6:
        raise Enough("of it")
    return K * p * s


def bad(value):
    def law(p, s):
        depth = K * p * s
        if len(p) > 40:
            depth[10] = value
        return depth

    return law


def test_what_a_law_raises_comes_through_with_the_part(case):
    with pytest.raises(Enough, match="of it") as caught:
        case.run(laws={"pin": failing})
    part = caught.value.result
    assert not part.complete
    assert len(part.history["load_N"]) >= 1
    with pytest.raises(Enough):
        case.run(laws={"pin": lambda p, s: (_ for _ in ()).throw(Enough("at once"))})


@pytest.mark.parametrize("value", [np.nan, np.inf, -1e-9])
def test_depths_that_are_none_end_the_run(case, value):
    with pytest.raises(ValueError, match=r"the wear law of `pin`, `bad.<locals>.law`, returned a depth of"):
        case.run(laws={"pin": bad(value)})


@pytest.mark.parametrize(
    ("law", "message"),
    [
        (lambda p, s: 1.0, r"shape \(\); one value a point has shape \("),
        (lambda p, s: K * p[:-1] * s[:-1], "one value a point"),
        (lambda p, s: (p, s, p), "returned 3 values"),
        (lambda p, s: K * (p + 1e6) * s, "grows from nothing"),
        (lambda p, s: K * p * s**2, "not in proportion to the slip"),
        (lambda p, s: K * s * p * np.exp(-p / 1e8), "falls as the pressure grows|slope of -"),
        (lambda p, s: (K * p * s, -K * s), "slope of -"),
        (lambda p, s, speed: K * p * s, "takes `speed`; after pressure and slip it may take work, mu, v"),
    ],
)
def test_laws_that_are_none_are_refused(case, law, message):
    with pytest.raises((ValueError, TypeError), match=message):
        case.run(laws={"pin": law})


def test_laws_that_lack_something_are_refused(case):
    with pytest.raises(archard.RunError, match="depends on the work of friction"):
        case.run(laws={"pin": lambda p, s, work: K * work})
    with pytest.raises(archard.RunError, match="whole cycle"):
        case.run(laws={"pin": archard.Law(archard_law, per="cycle")})
    with pytest.raises(ValueError, match="no body is called `disk`; there are `pin`, `disc`"):
        case.run(laws={"disk": archard_law})
    with pytest.raises(TypeError, match="no function"):
        case.run(laws={"pin": 3})
    with pytest.raises(ValueError, match='"increment" or a "cycle"'):
        case.run(laws={"pin": archard.Law(archard_law, per="step")})


def test_laws_of_layers_are_not_replaced(case):
    case["body.pin.layers"] = [
        {
            "thickness": "3 um",
            "young": "300 GPa",
            "poisson": 0.2,
            "wear": {"archard": {"coefficient": "1e-7 mm^3/(N m)"}},
        }
    ]
    with pytest.raises(ValueError, match="layers of `pin` have laws of their own"):
        case.run(laws={"pin": archard_law})


def test_text_that_is_no_number_is_refused(case):
    with pytest.raises(ValueError, match="could not convert"):
        case.run(laws={"pin": lambda p, s: ["deep"] * len(p)})


@pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
def test_friction_is_sampled_to_its_error():
    case = archard.Case("cattaneo_mindlin")
    case["frame.elements"] = [30, 30]
    mu = float(case["friction.coulomb.coefficient"])
    native = case.run()
    ours = case.run(friction=lambda p: mu * p)
    np.testing.assert_allclose(ours.history["force_x_N"], native.history["force_x_N"], rtol=1e-9, atol=1e-9)
    case["friction"] = {"tresca": {"coefficient": mu, "shear_strength": "50 MPa"}}
    native = case.run()
    ours = case.run(friction=lambda p: np.minimum(mu * p, 50e6))
    np.testing.assert_allclose(ours.history["force_x_N"], native.history["force_x_N"], rtol=1e-6, atol=1e-6)


def test_samples_meet_the_function():
    def limit(p):
        return 0.6 * p / (1 + p / 3e8)

    pressures, limits, error = _law.sampled(limit)
    at = np.geomspace(2.0, 9e11, 10_007)
    assert np.abs(np.interp(at, pressures, limits) / limit(at) - 1).max() < 2 * error < 2e-6
    with pytest.raises(ValueError, match="falls as the pressure grows"):
        _law.sampled(lambda p: 0.3 * p * np.exp(-p / 1e9))


def test_friction_that_is_none_is_refused(case):
    case["friction.coulomb.coefficient"] = 0.3
    with pytest.warns(archard.CaseWarning), pytest.raises(ValueError, match="finite and not negative"):
        case.run(friction=lambda p: -p)
    with pytest.warns(archard.CaseWarning), pytest.raises(ValueError, match="shape"):
        case.run(friction=lambda p: 3.0)
    del case["friction"]
    with pytest.raises(ValueError, match="no `friction` table"):
        case.run(friction=lambda p: 0.3 * p)


def test_lists_cost_little_and_coarse_numbers_are_refused():
    """Lists are converted once; float32 rounds more coarsely than steps agree."""
    case = archard.Case("pin_on_disc")
    del case["accuracy"]
    case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [24, 24]}
    case["motion.sliding"] = {"load": "10.2 N", "distance": "20 mm", "step": "5 mm"}
    calls = {}

    def counted(kind, convert):
        def law(p, s):
            calls[kind] = calls.get(kind, 0) + 1
            return convert(K * p * s)

        return law

    native = case.run()
    close(case.run(laws={"pin": counted("array", np.asarray)}), native, 1e-7)
    close(case.run(laws={"pin": counted("list", np.ndarray.tolist)}), native, 1e-7)
    assert calls["list"] == calls["array"]
    with pytest.raises(TypeError, match=r"returned float32.*return float64"):
        case.run(laws={"pin": counted("float32", np.float32)})


class Arrays:
    """What another library calls an array."""

    def __init__(self, values):
        self.values = values

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.values, dtype)


@pytest.mark.parametrize(
    "convert",
    [
        Arrays,
        lambda depth: np.repeat(depth, 2)[::2],
        lambda depth: depth[::-1].copy()[::-1],
        lambda depth: depth.astype(np.longdouble),
        lambda depth: depth.astype(">f8"),
        lambda depth: depth.astype(object),
    ],
    ids=["__array__", "strided", "reversed", "longdouble", "big endian", "objects"],
)
def test_arrays_of_any_kind_are_converted(case, convert):
    case["motion.sliding.distance"] = "4 mm"
    close(case.run(laws={"pin": lambda p, s: convert(K * p * s)}), case.run(laws={"pin": archard_law}), 1e-14)


@pytest.mark.parametrize(
    "convert",
    [lambda depth: depth.astype(complex), lambda depth: depth.astype(np.float16), lambda depth: depth[None]],
)
def test_other_numbers_are_refused_by_name(case, convert):
    with pytest.raises((TypeError, ValueError), match=r"the wear law of `pin`, `.*<lambda>`, returned"):
        case.run(laws={"pin": lambda p, s: convert(K * p * s)})


def test_laws_of_numba_are_taken_as_they_are(case):
    numba = pytest.importorskip("numba")
    case["motion.sliding.distance"] = "4 mm"

    @numba.njit
    def loop(p, s):
        depth = np.empty_like(p)
        for i in range(p.size):
            depth[i] = K * p[i] * s[i]
        return depth

    @numba.vectorize
    def point(p, s):
        return K * p * s if p > 0.0 else 0.0

    @numba.vectorize(["float64(float64, float64, float64)"])
    def faster(p, s, v):
        return K * p * s * (1.0 + v)

    @numba.njit
    def slower(p, s, v):
        return K * p * s * (1.0 + v), K * s * (1.0 + v)

    native = case.run()
    assert "the Python function `loop`" in case.run(laws={"pin": loop}).toml.replace(
        "test_laws_of_numba_are_taken_as_they_are.<locals>.", ""
    )
    close(case.run(laws={"pin": loop}), native, 1e-7)
    close(case.run(laws={"pin": point}), native, 1e-7)
    case["motion.sliding.speed"] = "0.5 m/s"
    twice = case.run(laws={"pin": lambda p, s: 1.5 * K * p * s})
    close(case.run(laws={"pin": faster}), twice, 1e-7)
    close(case.run(laws={"pin": slower}), twice, 1e-7)


@pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
def test_friction_by_numba_is_taken_as_it_is():
    numba = pytest.importorskip("numba")
    case = archard.Case("cattaneo_mindlin")
    case["frame.elements"] = [16, 16]
    mu = float(case["friction.coulomb.coefficient"])

    @numba.vectorize
    def limit(p):
        return mu * p

    ours, native = case.run(friction=limit), case.run()
    np.testing.assert_allclose(ours.history["force_x_N"], native.history["force_x_N"], rtol=1e-9, atol=1e-9)


def test_masked_points_are_refused(case):
    def law(p, s):
        return np.ma.masked_less(1e-13 * p * s, np.inf)

    with pytest.raises(ValueError, match="returned a depth with masked points"):
        case.run(laws={"pin": law})
    result = case.run(laws={"pin": lambda p, s: np.ma.masked_less(1e-13 * p * s, -1.0)})
    assert result.complete
    with pytest.raises(ValueError, match="returned masked points"):
        _law.sampled(lambda p: np.ma.masked_less(0.3 * p, 10.0))
