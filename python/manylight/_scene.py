"""Scenes, and the path tracer, which needs no device."""
from __future__ import annotations

import os
from functools import partial
from itertools import count
from typing import Any, Dict, Iterable, NamedTuple, Optional, Sequence, Tuple

from ._call import (Descriptor, Progress, Work, call, described, encode, made, real, real_array, run, whole,
                    width_and_height)
from ._cffi import ffi, lib
from ._errors import ArgumentError, text_of
from ._image import SURFACE_LAYERS, TRACED_LAYERS, Layers, layer_of, listed, to_layers
from ._names import settings_text
from ._parts import Camera, Light, Material, Mesh, add_parts, camera_desc, camera_of, made_part


class SceneInfo(NamedTuple):
    """What a scene holds. Lengths are in metres, `duration` is in seconds."""

    triangles: int
    materials: int
    lights: int
    cameras: int
    center: Tuple[float, float, float]
    radius: float
    duration: float
    origin: Tuple[float, float, float]


KINDS_OF_IDS = ("node", "mesh", "material")


def number(part: str, value: Any) -> int:
    """The number of a part."""
    if not 0 <= whole(part, value) < 1 << 32:
        raise ArgumentError(f"{part}: {value} is no number of a part")
    return whole(part, value)


class Scene:
    """A scene: a glTF file, its bytes, or arrays. Any threads may use it at once; its parts change between calls.

    Parameters
    ----------
    source : path of a .glb or .gltf file, or the file's bytes; None: from meshes
    path : with bytes, the path whose folder has the files that they name
    meshes, materials, lights, cameras : parts of a scene from arrays (`Mesh`, `Material`, `Light`, `Camera`)
    light, clip, environment, environment_turn (degrees), environment_strength, strict, root, scene, variant,
        punctual_scale : as the options of `manylight render`
    """

    def __init__(self, source: "str | os.PathLike[str] | bytes | None" = None, *,
                 path: "str | os.PathLike[str] | None" = None, meshes: Sequence[Mesh] = (),
                 materials: Sequence[Material] = (), lights: Sequence[Light] = (), cameras: Sequence[Camera] = (),
                 light: Optional[str] = None, clip: Optional[str] = None,
                 environment: "str | os.PathLike[str] | None" = None, environment_turn: float = 0,
                 environment_strength: float = 1, strict: bool = False,
                 root: "str | os.PathLike[str] | None" = None, scene: Optional[str] = None,
                 variant: Optional[str] = None, punctual_scale: float = 1):
        if environment_strength == 0:
            raise ArgumentError("environment_strength: 0 is not above 0")
        if punctual_scale == 0:
            raise ArgumentError("punctual_scale: 0 is not above 0")
        desc = Descriptor("scene_desc", path=path, light=light, clip=clip, environment=environment,
                          environment_turn=environment_turn, environment_strength=environment_strength,
                          strict=strict, root=root, scene=scene, variant=variant, punctual_scale=punctual_scale)
        if isinstance(source, (bytes, bytearray, memoryview)):
            memory = desc.keep(ffi.from_buffer(source))
            desc.set("memory", memory)
            desc.set("memory_bytes", len(memory))
        else:
            desc.set("path", source)
        for kind, parts in (("mesh", meshes), ("material", materials), ("light", lights), ("camera", cameras)):
            add_parts(desc, kind, parts)
        self._handle = made("scene", lib.manylight_scene_open, desc.pointer)

    def __repr__(self) -> str:
        return f"<manylight.Scene of {self.info.triangles} triangles, {self.info.lights} lights>"

    @property
    def info(self) -> SceneInfo:
        """What the scene holds."""
        info = Descriptor("scene_info").pointer
        call(lib.manylight_scene_info, self._handle, info)
        return SceneInfo(info.triangle_count, info.material_count, info.light_count, info.camera_count,
                         tuple(info.center), info.radius, info.duration, tuple(info.origin))

    def names(self, kind: str) -> Dict[int, str]:
        """Names by the numbers in the layer "id.KIND": of "node", "mesh" or "material". Unnamed parts have ""."""
        if kind not in KINDS_OF_IDS:
            raise ArgumentError(f"kind: {described(kind)} is none of {', '.join(KINDS_OF_IDS)}")
        part = KINDS_OF_IDS.index(kind)
        name = partial(lib.manylight_scene_name, self._handle, part)
        return {i: text_of(text) for i, text in enumerate(iter(map(name, count(1)).__next__, ffi.NULL), 1)}

    def set_node(self, node: int, matrix: Any) -> None:
        """Places a node, by its number in the layer "id.node": `matrix` (4, 4) from the node to its parent.

        Renderers and `reference` show changes from the next frame on, with the bits of a scene opened with them. The
        first frame after changes costs a new layout of the scene. Scenes with clips do not change. A change is refused
        while another thread's call uses the scene.
        """
        array = real_array("matrix", matrix)
        if array.shape != (4, 4):
            raise ArgumentError(f"matrix: {described(matrix)} is not of shape (4, 4)")
        numbers = ffi.new("double[16]", array.astype(float).ravel().tolist())
        call(lib.manylight_scene_set_node, self._handle, number("node", node), numbers)

    def set_mesh(self, mesh: int, to: Mesh) -> None:
        """Replaces the triangles of a mesh, by its number in the layer "id.mesh". It keeps its material."""
        self._set(lib.manylight_scene_set_mesh, "mesh", mesh, to)

    def _set(self, function: Any, kind: str, part: int, to: Any) -> None:
        desc = made_part(kind, to)  # which keeps the arrays
        call(function, self._handle, number(kind, part), desc.pointer)

    def set_material(self, material: int, to: Material) -> None:
        """Replaces the numbers of a material, by its number in the layer "id.material". It keeps its pictures."""
        self._set(lib.manylight_scene_set_material, "material", material, to)

    def set_sky(self, path: "str | os.PathLike[str] | None" = None, *, turn: float = 0, strength: float = 1) -> None:
        """Replaces the environment, or turns it (degrees) and makes it stronger from how it was opened, if `path` is
        None."""
        if strength == 0:
            raise ArgumentError("strength: 0 is not above 0")
        call(lib.manylight_scene_set_sky, self._handle, ffi.NULL if path is None else ffi.new("char[]", encode(path)),
             real("turn", turn), real("strength", strength))

    def camera(self, text: "str | int | None" = None, time: float = 0) -> Camera:
        """Where a camera is at a time (s): name, number or `text` of `manylight render --camera`; None: the first."""
        out = Descriptor("camera").pointer
        name = ffi.NULL if text is None else ffi.new("char[]", encode(camera_text(text)))
        call(lib.manylight_scene_camera, self._handle, name, real("time", time), out)
        return camera_of(out)


def scene_of(scene: "Scene | str | os.PathLike[str]") -> Scene:
    """A scene, opened where it is a path."""
    return scene if isinstance(scene, Scene) else Scene(scene)


def camera_text(camera: Any) -> str:
    """The name or the number of a camera, as text."""
    try:
        return camera if isinstance(camera, str) else str(whole("camera", camera))
    except ArgumentError:
        raise ArgumentError(f"camera: {described(camera)} is neither a Camera, nor a name or a number") from None


def view_of(work: Work, camera: "str | int | Camera | None", light: Optional[str], time: float,
            motion_step: float = 0, next_camera: Optional[Camera] = None,
            previous_camera: Optional[Camera] = None) -> Descriptor:
    """Where from, and what of a scene, a picture is made."""
    desc = Descriptor("view", light=light, time=time, step=motion_step, progress=lib.manylight_python_progress,
                      user=work.handle)
    for member, other in (("placed_next", next_camera), ("placed_previous", previous_camera)):
        if other is not None:
            if not isinstance(other, Camera) or not isinstance(camera, Camera):
                raise ArgumentError("next_camera, previous_camera: a Camera each, and camera one too")
            desc.set(member, desc.keep(camera_desc(other)).pointer)
    if isinstance(camera, Camera):
        desc.set("placed", desc.keep(camera_desc(camera)).pointer)
    elif camera is not None:
        desc.set("camera", camera_text(camera))
    return desc


def reference(scene: "Scene | str | os.PathLike[str]", size: Tuple[int, int] = (0, 0), *,
              layers: Optional[Iterable[str]] = None, camera: "str | int | Camera | None" = None,
              light: Optional[str] = None, time: float = 0, bounces: int = 1, samples: int = 0, noise: float = 0,
              paths: int = 0, seed: int = 0, light_paths: int = 0, smooth: bool = False, centers: bool = False,
              seen: bool = False, denoise: bool = False, hide_environment: bool = False, ao_distance: float = 0,
              materials: Optional[str] = None, threads: int = 0,
              motion_step: float = 0, next_camera: Optional[Camera] = None,
              previous_camera: Optional[Camera] = None, settings: Any = None, progress: Optional[Progress] = None,
              **more: Any) -> Layers:
    """Path-traces a scene on the CPU, as `manylight reference` does.

    Parameters
    ----------
    scene : a `Scene`, or the path of a .glb or .gltf file
    size : width and height, pixels; 0: those of the camera, 800 along the longer side
    bounces : number of indirect bounces; 0: direct light only
    samples : samples per pixel (`--spp`); 0: by `noise`, the limit of the relative standard error (0: 0.01)
    paths : paths of indirect light per sample; 0: 1 below 16 samples per pixel, else 4
    light_paths : light paths that trace caustics; 0: none. They set `smooth`
    smooth : glass and mirrors show the scene
    centers : samples at the centres of pixels alone, without antialiasing
    seen : add the layers "unshadowed" and "visibility" of the lights
    denoise : filter the noise of indirect light
    materials : "full" or "diffuse"; None: "full"
    threads : number of threads; 0: all cores. The picture does not depend on it
    ao_distance : distance of ambient occlusion, metres; 0: no layer "ao"
    settings, **more : settings of the medium, as of `Device.render`
    progress : called with the fraction done and a note; an exception from it stops the work
    Other parameters are those of `Device.render`. There is no technique: paths are traced.

    Returns the layers as `Device.render`, with "standard_error" of the layer "indirect" and others.
    """
    if "spp" in more:
        raise ArgumentError("spp: the parameter is called samples")
    work, wanted = Work(progress), listed(layers)
    for layer in wanted or ():
        if layer not in SURFACE_LAYERS and layer_of(layer) not in TRACED_LAYERS:
            raise ArgumentError(f"layers: {layer!r} is none of {', '.join(TRACED_LAYERS + SURFACE_LAYERS)}")
    view = view_of(work, camera, light, time, motion_step, next_camera, previous_camera)
    surfaces = ",".join(layer for layer in wanted or () if layer in SURFACE_LAYERS)
    desc = Descriptor("reference_desc", **width_and_height(size), view=view.pointer, bounces=bounces, samples=samples,
                      noise=noise, paths=paths, seed=seed, light_paths=light_paths, smooth=smooth, centers=centers,
                      seen=seen, denoise=denoise, hide_environment=hide_environment, ao_distance=ao_distance,
                      materials=materials, settings=settings_text(settings, more), threads=threads,
                      outputs=surfaces or None)
    handle = scene_of(scene)._handle
    return run(work, lambda: to_layers(made("image", lib.manylight_reference, handle, desc.pointer), wanted))
