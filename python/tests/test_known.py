"""What a case can name, as lists."""

import archard


def test_materials_can_be_named():
    for one in archard.materials():
        assert one.young > 1e6
        assert one.source
        case = archard.Case("hertz")
        for body in ("ball", "flat"):
            case[f"body.{body}.material"] = one.name
        assert f"{one.poisson}" in case.check().toml


def test_laws_can_be_written_as_they_are_shown():
    """Keys of each example are those that the law takes."""
    known = archard.laws()
    assert {"wear.archard", "wear.cross_shear", "friction.coulomb"} <= {one.key for one in known}
    for one in known:
        assert one.source
        assert one.meaning
        assert all(key.name in one.example for key in one.keys if key.required)
