"""Frames of cameras that are no plain pinholes, from pictures of pinholes.

A distorted pinhole takes one wider picture, a wide lens up to six of 90 degrees and a margin, because passes in screen
space differ at borders. They have the lens's density of pixels in its middle.
"""
from __future__ import annotations

import math
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ._errors import ArgumentError
from ._image import MATTES
from ._parts import Camera

MARGIN = 24  # pixels
# Right, up and forward of the sides of a cube, in those of the camera.
SIDES = np.array([[[0, 0, -1], [0, 1, 0], [1, 0, 0]], [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
                  [[1, 0, 0], [0, 0, -1], [0, 1, 0]], [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
                  [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[-1, 0, 0], [0, 1, 0], [0, 0, -1]]], float)


class Face(NamedTuple):
    """A picture of a pinhole: the pixels of the lens's picture that it shows, and where it has them."""

    camera: Camera
    size: Tuple[int, int]
    pixels: np.ndarray
    places: np.ndarray


def is_plain(camera: Any) -> bool:
    """Whether a frame can show the camera by itself."""
    return not isinstance(camera, Camera) or (camera.lens == "pinhole" and not camera.skew
                                              and not np.any(np.asarray(camera.distortion, float)))


def faces(camera: Camera, size: Tuple[int, int]) -> List[Face]:
    """The pictures that a camera's picture takes."""
    unit = lambda vector: np.asarray(vector, float) / np.linalg.norm(vector)
    forward = unit(camera.forward)
    right = unit(np.cross(forward, camera.up))
    axes = np.stack([right, np.cross(right, forward), forward])
    ways = camera.rays(size).reshape(-1, 3) @ axes.T
    wide = camera.lens != "pinhole"
    width, height = size
    angle = float(camera.fov_y) or .8
    density = {"equirectangular": width / (2 * math.pi), "cube": height / 2, "equidistant": height / angle,
               "equisolid": height / (4 * math.sin(angle / 4)), "pinhole": height / (2 * math.tan(angle / 2))}[camera.lens]
    toward = np.argmax(ways @ SIDES[:, 2].T, 1) if wide else np.full(len(ways), 4)
    made = []
    for side in np.unique(toward):
        pixels = np.flatnonzero(toward == side)
        local = ways[pixels] @ SIDES[side].T
        plane = local[:, :2] / local[:, 2:] * [density, -density]
        if not wide and (local[:, 2] <= 0).any():
            raise ArgumentError("distortion: pixels see backwards")
        low = np.floor(plane.min(0)) - MARGIN if not wide else np.full(2, -(math.ceil(density) + MARGIN))
        high = np.ceil(plane.max(0)) + MARGIN if not wide else -low
        across, down = (int(n) for n in high - low)
        if max(across, down) > 16384:
            raise ArgumentError(f"distortion: the wider picture has {across}x{down} pixels")
        frame = SIDES[side] @ axes
        pinhole = Camera(camera.eye, frame[2], frame[1], 2 * math.atan(down / 2 / density), 0, camera.near_plane,
                         camera.far_plane, frame[0], ((high + low) / (high - low) * [1, -1]))
        made.append(Face(pinhole, (across, down), pixels, plane - low - .5))
    return made


def _taps(face: Face) -> Tuple[np.ndarray, np.ndarray]:
    """The four pixels about each place, and their weights."""
    left, top = np.clip(np.floor(face.places), 0, np.array(face.size) - 2).astype(int).T
    u, v = face.places.T - [left, top]
    first = top * face.size[0] + left
    return (np.stack([first, first + 1, first + face.size[0], first + face.size[0] + 1]),
            np.stack([(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v]))


def _blend(layers: Dict[str, np.ndarray], face: Face) -> Dict[str, np.ndarray]:
    """Layers at the face's places. Light is bilinear and ids are the nearest. Points are those of planes where the four
    pixels are of one mesh, because they over Z are linear in a pinhole's picture, and else the nearest."""
    taps, weights = _taps(face)
    nearest = np.take_along_axis(taps, np.argmax(weights, 0)[None], 0)[0]
    flat = {name: layer.reshape(layer.shape[0] * layer.shape[1], -1) for name, layer in layers.items()}
    inverse = weights / np.maximum(flat["Z"][taps, 0], 1e-30)
    inverse /= inverse.sum(0)
    whole = np.all([(flat[name][taps, 0] == flat[name][nearest, 0]) for name in ("id.node", "id.material")], 0).all(0)
    smooth = whole & (flat["Z"][taps, 0] > 0).all(0)
    out = {}
    for name, layer in flat.items():
        if name.startswith("id."):
            out[name] = layer[nearest]
        elif name in ("Z", "position", "depth", "uv"):
            out[name] = np.where(smooth[:, None], (inverse[..., None] * layer[taps]).sum(0), layer[nearest])
        else:
            out[name] = (weights[..., None] * layer[taps]).sum(0)
    return out


def resampled(camera: Camera, size: Tuple[int, int], wanted: Optional[List[str]],
              draw: Callable[[Camera, Tuple[int, int], List[str]], Dict[str, np.ndarray]]) -> Dict[str, np.ndarray]:
    """The layers of a camera's picture. `draw` draws those of a pinhole's."""
    for name in wanted or ():
        if name.startswith("motion.") or name in MATTES:
            raise ArgumentError(f"{name}: frames have it for plain pinholes; reference has it for all cameras")
    needed = ["Z", "id.node", "id.material", "position"]
    base = ["beauty", "Z", "direct", "indirect", "albedo", "normal"]
    out: Dict[str, np.ndarray] = {}
    for face in faces(camera, size):
        layers = draw(face.camera, face.size, list(dict.fromkeys((base if wanted is None else wanted) + needed)))
        for name, layer in _blend(layers, face).items():
            whole = out.setdefault(name, np.zeros((size[1] * size[0], layer.shape[1]), layers[name].dtype))
            whole[face.pixels] = layer
    away = np.linalg.norm(out["position"] - np.asarray(camera.eye), axis=1, keepdims=True) * (out["id.node"] > 0)
    out["Z"] = np.where(camera.lens == "pinhole", out["Z"], away).astype(np.float32)
    if "depth" in out:
        out["depth"] = away.astype(np.float32)
    shaped = {name: layer.reshape(size[1], size[0], -1) for name, layer in out.items()}
    return {name: shaped[name][..., 0] if shaped[name].shape[2] == 1 else shaped[name] for name in wanted or base}
