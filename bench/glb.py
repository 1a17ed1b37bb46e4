"""Makes scenes of materials that the classes of the Python module lack: a GLB in memory."""
import json
import struct

import numpy as np

import manylight


class Parts:
    """The binary part of a GLB, and what describes it."""

    def __init__(self):
        self.data, self.views, self.accessors = b"", [], []

    def add(self, array, kind, component):
        """Returns the number of the accessor."""
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": array.nbytes})
        self.data += array.tobytes()
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component, "count": len(array),
                               "type": kind})
        if kind == "VEC3":
            self.accessors[-1].update(min=array.min(0).tolist(), max=array.max(0).tolist())
        return len(self.accessors) - 1

    def primitive(self, mesh):
        attributes = {"POSITION": self.add(np.array(mesh.positions, np.float32), "VEC3", 5126)}
        if mesh.uvs is not None:
            attributes["TEXCOORD_0"] = self.add(np.array(mesh.uvs, np.float32), "VEC2", 5126)
        indices = self.add(np.array(mesh.indices, np.uint32).ravel(), "SCALAR", 5125)
        return {"attributes": attributes, "material": mesh.material, "indices": indices}


def quad(corner, right, up, material=0):
    """A rectangle, seen from where `right` turns to `up` counter-clockwise."""
    corner, right, up = (np.array(v, float) for v in (corner, right, up))
    return manylight.Mesh([corner, corner + right, corner + right + up, corner + up], [[0, 1, 2], [0, 2, 3]], material=material)


def glb(meshes, materials, **more):
    """The bytes of a GLB: meshes of one node, or a list for each mesh; materials and other members as glTF's JSON."""
    parts, groups = Parts(), meshes if isinstance(meshes[0], list) else [meshes]
    names = sorted({name for material in materials for name in material.get("extensions", {})})
    top = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
           "meshes": [{"primitives": [parts.primitive(mesh) for mesh in group]} for group in groups], "materials": materials,
           "accessors": parts.accessors, "bufferViews": parts.views, "buffers": [{"byteLength": len(parts.data)}], **more}
    text = json.dumps({**top, "extensionsUsed": names} if names else top).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sIII4s", b"glTF", 2, 28 + len(text) + len(parts.data), len(text), b"JSON") + text
            + struct.pack("<I4s", len(parts.data), b"BIN\0") + parts.data)


def open_glb(meshes, materials, environment=None, **more):
    return manylight.Scene(glb(meshes, materials, **more), environment=environment)
