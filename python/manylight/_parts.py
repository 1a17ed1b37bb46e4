"""Parts of a scene that Python makes from arrays. Lengths are in metres and angles in radians; +Y is up."""
from __future__ import annotations

import dataclasses
from typing import Any, Optional, Sequence, Tuple

import numpy as np

from ._call import Descriptor
from ._cffi import ffi, lib
from ._errors import ArgumentError

Vector = Tuple[float, float, float]


@dataclasses.dataclass
class Material:
    """A material with metalness and roughness, as of glTF."""

    base_color: Tuple[float, float, float, float] = (1, 1, 1, 1)  #: linear RGBA
    metalness: float = 0  #: 0 to 1
    roughness: float = 1  #: 0 to 1
    emission: Vector = (0, 0, 0)  #: W/(sr m2)
    double_sided: bool = False
    picture: Optional[bytes] = None  #: PNG or JPEG of the base colour, sRGB; its meshes need uvs


@dataclasses.dataclass
class Mesh:
    """Triangles of one material, in the world."""

    positions: Any  #: (vertices, 3)
    indices: Any = None  #: (triangles, 3); None: vertices in their order
    normals: Any = None  #: (vertices, 3), unit length; None: flat
    uvs: Any = None  #: (vertices, 2), v down
    colors: Any = None  #: (vertices, 4), linear RGBA
    material: int = 0  #: index of the scene's materials


@dataclasses.dataclass
class Light:
    """A light. `kind` is "spot", "point", "directional" or "area"."""

    kind: str = "point"
    position: Vector = (0, 0, 0)  #: m
    direction: Vector = (0, -1, 0)
    intensity: Vector = (1, 1, 1)  #: W/sr; directional: W/m2; area: W/sr on its axis
    extent: Tuple[float, float] = (0, 0)  #: area: width and height, m; height 0: a disk's diameter
    inner_angle: float = 0  #: spot: half angle of the cone of full intensity
    outer_angle: float = 0  #: spot: half angle of the cone; 0: pi/4


@dataclasses.dataclass
class Camera:
    """A camera. `fov_y` 0 and `y_extent` above 0: orthographic."""

    eye: Vector = (0, 0, 0)  #: m
    forward: Vector = (0, 0, -1)
    up: Vector = (0, 1, 0)
    fov_y: float = 0.8  #: vertical angle of view
    y_extent: float = 0  #: half the height of an orthographic picture, m
    near_plane: float = 0.01  #: m
    far_plane: float = 0  #: m; 0: none


KINDS = {
    "spot": lib.MANYLIGHT_SPOT,
    "point": lib.MANYLIGHT_POINT,
    "directional": lib.MANYLIGHT_DIRECTIONAL,
    "area": lib.MANYLIGHT_AREA,
}


def rows(name: str, values: Any, width: int, kind: type) -> np.ndarray:
    """An array of rows of so many numbers, contiguous."""
    array = np.ascontiguousarray(values, kind)
    if array.ndim != 2 or array.shape[1] != width:
        raise ArgumentError(f"{name}: shape {array.shape}, not (n, {width})")
    return array


def _mesh(mesh: Mesh) -> Descriptor:
    desc = Descriptor("mesh", material=mesh.material)
    positions = rows("positions", mesh.positions, 3, np.float32)
    desc.pointer.vertex_count = len(positions)
    arrays = {"positions": positions}
    for name, width in (("normals", 3), ("uvs", 2), ("colors", 4)):
        if getattr(mesh, name) is not None:
            arrays[name] = rows(name, getattr(mesh, name), width, np.float32)
            if len(arrays[name]) != len(positions):
                raise ArgumentError(f"{name}: {len(arrays[name])} rows for {len(positions)} positions")
    for name, array in arrays.items():
        desc.set(name, desc.keep(ffi.from_buffer("float[]", array)))
    if mesh.indices is not None:
        indices = np.asarray(mesh.indices)
        if indices.size and (indices.min() < 0 or indices.max() > 0xFFFFFFFF):
            raise ArgumentError("indices: below 0 or above 4294967295")
        indices = rows("indices", indices, 3, np.uint32)
        desc.pointer.index_count = indices.size
        desc.set("indices", desc.keep(ffi.from_buffer("uint32_t[]", indices)))
    return desc


def _material(material: Material) -> Descriptor:
    desc = Descriptor("material", base_color=material.base_color, metalness=material.metalness,
                      roughness=material.roughness or lib.MANYLIGHT_ZERO, emission=material.emission,
                      double_sided=material.double_sided)
    if material.picture is not None:
        desc.set("picture", desc.keep(ffi.from_buffer(material.picture)))
        desc.pointer.picture_bytes = len(material.picture)
    return desc


def _light(light: Light) -> Descriptor:
    if light.kind not in KINDS:
        raise ArgumentError(f"light: '{light.kind}' is none of {', '.join(KINDS)}")
    return Descriptor("light", type=KINDS[light.kind], position=light.position, direction=light.direction,
                      intensity=light.intensity, extent=light.extent, inner_angle=light.inner_angle,
                      outer_angle=light.outer_angle)


def camera_desc(camera: Camera) -> Descriptor:
    """A camera for the library."""
    return Descriptor("camera", **dataclasses.asdict(camera))


MAKERS = {"mesh": _mesh, "material": _material, "light": _light, "camera": camera_desc}


def add_parts(desc: Descriptor, kind: str, parts: Sequence[Any]) -> None:
    """Puts an array of structs into the descriptor of a scene: its members KINDs and KIND_count."""
    made = [MAKERS[kind](part) for part in parts]
    array = ffi.new(f"struct manylight_{kind}[]", max(len(made), 1))
    for i, part in enumerate(made):
        array[i] = part.pointer[0]
        desc.keep(part)
    desc.set("meshes" if kind == "mesh" else f"{kind}s", desc.keep(array))
    desc.set(f"{kind}_count", len(made))
