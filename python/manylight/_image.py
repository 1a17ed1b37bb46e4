"""Images of the library as dicts of numpy arrays."""
from __future__ import annotations

import os
from typing import Any, Dict, Iterable, List, Mapping, Optional, Tuple, Union

import numpy as np

from ._call import Descriptor, call, described, encode, made, real_array
from ._cffi import ffi, lib
from ._errors import ArgumentError, text_of

#: Layers of surfaces, of frames and of references, that are made where `layers` names them.
SURFACE_LAYERS = ("id.node", "id.mesh", "id.material", "position", "depth", "uv", "motion.next", "motion.previous",
                  "crypto.node", "crypto.mesh", "crypto.material")
#: The other layers of references. Some need an option, or a scene that has them.
TRACED_LAYERS = ("beauty", "Z", "direct", "indirect", "albedo", "normal", "standard_error", "emitted", "specular",
                 "airlight", "ao", "unshadowed", "visibility", "caustic", "volume")
MATTES = SURFACE_LAYERS[-3:]
RANKS = 3  # layers of a matte in a file, of two ids each

Layers = Dict[str, np.ndarray]
Picture = Union[Mapping[str, np.ndarray], np.ndarray]


def layer_of(channel: str) -> str:
    """The layer that a channel belongs to: "beauty" of R, "indirect" of indirect.R, "Z" of Z."""
    if channel in ("R", "G", "B", "A"):
        return "beauty"
    if channel.startswith("id."):
        return channel
    if channel.startswith("crypto_"):  # crypto_node00.r
        return f"crypto.{channel[7:-4]}"
    return channel.rpartition(".")[0] or channel


def layer_names(image: Any) -> List[str]:
    """The layers of an image, in their order."""
    count = lib.manylight_image_channel_count(image)
    names = (text_of(lib.manylight_image_channel(image, i)) for i in range(count))
    return list(dict.fromkeys(map(layer_of, names)))


def read_layer(image: Any, layer: str) -> np.ndarray:
    """Copies a layer into an array that owns its memory."""
    name = encode(layer)
    count = ffi.new("int *")
    call(lib.manylight_image_layer, image, name, ffi.NULL, 0, count)
    height, width = lib.manylight_image_height(image), lib.manylight_image_width(image)
    shape = (height, width) if count[0] == 1 else (height, width, count[0])
    array = np.empty(shape, np.float32)
    pixels = ffi.from_buffer("float[]", array, require_writable=True)
    call(lib.manylight_image_layer, image, name, pixels, array.size, count)
    return array.astype(np.uint32) if layer.startswith("id.") else array


def read_mattes(image: Any, layer: str) -> np.ndarray:
    """Copies the ranks of a Cryptomatte layer: (height, width, 6, 2), id and coverage."""
    ranks = [read_layer(image, f"{layer.replace('.', '_')}0{i}") for i in range(RANKS)]
    return np.concatenate(ranks, 2).reshape(*ranks[0].shape[:2], 6, 2)


def matte(layer: np.ndarray, name: str) -> np.ndarray:
    """The fraction of each pixel that parts of a name cover, from a Cryptomatte layer: float32 (height, width). A part
    without a name is called by kind and number: "node 3"."""
    if np.shape(layer)[2:] != (2 * RANKS, 2):
        raise ArgumentError(f"matte: {described(layer)} is no Cryptomatte layer (height, width, {2 * RANKS}, 2)")
    ids, covered = np.ascontiguousarray(layer[..., 0], np.float32).view(np.uint32), layer[..., 1]
    return np.where(ids == lib.manylight_matte_id(encode(name)), covered, np.float32(0)).sum(-1)


def listed(layers: "str | Iterable[str] | None") -> Optional[List[str]]:
    """Names of layers, of which one may stand alone; None: all."""
    if layers is None or isinstance(layers, str):
        return [layers] if layers else None
    names = list(layers) if isinstance(layers, Iterable) else [layers]
    for name in names:
        if not isinstance(name, str):
            raise ArgumentError(f"layers: {described(name)} is not the name of a layer")
    return names


def to_layers(image: Any, layers: "str | Iterable[str] | None" = None) -> Layers:
    """Some layers of an image, or all."""
    wanted = listed(layers)
    wanted = layer_names(image) if wanted is None else wanted
    return {layer: read_mattes(image, layer) if layer in MATTES else read_layer(image, layer)
            for layer in wanted}


def channels_of(layer: str, count: int) -> List[str]:
    """Names of channels, as the program writes them."""
    if layer in MATTES and count == 4 * RANKS:
        return [f"{layer.replace('.', '_')}0{i}.{letter}" for i in range(RANKS) for letter in "rgba"]
    letters = {1: "", 2: "UV" if layer == "uv" else "XY", 3: "XYZ" if layer in ("normal", "position") else "RGB", 4: "RGBA"}.get(count)
    if letters is None:
        raise ArgumentError(f"layer {layer}: {count} channels (1 to 4)")
    if layer == "beauty":
        return list(letters or "R")
    return [f"{layer}.{letter}" for letter in letters] or [layer]


def to_image(layers: Picture) -> Any:
    """An image of the library from a dict of arrays, or from an array: its beauty."""
    if not isinstance(layers, Mapping):
        layers = {"beauty": layers}
    arrays, names = [], []
    for layer, array in layers.items():
        array = real_array(f"layer {layer}", array)
        if layer == "beauty" and array.dtype == np.uint8:
            raise ArgumentError("layer beauty: uint8 is the code of a display, not linear light")
        if layer.startswith("id.") and array.size and not (0 <= array.min() and array.max() < 1 << 24):
            raise ArgumentError(f"layer {layer}: numbers are not from 0 to {(1 << 24) - 1}")
        array = array.astype(np.float32)
        array = array[..., None] if array.ndim == 2 else array
        array = array.reshape(*array.shape[:2], -1) if layer in MATTES else array
        if array.ndim != 3 or array.shape[:2] != (arrays or [array])[0].shape[:2]:
            raise ArgumentError(f"layer {layer}: shape {array.shape}, not (height, width[, channels]) as of others")
        names += channels_of(layer, array.shape[2])
        arrays.append(array)
    if not arrays:
        raise ArgumentError("an image without layers")
    pixels = np.ascontiguousarray(np.concatenate(arrays, axis=2))
    height, width = pixels.shape[:2]
    return made("image", lib.manylight_image_create, width, height, " ".join(names).encode(),
                ffi.from_buffer("float[]", pixels))


def read(path: "str | os.PathLike[str]", layers: Optional[Iterable[str]] = None) -> Layers:
    """Reads a picture (EXR, PFM, PNG, ...).

    Returns a dict from layer to float32 array, row 0 at the top: (height, width, channels), or (height, width) for
    layers with one channel. `layers` names those to return; None: all.
    """
    return to_layers(made("image", lib.manylight_image_read, encode(path)), layers)


def write(path: "str | os.PathLike[str]", layers: Picture) -> None:
    """Writes all layers (EXR), or red, green and blue of "beauty" (PFM, HDR). The file appears when it is whole."""
    call(lib.manylight_image_write, to_image(layers), encode(path))


def _grey(picture: Picture) -> Picture:
    """An array (height, width) as one of three equal channels."""
    if isinstance(picture, Mapping) or np.ndim(picture) != 2:
        return picture
    return np.repeat(np.asarray(picture)[..., None], 3, axis=2)


def _compare(test: Picture, reference: Picture, options: Dict[str, Any], with_map: bool) -> Tuple[float, Any]:
    first, second = (to_image(_grey(picture)) for picture in (test, reference))
    desc, value = Descriptor("compare_desc", **options), ffi.new("double *")
    errors, pixels = None, ffi.NULL
    if with_map:
        errors = np.empty((lib.manylight_image_height(first), lib.manylight_image_width(first)), np.float32)
        pixels = ffi.from_buffer("float[]", errors, require_writable=True)
    call(lib.manylight_compare, first, second, desc.pointer, value, pixels)
    return value[0], errors


def compare(test: Picture, reference: Picture, *, layer: Optional[str] = None,
            reference_layer: Optional[str] = None, metric: Optional[str] = None, pixels_per_degree: float = 0,
            threads: int = 0) -> float:
    """The error of a picture against a reference, as `manylight compare` prints it.

    Parameters
    ----------
    test, reference : dicts of layers as `Device.render` and `reference` return them, or an array (height, width, 3) or
        (height, width)
    layer : layer to compare, for example "indirect"; None: "beauty"
    reference_layer : the reference's layer; None: the same
    metric : a name of `manylight.metrics()`; None: "relative-rmse"
    pixels_per_degree : resolution of the display for FLIP; 0: 67.0206
    threads : number of threads; 0: all cores. The result does not depend on it.
    """
    options = dict(layer=layer, reference_layer=reference_layer, metric=metric,
                   pixels_per_degree=pixels_per_degree, threads=threads)
    return _compare(test, reference, options, False)[0]


def error_map(test: Picture, reference: Picture, **options: Any) -> Tuple[float, np.ndarray]:
    """The error as of `compare`, with the same parameters, and the error of each pixel: float32 (height, width)."""
    return _compare(test, reference, options, True)
