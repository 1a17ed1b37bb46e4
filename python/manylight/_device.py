"""Devices and renderers."""
from __future__ import annotations

import contextlib
import os
import threading
from typing import Any, ContextManager, Iterable, Iterator, List, Mapping, NamedTuple, Optional, Tuple, Union

import numpy as np

from ._call import Descriptor, Progress, Work, call, described, encode, is_reporting, made, real, run, width_and_height
from ._cffi import ffi, lib
from ._errors import ArgumentError, DeviceError, text_of
from ._image import Layers, layer_names, listed, to_layers
from ._lens import is_plain, resampled
from ._names import settings_text
from ._parts import Camera
from ._scene import Scene, camera_text, scene_of, view_of

AnyScene = Union[Scene, str, "os.PathLike[str]"]
VIEW_PARTS = {"camera", "light", "time", "motion_step", "next_camera", "previous_camera"}
OF_FRAMES = VIEW_PARTS | {"layers", "progress"}

AnyCamera = Union[str, int, Camera, None]


class DeviceInfo(NamedTuple):
    """Where OpenGL runs. `memory` is in bytes; 0: the driver does not tell."""

    name: str
    vendor: str
    renderer: str
    version: str
    software: bool
    memory: int


class Renderer:
    """Draws one scene in one size with one set of settings. `Device.renderer` makes it."""

    def __init__(self, device: Any, scene: Scene, desc: Descriptor):
        self._handle = made("renderer", lib.manylight_renderer_create, device, scene._handle, desc.pointer)
        self._lock = threading.Lock()
        self._process = os.getpid()
        self._shape = (0, 0)
        self._lens: Optional[Renderer] = None  # draws the pinholes of a lens
        self._parts = device, desc
        self.scene = scene

    def close(self) -> None:
        """Frees the renderer once no call uses it."""
        self._handle = self._lens = None

    def __enter__(self) -> "Renderer":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _open(self) -> Any:
        if self._handle is None:
            raise ArgumentError("the renderer is closed")
        if self._process != os.getpid():  # where another thread may have held the lock at the fork, for ever
            raise DeviceError("the renderer is of another process, which was forked: start processes by spawn")
        return self._handle

    def _alone(self) -> ContextManager:
        """Keeps other threads from drawing between a frame and its reading. A progress function does not wait for the
        frame that it reports: the library refuses its calls."""
        return contextlib.nullcontext() if is_reporting() else self._lock

    def render(self, *, layers: Optional[Iterable[str]] = None, camera: AnyCamera = None,
               light: Optional[str] = None, time: float = 0, motion_step: float = 0,
               next_camera: Optional[Camera] = None, previous_camera: Optional[Camera] = None,
               progress: Optional[Progress] = None) -> Layers:
        """Draws a frame at a time (s) and returns its layers, as `Device.render`."""
        renderer, work, wanted = self._open(), Work(progress), listed(layers)
        if isinstance(camera, str) and any(word in camera for word in ("lens=", "skew=", "distortion=")):
            camera = self.scene.camera(camera, time)
        if not is_plain(camera):
            with self._alone():
                self._shape = (0, 0)
                return self._resampled(camera, wanted, light, time, progress)
        view = view_of(work, camera, light, time, motion_step, next_camera, previous_camera)

        def draw() -> Layers:
            call(lib.manylight_render, renderer, view.pointer)
            image = self._image(renderer, wanted)
            self._shape = (lib.manylight_image_height(image), lib.manylight_image_width(image))
            return to_layers(image, wanted)

        with self._alone():
            return run(work, draw)

    def _resampled(self, camera: Camera, wanted: Optional[List[str]], light: Optional[str], time: float,
                   progress: Optional[Progress]) -> Layers:
        """The frame of a camera that is no plain pinhole."""
        device, desc = self._parts
        size = desc.pointer.width, desc.pointer.height

        def draw(pinhole: Camera, sides: Tuple[int, int], layers: List[str]) -> Layers:
            made = self._lens
            if made is None or (made._parts[1].pointer.width, made._parts[1].pointer.height) != sides:
                other = desc.copied(width=sides[0], height=sides[1], keep_lights=1)
                made = self._lens = Renderer(device, self.scene, other)
            return made.render(layers=layers, camera=pinhole, light=light, time=time, progress=progress)

        if size == (0, 0):
            raise ArgumentError("size: a camera that is no plain pinhole needs one")
        return resampled(camera, size, wanted, draw)

    def _image(self, renderer: Any, wanted: Optional[List[str]]) -> Any:
        """The last frame with these layers."""
        if wanted is None:
            return made("image", lib.manylight_read, renderer, ffi.NULL)
        try:  # Z, as without a layer of every frame all of them are read
            return made("image", lib.manylight_read, renderer, encode(",".join(["Z", *wanted])))
        except ArgumentError as error:
            names = layer_names(made("image", lib.manylight_read, renderer, ffi.NULL))
            text = str(error).replace("aov: ", "layers: ", 1)
            raise ArgumentError(f"{text}; layers of every frame: {', '.join(names)}") from None

    def display(self, layer: Optional[str] = None) -> np.ndarray:
        """The last frame as a display shows it: uint8 sRGB (height, width, 4), row 0 at the top. `layer`: "beauty",
        "direct" or "indirect"; None: "beauty"."""
        renderer = self._open()
        if self._lens is not None and self._shape == (0, 0):
            raise ArgumentError("display: the last frame is of a camera that is no plain pinhole")
        name = ffi.NULL if layer is None else ffi.new("char[]", encode(layer))
        with self._alone():
            array = np.empty((*self._shape, 4), np.uint8)
            pixels = ffi.from_buffer("uint8_t[]", array, require_writable=True)
            call(lib.manylight_read_display, renderer, name, pixels, array.nbytes)
        return array

    def setting(self, name: str) -> str:
        """The value of a setting, as text."""
        text = ffi.new("char[]", 256)
        call(lib.manylight_renderer_setting, self._open(), encode(name), text, len(text))
        return text_of(text)

    def milliseconds(self, path: str = "frame") -> float:
        """Time of the last frame or of a pass of it, for example "frame/gather". Needs `timed=True`; else 0."""
        value = ffi.new("double *")
        call(lib.manylight_milliseconds, self._open(), encode(path), value)
        return value[0]


class Device:
    """An OpenGL context without a window, for any threads: their calls wait for each other.

    Parameters
    ----------
    device : EGL device by number ("2"), by CUDA's number ("cuda:2"), or "hardware"; None: the first that works
    allow_software : also take OpenGL on the CPU
    debug : a debug context, whose messages go to the logger "manylight"

    `with Device() as device:` frees it at the end.
    """

    def __init__(self, device: "str | int | None" = None, *, allow_software: bool = False, debug: bool = False):
        desc = Descriptor("device_desc", device=None if device is None else str(device),
                          allow_software=allow_software, debug=debug)
        self._handle = made("device", lib.manylight_device_create, desc.pointer)

    def close(self) -> None:
        """Frees the device once no call and no renderer uses it."""
        self._handle = None

    def __enter__(self) -> "Device":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _open(self) -> Any:
        if self._handle is None:
            raise ArgumentError("the device is closed")
        return self._handle

    def __repr__(self) -> str:
        return f"<manylight.Device {'closed' if self._handle is None else self.info.renderer}>"

    @property
    def info(self) -> DeviceInfo:
        """Names of the device and of its driver."""
        info = Descriptor("device_info").pointer
        call(lib.manylight_device_info, self._open(), info)
        texts = (text_of(text) for text in (info.name, info.vendor, info.renderer, info.version))
        return DeviceInfo(*texts, bool(info.software), info.memory)

    def renderer(self, scene: AnyScene, size: Tuple[int, int] = (0, 0), *, technique: Optional[str] = None,
                 direct: Optional[str] = None, quality: Optional[str] = None, passes: int = 0, first_pass: int = 0,
                 hide_environment: bool = False, keep_lights: bool = False, timed: bool = False,
                 camera: "str | int | None" = None, settings: Optional[Mapping[str, Any]] = None,
                 **more: Any) -> Renderer:
        """A renderer for many frames of one scene. Parameters are those of `render`, and:

        keep_lights : faster if the camera alone changes from frame to frame; the same picture
        timed : measure passes, for `Renderer.milliseconds`
        camera : the camera that gives the default size
        """
        for name in OF_FRAMES & set(more) | ({"camera"} if isinstance(camera, Camera) else set()):
            raise ArgumentError(f"{name}: pass it to Renderer.render, for each frame")
        device, opened = self._open(), scene_of(scene)
        desc = Descriptor("renderer_desc", **width_and_height(size), technique=technique, direct=direct,
                          quality=quality, settings=settings_text(settings, more), passes=passes,
                          first_pass=first_pass, hide_environment=hide_environment, keep_lights=keep_lights,
                          timed=timed, camera=None if camera is None else camera_text(camera))
        return Renderer(device, opened, desc)

    def render(self, scene: AnyScene, size: Tuple[int, int] = (0, 0), *, layers: Optional[Iterable[str]] = None,
               camera: AnyCamera = None, light: Optional[str] = None, time: float = 0, motion_step: float = 0,
               next_camera: Optional[Camera] = None, previous_camera: Optional[Camera] = None,
               progress: Optional[Progress] = None, **settings: Any) -> Layers:
        """Draws one picture, with the bits of `manylight render`.

        Parameters
        ----------
        scene : a `Scene`, or the path of a .glb or .gltf file
        size : width and height, pixels; 0: those of the camera, 800 along the longer side
        layers : names of layers and of outputs of the technique (`manylight render --aov`); None: all layers
        camera : name, number, text as of `manylight render --camera`, or a `Camera`; None: the first
        light : as `manylight render --light`, for example "0 position=0,2,0"; the error for an unknown name lists all
        time : of the animation, seconds
        motion_step : for "motion.next" and "motion.previous": time between frames, seconds; 0: 1/25
        next_camera, previous_camera : where a `Camera` is in these frames; None: the same
        progress : called with the fraction done and a note, after each of several passes and a few times a second; its
            exception stops the work
        technique, direct, quality, passes, first_pass, hide_environment : as the options of `manylight render`
        settings : dict of further settings by their names, for example {"gather.interleave": 4}
        Other keyword arguments are settings, with `_` for `.` and `-`: `gather_interleave=4`, `vpls=4096`.

        Returns a dict from layer to float32 array, row 0 at the top. "beauty" is linear radiance with coverage,
        (height, width, 4), W/(sr m2). "direct" and "indirect" are irradiance / pi without albedo, "albedo" is a
        fraction, "normal" a unit vector in the world, each (height, width, 3). "Z" is depth along the view,
        (height, width), m. "normal" and "Z" are of pixel centres; with several passes they are means.
        """
        size_camera = None if isinstance(camera, Camera) else camera
        with self.renderer(scene, size, camera=size_camera, **settings) as renderer:
            return renderer.render(layers=layers, camera=camera, light=light, time=time, motion_step=motion_step,
                                   next_camera=next_camera, previous_camera=previous_camera, progress=progress)

    def render_batch(self, scene: AnyScene, size: Tuple[int, int], views: Iterable[Any], *,
                     layers: Optional[Iterable[str]] = None, progress: Optional[Progress] = None,
                     **settings: Any) -> Iterator[Layers]:
        """Draws many views by one renderer, one dict of layers for each. Light that depends on no camera is kept while
        lights and time stay.

        Parameters
        ----------
        views : cameras as of `render`, or dicts of `camera`, `light`, `time`, `motion_step`, `next_camera` and
            `previous_camera`
        Other parameters are those of `render`.
        """
        wanted = listed(layers)
        renderer = self.renderer(scene, size, **{"keep_lights": True, **settings})

        def draw() -> Iterator[Layers]:
            with renderer:
                for view in views:
                    options = view if isinstance(view, Mapping) else {"camera": view}
                    if not VIEW_PARTS.issuperset(options):
                        raise ArgumentError(f"views: {described(view)}: the parts are {', '.join(sorted(VIEW_PARTS))}")
                    yield renderer.render(layers=wanted, progress=progress, **options)

        return draw()

    def frames(self, scene: AnyScene, size: Tuple[int, int] = (0, 0), *, frames: Optional[Iterable[int]] = None,
               fps: float = 25, layers: Optional[Iterable[str]] = None, camera: AnyCamera = None,
               light: Optional[str] = None, time: float = 0, progress: Optional[Progress] = None,
               **settings: Any) -> Iterator[Layers]:
        """Draws a sequence, one dict of layers for each frame, as `manylight render --frames`.

        Parameters
        ----------
        frames : numbers of frames; None: the whole animation of the scene
        fps : frames per second; frame n is at `time` + n / `fps` seconds
        Other parameters are those of `render`.
        """
        opened = scene_of(scene)
        fps, time = real("fps", fps), real("time", time)
        if not fps > 0:
            raise ArgumentError(f"fps: {fps} is not above 0")
        numbers = range(int(opened.info.duration * fps) + 1) if frames is None else frames
        wanted = listed(layers)
        size_camera = None if isinstance(camera, Camera) else camera
        renderer = self.renderer(opened, size, camera=size_camera, **settings)

        def draw() -> Iterator[Layers]:
            with renderer:
                for number in numbers:
                    yield renderer.render(layers=wanted, camera=camera, light=light, time=time + number / fps,
                                          motion_step=1 / fps, progress=progress)

        return draw()
