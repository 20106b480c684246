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
    assert len(mesh.points) == len(wear) == 900
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
