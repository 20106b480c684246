"""Contacts that are solved once."""

from __future__ import annotations

import numpy as np
import pytest

import archard

STEEL = {"material": {"young": "210 GPa", "poisson": 0.3}}
FLAT = {**STEEL, "profile": {"flat": {}}}
BALL = {**STEEL, "profile": {"sphere": {"radius": "50 mm"}}}
FRAME = {"size": ["0.36 mm", "0.36 mm"], "elements": [48, 48]}
MODULUS = 210e9 / (1 - 0.3**2) / 2


def test_a_ball_on_a_flat_is_hertz_s():
    """Pressure, approach and gap, by a load and by the approach it makes."""
    case = {"body": {"ball": BALL, "flat": FLAT}, "frame": FRAME}
    radius = (3 * 10.2 * 50e-3 / (4 * MODULUS)) ** (1 / 3)
    peak = 3 * 10.2 / (2 * np.pi * radius**2)
    pressed = archard.contact(case, load="10.2 N")
    again = archard.contact(case, approach=f"{radius**2 / 50e-3!r} m")
    for solved in (pressed, again):
        assert solved.load == pytest.approx(10.2, rel=2e-3)
        assert solved.peak_pressure == pytest.approx(peak, rel=5e-3)
        assert solved.approach == pytest.approx(radius**2 / 50e-3, rel=2e-3)
    distance = np.hypot(pressed.x, pressed.y)
    inside = distance < 0.9 * radius
    expected = peak * np.sqrt(1 - (distance[inside] / radius) ** 2)
    assert pressed.pressure[inside] == pytest.approx(expected, rel=0.02)
    assert np.all(np.abs(pressed.gap[pressed.pressure > 0]) < 1e-12)
    assert pressed.traction is None
    assert "peak_pressure" in repr(pressed)


def test_derivatives_by_the_load_are_hertz_s():
    case = {"body": {"ball": BALL, "flat": FLAT}, "frame": FRAME}
    contact = archard.contact(case, load="10.2 N")
    by_load = contact.by_load()
    assert by_load.pressure.shape == contact.pressure.shape
    assert by_load.approach == pytest.approx(contact.approach / (1.5 * contact.load), rel=5e-3)
    cell = (contact.x[0, 1] - contact.x[0, 0]) ** 2
    assert cell * by_load.pressure.sum() == pytest.approx(1, rel=1e-9)


def test_derivatives_by_the_radius_are_hertz_s():
    """The approach under a load falls with the radius to the power of -1/3."""
    radius = 50e-3
    contact = archard.contact({"body": {"ball": BALL, "flat": FLAT}, "frame": FRAME}, load="10.2 N")
    by_radius = contact.by_shape(-(contact.x**2 + contact.y**2) / (2 * radius**2))
    assert by_radius.pressure.shape == contact.pressure.shape
    assert by_radius.approach == pytest.approx(-contact.approach / (3 * radius), rel=1e-2)
    with pytest.raises(ValueError, match="shape"):
        contact.by_shape([1.0])


def test_derivatives_are_not_known_where_pairs_yield():
    case = {"body": {"ball": BALL, "flat": {**FLAT, "hardness": "150 MPa"}}, "frame": FRAME}
    with pytest.raises(ValueError, match="yield"):
        archard.contact(case, load="10.2 N").by_load()


def test_heights_are_pressed():
    """An array of heights under a flat: waves flattened altogether (Westergaard)."""
    count, length, amplitude = 64, 1e-3, 0.1e-6
    x = (np.arange(count) + 0.5) / count - 0.5
    heights = np.tile(-amplitude * (1 - np.cos(2 * np.pi * x)), (count, 1))
    surface = {"file": heights, "pixel": f"{length / count!r} m", "unit": "m"}
    rough = {**STEEL, "profile": {"surface": surface}}
    frame = {"size": ["1 mm", "1 mm"], "elements": [count, count], "periodic": True}
    most = np.pi * MODULUS * amplitude / length
    mean = 2 * most
    solved = archard.contact(
        {"body": {"rough": rough, "flat": FLAT}, "frame": frame}, load=f"{mean * length**2!r} N"
    )
    assert solved.pressure == pytest.approx(mean + most * np.cos(2 * np.pi * solved.x / length), rel=1e-3)


def test_motions_say_how_bodies_are_driven():
    """Rolling has friction below its limit; a pin is pressed before it slides; a mesh goes in as it is."""
    rolls = archard.contact("carter")
    assert rolls.traction is not None
    assert 0 < abs(rolls.force[0]) < 0.3 * rolls.load
    slides = archard.contact("pin_on_disc")
    assert slides.load == pytest.approx(10.2, rel=1e-6)
    assert slides.force == (0, 0)
    flat = archard.contact("punch_indentation_block", approach="0.07 mm")
    assert flat.approach == pytest.approx(0.07e-3, rel=1e-6)
    assert flat.pressure.shape == (40, 40)
    block = archard.Case("punch_indentation_block")
    block["body.block.mesh.box.contact.elements"] = [8, 8]
    meshed = archard.contact(block, approach="0.07 mm")
    assert meshed.load == pytest.approx(flat.load, rel=0.01)
    assert meshed.pressure.ndim == 1


def test_what_is_doubtful_is_a_warning():
    """Few elements across the contact are told as of a run; what frets is unworn at its first cycle."""
    coarse = {"size": ["0.36 mm", "0.36 mm"], "elements": [4, 4]}
    with pytest.warns(archard.CaseWarning, match="elements"):
        archard.contact({"body": {"ball": BALL, "flat": FLAT}, "frame": coarse}, load="10.2 N")
    case = archard.Case("fretting_energy")
    unworn = archard.contact(case)
    for body in ("ball", "flat"):
        if f"body.{body}.wear" in case:
            del case[f"body.{body}.wear"]
    assert archard.contact(case).pressure == pytest.approx(unworn.pressure, rel=1e-12)


def test_what_cannot_be_is_said():
    """Both controls, friction that depends on the way, no load, one body."""
    case = {"body": {"ball": BALL, "flat": FLAT}, "frame": FRAME}
    with pytest.raises(ValueError, match="exclude"):
        archard.contact(case, load="1 N", approach="1 um")
    with pytest.raises(archard.CaseError, match="motion"):
        archard.contact(case)
    with pytest.raises(archard.CaseError, match="load"):
        archard.contact(case, load="-1 N")
    soft = {**BALL, "material": {"young": "10 GPa", "poisson": 0.3}}
    rubs = {
        "body": {"ball": soft, "flat": FLAT},
        "frame": FRAME,
        "motion": {"indentation": {"load": "1 N", "increments": 4}},
        "friction": {"coulomb": {"coefficient": 0.3}},
    }
    with pytest.raises(ValueError, match="depends on the way"):
        archard.contact(rubs)
    with pytest.raises(ValueError, match="two bodies"):
        archard.contact("patch_test")


def test_stresses_below_a_ball_are_hertz_s():
    """Along the axis of a contact (Johnson, Contact Mechanics, 3.45), in a plane, and in both bodies."""
    case = {"body": {"ball": BALL, "flat": FLAT}, "frame": FRAME}
    solved = archard.contact(case, load="10.2 N")
    radius = (3 * 10.2 * 50e-3 / (4 * MODULUS)) ** (1 / 3)
    peak = 3 * 10.2 / (2 * np.pi * radius**2)
    depth = radius * np.array([0.3, 0.48, 1.0, 2.0])
    s = depth / radius
    zz = -peak / (1 + s**2)
    rr = -peak * (1.3 * (1 - s * np.arctan(1 / s)) - 0.5 / (1 + s**2))
    points = np.column_stack([np.zeros(4), np.zeros(4), -depth])
    for body in ("ball", "flat"):
        stress = solved.stress_at(points, body)
        assert stress[:, 2] == pytest.approx(zz, rel=5e-3)
        assert stress[:, 0] == pytest.approx(rr, abs=5e-3 * peak)
        assert np.abs(stress[:, 3:]).max() < 1e-6 * peak
    plane = solved.stress(radius, "flat")
    assert plane.shape == (6, 48, 48)
    row = [solved.x[10, 20], solved.y[10, 20], -radius]
    assert plane[:, 10, 20] == pytest.approx(solved.stress_at(row, "flat")[0], rel=1e-9, abs=1.0)
    # The load crosses a plane just below the surface within the frame, but for what goes beyond it.
    crossing = -solved.stress(0.02 * radius, "flat")[2].sum() * (0.36e-3 / 48) ** 2
    assert crossing == pytest.approx(10.2, rel=5e-3)
    for bad in ([0, 0, 1e-6], [0, 0], [[np.nan, 0, -1e-5]]):
        with pytest.raises(ValueError, match="point"):
            solved.stress_at(bad, "flat")
    with pytest.raises(ValueError, match="'ball' and 'flat'"):
        solved.stress(1e-5, "disc")


def test_a_rigid_body_has_no_stress():
    """It is said, with the name of what stands in the way."""
    rigid = {"rigid": True, "profile": {"sphere": {"radius": "50 mm"}}}
    solved = archard.contact({"body": {"ball": rigid, "flat": FLAT}, "frame": FRAME}, load="10.2 N")
    with pytest.raises(ValueError, match="rigid"):
        solved.stress_at([0, 0, -1e-5], "ball")
    assert solved.stress_at([0, 0, -1e-5], "flat")[0, 2] < 0


def test_stresses_of_strips_are_refused():
    """Strips are lines of their own."""
    with pytest.raises(ValueError, match="strips"):
        archard.contact("thrust_roller").stress_at([0, 0, -1e-5], "washer")


def test_waves_of_stress_fade_below_surfaces_that_repeat_themselves():
    """Three waves below the surface the mean pressure is left."""
    solved = archard.contact("wavy_surface")
    _, _, zz, *shear = solved.stress_at([0, 0, -3 * 0.5e-3], "flat")[0]
    mean = solved.pressure.mean()
    assert zz == pytest.approx(-mean, rel=1e-6)
    assert np.abs(shear).max() < 1e-6 * mean
