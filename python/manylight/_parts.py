"""Parts of a scene that Python makes from arrays. Lengths are in metres and angles in radians; +Y is up."""
from __future__ import annotations

import dataclasses
import struct
import zlib
from typing import Any, Iterable, Optional, Sequence, Tuple

import numpy as np

from ._call import Descriptor, call, described, real, real_array, vector, width_and_height
from ._cffi import ffi, lib
from ._errors import ArgumentError

Vector = Tuple[float, float, float]


@dataclasses.dataclass
class Material:
    """A material with metalness and roughness, as of glTF.

    Parameters
    ----------
    base_color : linear RGBA, 0 to 1
    metalness, roughness : 0 to 1
    emission : W/(sr m2)
    double_sided : the back of its faces is seen, too
    picture : base colour, sRGB: bytes of a PNG or JPEG file, or a uint8 array (height, width, 3 or 4), row 0 at the
        top. Its meshes need uvs.
    """

    base_color: Tuple[float, float, float, float] = (1, 1, 1, 1)
    metalness: float = 0
    roughness: float = 1
    emission: Vector = (0, 0, 0)
    double_sided: bool = False
    picture: Any = None


@dataclasses.dataclass
class Mesh:
    """Triangles of one material, in the world. A face is seen from where its corners go counter-clockwise, unless the
    material is double-sided.

    Parameters
    ----------
    positions : (vertices, 3), m
    indices : (triangles, 3); None: vertices in their order
    normals : (vertices, 3), unit length; None: flat
    uvs : (vertices, 2), v down as in glTF
    colors : (vertices, 4), linear RGBA: floats from 0 to 1, uint8 (255 is 1) or uint16 (65535 is 1), as COLOR_0 of glTF
    material : index of the scene's materials, from 0
    """

    positions: Any
    indices: Any = None
    normals: Any = None
    uvs: Any = None
    colors: Any = None
    material: int = 0


@dataclasses.dataclass
class Light:
    """A light.

    Parameters
    ----------
    kind : "spot", "point", "directional" or "area"
    position : m
    direction : in which the light shines; unused by points
    intensity : RGB in W/sr; directional: W/m2; area: W/sr on its axis, its radiance in W/(sr m2) times its area
    extent : area and spot: width and height, m, or diameter of a disk and 0. Point: diameter of its sphere and 0.
        Directional: angular diameter, radians, and 0
    inner_angle : spot: half angle of the cone of full intensity, radians
    outer_angle : spot: half angle of the whole cone, radians; 0: pi/4
    up : direction of the height; 0: chosen
    """

    kind: str = "point"
    position: Vector = (0, 0, 0)
    direction: Vector = (0, -1, 0)
    intensity: Vector = (1, 1, 1)
    extent: Tuple[float, float] = (0, 0)
    inner_angle: float = 0
    outer_angle: float = 0
    up: Vector = (0, 0, 0)


@dataclasses.dataclass
class Camera:
    """A camera.

    Parameters
    ----------
    eye : m
    forward, up : directions
    fov_y : vertical angle of view, radians; of a fisheye up to 2 pi
    y_extent : half the height of an orthographic picture, m, with `fov_y` 0
    near_plane, far_plane : limits of what is seen, along the view, m; 0: none
    right : 0: made of `forward` and `up`. Else the three axes are taken as they are: at right angles, `forward` of
        length 1. A longer `right` widens the picture
    shift : shifted lens: the picture's middle, from the axis to the right and up, in halves of width and height
    lens : "pinhole", "equirectangular", "cube", "equidistant" or "equisolid"
    skew : K[0][1] / K[0][0]
    distortion : OpenCV's 4, 5 or 8 numbers: k1, k2, p1, p2, k3, k4, k5, k6
    """

    eye: Vector = (0, 0, 0)
    forward: Vector = (0, 0, -1)
    up: Vector = (0, 1, 0)
    fov_y: float = 0.8
    y_extent: float = 0
    near_plane: float = 0
    far_plane: float = 0
    right: Vector = (0, 0, 0)
    shift: Tuple[float, float] = (0, 0)
    lens: str = "pinhole"
    skew: float = 0
    distortion: Sequence[float] = (0,) * 8

    @property
    def axes(self) -> np.ndarray:
        """Rows right, up and back, unit, in the world: `layers["normal"] @ camera.axes.T` is in the camera's space."""
        back = -np.asarray(self.forward, float)
        right = np.cross(self.up, back)
        frame = np.stack([right, np.cross(back, right), back])
        return frame / np.linalg.norm(frame, axis=1, keepdims=True)

    def rays(self, size: Tuple[int, int]) -> np.ndarray:
        """Unit directions in which pixels' centres of a picture of `size` are seen: (height, width, 3)."""
        sides = width_and_height(size)
        array = np.empty((max(sides["height"], 0), max(sides["width"], 0), 3), np.float32)
        call(lib.manylight_camera_rays, camera_desc(self).pointer, sides["width"], sides["height"],
             ffi.from_buffer("float[]", array, require_writable=True))
        return array

    @classmethod
    def from_intrinsics(cls, intrinsics: Any, pose: Any, size: Tuple[int, int], *, convention: str,
                        pixel_center: Optional[float] = None, near_plane: float = 0, far_plane: float = 0,
                        distortion: Any = ()) -> "Camera":
        """A pinhole camera for pictures of `size`.

        Parameters
        ----------
        intrinsics : the matrix (3, 3), or (fx, fy, cx, cy), pixels
        pose : rigid matrix (4, 4) from camera to world; for extrinsics, from world to camera, take their inverse
        size : width and height of the pictures that the intrinsics are for; pictures of other sizes keep the vertical
            angle of view, and one of another shape shows more or less at left and right
        convention : "opencv": x right, y down, z forward; "opengl": x right, y up, z back (glTF, Blender, pyrender)
        pixel_center : `cx` and `cy` of the first pixel's centre; None: 0 for "opencv", 0.5 for "opengl"
        near_plane, far_plane, distortion : as of `Camera`
        """
        if convention not in CONVENTIONS:
            raise ArgumentError(f"convention: {described(convention)} is none of {', '.join(CONVENTIONS)}")
        matrix, skew = real_array("intrinsics", intrinsics).astype(float), 0
        if matrix.shape == (3, 3):
            if not np.array_equal(matrix[[1, 2, 2, 2], [0, 0, 1, 2]], [0, 0, 0, 1]):
                raise ArgumentError("intrinsics: not [fx skew cx; 0 fy cy; 0 0 1]")
            skew = matrix[0, 1]
            matrix = matrix[[0, 1, 0, 1], [0, 1, 2, 2]]
        fx, fy, cx, cy = vector("intrinsics", matrix, 4)
        matrix = real_array("pose", pose)
        if matrix.shape != (4, 4):
            raise ArgumentError(f"pose: shape {matrix.shape}, not (4, 4)")
        if pixel_center is None:
            pixel_center = 0 if convention == "opencv" else .5
        corner = .5 - real("pixel_center", pixel_center)
        desc = Descriptor("pinhole", fx=fx, fy=fy, cx=cx + corner, cy=cy + corner, pose=matrix.ravel(),
                          axes=CONVENTIONS[convention], skew=skew, distortion=eight(distortion), **width_and_height(size))
        out = Descriptor("camera").pointer
        call(lib.manylight_camera_pinhole, desc.pointer, out)
        return dataclasses.replace(camera_of(out), near_plane=near_plane, far_plane=far_plane)


def eight(distortion: Any) -> list:
    """OpenCV's numbers of a distortion, those left out as 0."""
    array = real_array("distortion", distortion if len(np.atleast_1d(distortion)) else np.zeros(8))
    if array.ndim != 1 or len(array) not in (4, 5, 8):
        raise ArgumentError(f"distortion: {described(distortion)} is not 4, 5 or 8 numbers")
    return array.astype(float).tolist() + [0.] * (8 - len(array))


LENSES = {
    "pinhole": lib.MANYLIGHT_LENS_PINHOLE,
    "equirectangular": lib.MANYLIGHT_LENS_EQUIRECTANGULAR,
    "cube": lib.MANYLIGHT_LENS_CUBE,
    "equidistant": lib.MANYLIGHT_LENS_EQUIDISTANT,
    "equisolid": lib.MANYLIGHT_LENS_EQUISOLID,
}
CONVENTIONS = {"opencv": lib.MANYLIGHT_OPENCV, "opengl": lib.MANYLIGHT_OPENGL}

KINDS = {
    "spot": lib.MANYLIGHT_SPOT,
    "point": lib.MANYLIGHT_POINT,
    "directional": lib.MANYLIGHT_DIRECTIONAL,
    "area": lib.MANYLIGHT_AREA,
}


def rows(name: str, values: Any, width: int, kind: type) -> np.ndarray:
    """An array of rows of so many numbers, contiguous."""
    array = real_array(name, values)
    if array.ndim != 2 or array.shape[1] != width:
        raise ArgumentError(f"{name}: shape {array.shape}, not (n, {width})")
    return np.ascontiguousarray(array, kind)


def _colors(values: Any) -> np.ndarray:
    """Colours as floats from 0 to 1."""
    array = real_array("colors", values)
    if array.dtype in (np.uint8, np.uint16):
        return array / np.float32(np.iinfo(array.dtype).max)
    if array.dtype.kind in "iu" and array.size and array.max() > 1:
        raise ArgumentError(f"colors: {array.dtype} up to {array.max()}: give uint8, uint16, or floats from 0 to 1")
    return array


def _indices(values: Any) -> np.ndarray:
    array = real_array("indices", values)
    if array.dtype.kind == "f":
        raise ArgumentError(f"indices: {array.dtype}, not whole numbers")
    if array.size and (array.min() < 0 or array.max() > 0xFFFFFFFF):
        raise ArgumentError("indices: below 0 or above 4294967295")
    return rows("indices", array, 3, np.uint32)


def _png(pixels: np.ndarray) -> bytes:
    """A PNG file of (height, width, 3 or 4) bytes."""
    height, width, channels = pixels.shape

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 6, 0, 0, 0)
    lines = np.zeros((height, 1 + width * channels), np.uint8)  # Each begins with its filter: none.
    lines[:, 1:] = pixels.reshape(height, -1)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines.tobytes(), 1))
            + chunk(b"IEND", b""))


def _picture(picture: Any) -> bytes:
    """The file of a picture."""
    if isinstance(picture, (bytes, bytearray)):
        return bytes(picture)
    array = np.asarray(picture)
    if array.dtype == np.uint8 and array.ndim == 1:
        return array.tobytes()
    if array.dtype == np.uint8 and array.ndim == 3 and array.shape[2] in (3, 4) and array.size:
        return _png(array)
    raise ArgumentError(f"picture: {described(picture)} is neither a file's bytes nor uint8 (height, width, 3 or 4)")


def _mesh(mesh: Mesh) -> Descriptor:
    desc = Descriptor("mesh", material=mesh.material)
    positions = rows("positions", mesh.positions, 3, np.float32)
    desc.pointer.vertex_count = len(positions)
    arrays = {"positions": positions}
    colors = None if mesh.colors is None else _colors(mesh.colors)
    for name, values, width in (("normals", mesh.normals, 3), ("uvs", mesh.uvs, 2), ("colors", colors, 4)):
        if values is not None:
            arrays[name] = rows(name, values, width, np.float32)
            if len(arrays[name]) != len(positions):
                raise ArgumentError(f"{name}: {len(arrays[name])} rows for {len(positions)} positions")
    for name, array in arrays.items():
        desc.set(name, desc.keep(ffi.from_buffer("float[]", array)))
    if mesh.indices is not None:
        indices = _indices(mesh.indices)
        desc.pointer.index_count = indices.size
        desc.set("indices", desc.keep(ffi.from_buffer("uint32_t[]", indices)))
    return desc


def _material(material: Material) -> Descriptor:
    desc = Descriptor("material", base_color=material.base_color, metalness=material.metalness,
                      roughness=material.roughness, emission=material.emission, double_sided=material.double_sided)
    if not any(desc.pointer.base_color):
        desc.pointer.base_color[3] = 1  # All 0 would be white.
    if material.picture is not None:
        picture = _picture(material.picture)
        desc.set("picture", desc.keep(ffi.from_buffer(picture)))
        desc.pointer.picture_bytes = len(picture)
    return desc


def _light(light: Light) -> Descriptor:
    if light.kind not in KINDS:
        raise ArgumentError(f"kind: {described(light.kind)} is none of {', '.join(KINDS)}")
    return Descriptor("light", type=KINDS[light.kind], position=light.position, direction=light.direction,
                      intensity=light.intensity, extent=light.extent, inner_angle=light.inner_angle,
                      outer_angle=light.outer_angle, up=light.up)


def camera_of(out: Any) -> Camera:
    """A camera of the library's struct."""
    return Camera(tuple(out.eye), tuple(out.forward), tuple(out.up), out.fov_y, out.y_extent, out.near_plane,
                  out.far_plane, tuple(out.right), tuple(out.shift), list(LENSES)[out.lens], out.skew,
                  tuple(out.distortion))


def camera_desc(camera: Camera) -> Descriptor:
    """A camera for the library."""
    if camera.lens not in LENSES:
        raise ArgumentError(f"lens: {described(camera.lens)} is none of {', '.join(LENSES)}")
    return Descriptor("camera", **{**vars(camera), "lens": LENSES[camera.lens], "distortion": eight(camera.distortion)})


MAKERS = {"mesh": (Mesh, _mesh), "material": (Material, _material), "light": (Light, _light),
          "camera": (Camera, camera_desc)}


def made_part(kind: str, part: Any) -> Descriptor:
    """A part for the library."""
    of, maker = MAKERS[kind]
    if not isinstance(part, of):
        raise ArgumentError(f"{described(part)} is not a manylight.{of.__name__}")
    for member in dataclasses.fields(part):
        if getattr(part, member.name) is None and member.default is not None:
            raise ArgumentError(f"{member.name}: None")
    return maker(part)


def _made(kind: str, i: int, part: Any) -> Descriptor:
    try:
        return made_part(kind, part)
    except ArgumentError as error:
        raise ArgumentError(f"{kind} {i}: {error}") from None


def add_parts(desc: Descriptor, kind: str, parts: Sequence[Any]) -> None:
    """Puts an array of structs into the descriptor of a scene: its members KINDs and KIND_count."""
    if not isinstance(parts, Iterable):
        raise ArgumentError(f"{described(parts)} is not a list of parts of the scene")
    made = [_made(kind, i, part) for i, part in enumerate(parts)]
    array = ffi.new(f"struct manylight_{kind}[]", max(len(made), 1))
    for i, part in enumerate(made):
        array[i] = part.pointer[0]
        desc.keep(part)
    desc.set("meshes" if kind == "mesh" else f"{kind}s", desc.keep(array))
    desc.set(f"{kind}_count", len(made))
