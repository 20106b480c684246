"""Fields of states, read one by one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from archard import _archard, _damage
from archard._table import Array


class Snapshot:
    """Fields of one state: ``[ny, nx]`` arrays over ``x`` and ``y`` (m) on a grid, else one value a pair.

    Fields are attributes without their unit (``pressure``, ``gap``, ``traction_x``, ``slip_x``, ``stick``) and
    items with it (``"pressure_Pa"``); of bodies, ``worn["pin"]`` and ``height["pin"]``.
    """

    progress: float
    """How far the motion has gone, in its own unit."""

    def __init__(self, progress: float, places: dict[str, Array], fields: dict[str, Array]) -> None:
        self.progress = progress
        self.x, self.y = places["x"], places["y"]
        self.z = places.get("z")
        self._fields = fields

    @property
    def names(self) -> list[str]:
        """The names of all fields, each with its unit."""
        return list(self._fields)

    @property
    def worn(self) -> dict[str, Array]:
        """Depth worn off each body (m)."""
        return self._of_bodies("wear_")

    @property
    def height(self) -> dict[str, Array]:
        """Height of each worn body, without elastic deformation (m)."""
        return self._of_bodies("height_")

    def __getitem__(self, name: str) -> Array:
        return self._fields[name]

    def __getattr__(self, name: str) -> Array:
        if not name.startswith("_"):
            for field, values in self._fields.items():
                if field.removesuffix("_Pa").removesuffix("_m") == name:
                    return values
        raise AttributeError(f"no field `{name}`; there are {', '.join(self.__dict__.get('_fields', {}))}")

    def __repr__(self) -> str:
        return f"{type(self).__name__}(progress={self.progress:g}, {', '.join(self._fields)})"

    def _of_bodies(self, kind: str) -> dict[str, Array]:
        found = self._fields.items()
        return {
            name[len(kind) : -len("_m")]: values
            for name, values in found
            if name.startswith(kind) and name != f"{kind}m"
        }


class Outputs(Sequence[Snapshot]):
    """The outputs of a run, read one by one."""

    def __init__(self, files: Mapping[str, bytes], folder: Path | None) -> None:
        self._files, self._folder = files, folder
        collection = files.get("fields.pvd")
        listed = [] if collection is None else ElementTree.fromstring(collection).iter("DataSet")
        self._outputs = [(float(one.attrib["timestep"]), one.attrib["file"]) for one in listed]

    def __len__(self) -> int:
        return len(self._outputs)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(len(self)))]
        progress, name = self._outputs[index]
        return snapshot(progress, name, self._files, self._folder)


def snapshot(progress: float, name: str, files: Mapping[str, bytes], folder: Path | None) -> Snapshot:
    """Return the fields in a file of a result."""
    with _damage.naming(folder, name):
        return Snapshot(progress, *_archard.read_fields(name, files[name]))
