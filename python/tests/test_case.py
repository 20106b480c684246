"""Cases: what is read, and what is refused."""

import pickle
from pathlib import Path

import numpy as np
import pint
import pytest

import archard

UNITS = pint.UnitRegistry()

DICT = {
    "title": "a ball on a flat",
    "body": {
        "ball": {"material": {"young": "210 GPa", "poisson": 0.3}, "profile.sphere": {"radius": "10 mm"}},
        "flat": {"material": {"young": "210 GPa", "poisson": 0.3}, "profile.flat": {}},
    },
    "frame": {"size": ["0.5 mm", "0.5 mm"], "elements": [40, 40]},
    "motion.indentation.load": "20 N",
}


def problems(case):
    with pytest.raises(archard.CaseError) as caught:
        archard.Case(case).check()
    return caught.value.problems


def test_all_sources_are_the_same_case(tmp_path):
    text = (archard.case._CASES / "hertz" / "case.toml").read_text()
    (tmp_path / "case.toml").write_text(text)
    sources = ["hertz", text, tmp_path, str(tmp_path / "case.toml"), archard.Case("hertz")]
    assert len({archard.Case(source).check().toml for source in sources}) == 1


def test_hertz_is_met_from_a_dict():
    """Hertz: a^3 = 3 F R / (4 E*), p0 = 3 F / (2 pi a^2).

    Elements average the pressure; 40 across the frame put the highest of them 1 % below p0 at most.
    """
    result = archard.Case(DICT).run()
    modulus = 210e9 / (1 - 0.3**2) / 2
    radius = (3 * 20 * 10e-3 / (4 * modulus)) ** (1 / 3)
    peak = 3 * 20 / (2 * np.pi * radius**2)
    assert result.history["load_N"][-1] == pytest.approx(20, rel=1e-7)
    assert result.fields[-1].pressure.max() == pytest.approx(peak, rel=0.01)
    assert result.history["approach_m"][-1] == pytest.approx(radius**2 / 10e-3, rel=0.01)
    assert result.history.units["approach_m"] == "m"


def test_materials_have_names():
    """A name stands for its values, which the case in SI has in full, and reads back; a wrong one is answered."""
    case = archard.Case(DICT)
    case["body.ball.material"] = "100Cr6"
    case["body.flat.material"] = {"name": "PMMA", "young": "3.3 GPa"}
    toml = case.check().toml
    assert 'body.ball.material.name = "100Cr6"' in toml
    assert 'body.ball.material.young = "2.1e11 Pa"' in toml
    assert 'body.flat.material.young = "3.3e9 Pa"' in toml
    assert archard.Case(toml).check().toml == toml
    case["body.ball.material"] = "100Cr5"
    [wrong] = problems(case)
    assert wrong.key == "body.ball.material"
    assert "100Cr5" in wrong.message


def test_values_are_set_read_and_removed():
    case = archard.Case("pin_on_disc")
    case["motion.sliding.load"] = "20 N"
    assert case["motion.sliding.load"] == "20 N"
    assert "friction" not in case
    case["friction.coulomb.coefficient"] = np.float64(0.5)
    assert case["friction.coulomb"] == {"coefficient": 0.5}
    del case["friction"]
    assert "friction" not in case
    with pytest.raises(KeyError):
        del case["friction"]
    with pytest.raises(TypeError):
        case["motion"]["sliding"] = {}
    case["motion.path.file"] = Path("path.csv")
    assert case["motion.path.file"] == "path.csv"
    with pytest.raises(TypeError, match="not set"):
        case["frame.elements"] = {3, 4}
    with pytest.raises(KeyError, match="nothing can be set inside"):
        case["title.word"] = "a"
    del case["motion.path"]
    assert archard.Case("pin_on_disc")["motion.sliding.load"] == "10.2 N"
    assert 'load = "20 N"' in case.check().toml


def test_a_copy_and_a_pickle_are_the_same():
    case = archard.Case("pin_on_disc")
    case["motion.sliding.load"] = "20 N"
    for other in (case.copy(), pickle.loads(pickle.dumps(case))):
        assert other.check().toml == case.check().toml
        assert other["motion.sliding.load"] == "20 N"
    other["motion.sliding.load"] = "30 N"
    assert case["motion.sliding.load"] == "20 N"


@pytest.mark.parametrize(
    ("quantity", "text"),
    [
        (20 * UNITS.newton, "20 N"),
        (0.02 * UNITS.kN, "20 N"),
        (2 * UNITS.MPa * UNITS.mm**2, "2 N"),
    ],
)
def test_quantities_are_values_with_units(quantity, text):
    case = archard.Case(DICT)
    case["motion.indentation.load"] = quantity
    assert f'motion.indentation.load = "{text}"' in case.check().toml


def test_quantities_of_arrays_and_of_wear():
    case = archard.Case("pin_on_disc")
    case["frame.size"] = UNITS.Quantity(np.array([1.2, 1.2]), "mm")
    case["body.pin.wear.archard.coefficient"] = 1.33e-4 * UNITS.mm**3 / (UNITS.N * UNITS.m)
    written = archard.Case("pin_on_disc")
    written["frame.size"] = ["1.2 mm", "1.2 mm"]
    assert case.check().toml == written.check().toml


def test_bad_values_are_named_with_their_keys():
    [wrong] = problems({**DICT, "motion.indentation.load": 20})
    assert wrong.severity == "error"
    assert wrong.key == "motion.indentation.load"
    assert "needs a unit" in wrong.message
    [wrong] = problems({**DICT, "motion.indentation.load": 20 * UNITS.second})
    assert wrong.message == 'expected a force (for example "10 N"), found a time'
    [wrong] = problems({**DICT, "motion.indentation.lod": "1 N"})
    assert "lod" in wrong.key
    several = problems({**DICT, "motion.indentation.load": 20, "solver.x.tolerance": 1, "colour": 1})
    assert len(several) >= 3


def test_a_value_that_was_set_is_named():
    case = archard.Case("pin_on_disc")
    case["motion.sliding.load"] = 20
    with pytest.raises(archard.CaseError, match=r"motion\.sliding\.load=20") as caught:
        case.run()
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.problems == caught.value.problems


def test_text_that_is_no_toml_is_named_with_its_line():
    with pytest.raises(archard.CaseError) as caught:
        archard.Case("title = 'a'\nframe = [\n")
    assert caught.value.problems[0].place == "case:2"


def test_files_that_are_not_there(tmp_path, monkeypatch):
    with pytest.raises(FileNotFoundError, match="did you mean 'pin_on_disc'"):
        archard.Case("pin_on_disk")
    monkeypatch.chdir(tmp_path)
    Path("hertz").mkdir()
    with pytest.warns(archard.CaseWarning, match="built-in"):
        archard.Case("hertz")
    with pytest.raises(FileNotFoundError):
        archard.Case(Path("hertz"))


def test_a_doubtful_case_warns():
    case = archard.Case({**DICT, "frame": {"size": ["0.5 mm", "0.5 mm"], "elements": [8, 8]}})
    assert case.check().warnings[0].severity == "warning"
    with pytest.warns(archard.CaseWarning, match="coarse"), pytest.warns(archard.ResultWarning, match="doubtful"):
        assert case.run().verdict.word == "doubtful"


def test_attributes_are_refused_with_their_keys():
    case = archard.Case("pin_on_disc")
    with pytest.raises(AttributeError, match=r"case\['motion.sliding.load'\] = "):
        case.load = 3
    with pytest.raises(AttributeError, match=r"case\['KEY.lod'\] = "):
        case.lod = 3
    assert case["motion.sliding.load"] == archard.Case("pin_on_disc")["motion.sliding.load"]


@pytest.mark.parametrize(
    ("quantity", "key", "si"),
    [
        (2.5 * UNITS.lbf, "motion.sliding.load", 2.5 * 4.4482216152605),
        (2.5 * UNITS.kgf, "motion.sliding.load", 2.5 * 9.80665),
        (0.5 * UNITS.inch, "body.pin.profile.sphere.radius", 0.0127),
        (30e6 * UNITS.psi, "body.pin.material.young", 30e6 * 6894.757293168361),
    ],
)
def test_quantities_of_other_systems_are_taken_by_base_units(quantity, key, si):
    case = archard.Case("pin_on_disc")
    if key.startswith("body.pin.material"):
        case["body.pin.material"] = {"young": "210 GPa", "poisson": 0.3}
    case[key] = quantity
    resolved = archard.Case(case.check().toml)
    written = float(str(resolved[key]).split()[0])
    assert written == pytest.approx(si, rel=1e-12)
