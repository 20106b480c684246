"""What `archard paraview` writes is read by the readers people have."""

import numpy as np
import pytest

import archard

CASE = archard.case._CASES / "pin_on_disc"


@pytest.fixture(scope="module")
def surfaces(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("paraview")
    command("run", CASE, "-o", folder, "-q")
    command("paraview", folder)
    return folder


def test_meshio_reads_them(surfaces):
    meshio = pytest.importorskip("meshio")
    mesh = meshio.read(surfaces / "paraview" / "pin_0010.vtu")
    result = archard.open(surfaces)
    wear = result.fields[-1]["wear_pin_m"].ravel()
    assert [cells.type for cells in mesh.cells] == ["quad"]
    assert len(mesh.points) == len(wear) == result.fields[-1].pressure.size
    assert np.allclose(mesh.point_data["wear_um"], 1e6 * wear, rtol=1e-12)
    assert np.allclose(mesh.point_data["relief_mm"][:, 2], mesh.points[:, 2])


def test_pyvista_warps_them(surfaces):
    pyvista = pytest.importorskip("pyvista")
    reader = pyvista.get_reader(surfaces / "paraview" / "pin.pvd")
    reader.set_active_time_value(reader.time_values[-1])
    mesh = reader.read()[0]
    low, high = mesh.bounds[4:]
    warped = mesh.warp_by_vector("relief_mm", factor=9.0)
    assert np.allclose(np.array(warped.bounds[4:]), 10.0 * np.array([low, high]))
    assert mesh.contour(3, scalars="pressure_MPa").n_points > 0


@pytest.fixture(scope="module")
def block(command, tmp_path_factory):
    """A ball of 100 m on a quarter of a block of 1 m, at an approach of 70 um: a contact of 83.7 mm."""
    folder = tmp_path_factory.mktemp("block")
    section = 'output.sections.block.middle={ through = ["0 m", "0 m", "0 m"], normal = [0, 1, 0], '
    section += 'spacing = "10 mm", size = ["240 mm", "240 mm"] }'
    options = ["friction=", "body.block.wear=", "motion.indentation.increments=1", section]
    options += ["body.block.mesh.box.contact.elements=[12, 12]"]
    case = archard.case._CASES / "punch_indentation_block"
    command("run", case, "-o", folder, "-q", *[part for option in options for part in ("--set", option)])
    command("paraview", folder)
    return folder


def hertz(block):
    """The peak pressure (MPa) and the radius (mm) of the contact that has the load of the run."""
    load = archard.open(block).history["load_N"][-1]
    radius = (0.75 * load * 100.0 * (1.0 - 0.09) / 210e9) ** (1 / 3)
    return 1.5e-6 * load / (np.pi * radius**2), 1e3 * radius


def test_meshio_reads_a_section_with_the_largest_equivalent_stress_of_hertz(block):
    meshio = pytest.importorskip("meshio")
    section = meshio.read(block / "paraview" / "section_block_middle.vtu")
    assert [cells.type for cells in section.cells] == ["quad"]
    peak, radius = hertz(block)
    mises = section.point_data["von_mises_MPa"]
    x, y, z = section.points[np.argmax(mises)]
    # K. L. Johnson, Contact Mechanics, section 3.4: 0.620 at a depth of 0.481 radii for a Poisson's ratio of 0.3.
    assert mises.max() / peak == pytest.approx(0.620, abs=0.015)
    # The block is body 2: in contact it lies above.
    assert z / radius == pytest.approx(0.481, abs=0.08)
    assert (x, y) == pytest.approx((0.0, 0.0))
    raw = meshio.read(block / "sections" / "block_middle.vtu")
    assert np.allclose(1e3 * raw.points, section.points)
    assert np.allclose(1e-6 * raw.point_data["von_mises_Pa"], mises)


def test_pyvista_reads_the_stresses_on_the_whole_surface(block):
    pyvista = pytest.importorskip("pyvista")
    surface = pyvista.read(block / "paraview" / "stress_block.vtu")
    # A quarter is computed, the whole is shown.
    assert np.allclose(surface.bounds, [-500, 500, -500, 500, 0, 1000])
    peak, _ = hertz(block)
    assert surface["stress_zz_MPa"].min() == pytest.approx(-peak, rel=0.04)
    middle = surface.find_closest_point((0.0, 0.0, 0.0))
    assert np.allclose(surface["displacement_um"][middle][:2], 0.0, atol=0.5)
    left, right = (surface.find_closest_point((x, 0.0, 0.0)) for x in (-60.0, 60.0))
    shear = surface["stress_xx_MPa"]
    assert shear[left] == pytest.approx(shear[right])
    along = surface["displacement_um"][:, 0]
    assert along[left] == pytest.approx(-along[right])
    assert {"wear_um", "von_mises_MPa"} <= set(surface.point_data.keys())
    section = pyvista.read(block / "sections" / "block_middle.vtu")
    assert section.contour(3, scalars="von_mises_Pa").n_points > 0
