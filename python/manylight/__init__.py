"""manylight: real-time global illumination by many lights.

    import manylight

    with manylight.Device(allow_software=True) as device:
        layers = device.render("scene.glb", (400, 400), quality="high")
    reference = manylight.reference("scene.glb", (400, 400), noise=.05)
    print(manylight.compare(layers, reference, layer="indirect"))

Pictures are dicts of numpy arrays, which own their memory. Calls release the GIL. Errors are exceptions below `Error`,
with the words of the program. Messages go to the logger "manylight".
"""
from ._device import Device, DeviceInfo, Renderer
from ._errors import (ArgumentError, Cancelled, DeviceError, Error, FileMissing, OutOfMemory, SceneError,
                      SettingError)
from ._image import Layers, compare, error_map, matte, read, write
from ._names import (Setting, devices, direct_methods, metrics, qualities, settings, techniques,
                     version)
from ._parts import Camera, Light, Material, Mesh
from ._scene import Scene, SceneInfo, reference

__all__ = [
    "ArgumentError", "Camera", "Cancelled", "Device", "DeviceError", "DeviceInfo", "Error", "FileMissing", "Layers",
    "Light", "Material", "Mesh", "OutOfMemory", "Renderer", "Scene", "SceneError", "SceneInfo", "Setting", "SettingError",
    "compare", "devices", "direct_methods", "error_map", "matte", "metrics", "qualities", "read", "reference",
    "settings", "techniques", "version", "write",
]
