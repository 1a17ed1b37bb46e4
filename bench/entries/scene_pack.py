"""Scene packs of `manylight export` for renderers with a scene language of their own, and the method.json of an entry.

Surfaces are diffuse, smooth metal or clear glass, of one colour, and may shine. Other packs are refused.
"""
import hashlib
import json
import os
import statistics
import struct
import sys


class Glb:
    """Reads the project's GLBs: accessors without sparse parts."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20 : 20 + size])
        self.bytes = data[28 + size :]
        self.meshes = []
        for root in self.json["scenes"][self.json.get("scene", 0)]["nodes"]:
            self.walk(root, [[float(i == j) for j in range(4)] for i in range(4)])

    def read(self, number):
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        count = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        letter = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}[accessor["componentType"]]
        stride = view.get("byteStride", struct.calcsize(letter) * count)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return [struct.unpack_from(f"<{count}{letter}", self.bytes, start + i * stride)
                for i in range(accessor["count"])]

    def walk(self, number, parent):
        node = self.json["nodes"][number]
        world = multiply(parent, matrix_of(node))
        for primitive in self.json["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            self.meshes.append(Mesh(self, primitive, world))
        for child in node.get("children", []):
            self.walk(child, world)


class Mesh:
    """Points, normals (None: flat) and faces in the world, and the surface."""

    def __init__(self, glb, primitive, world):
        attributes = primitive["attributes"]
        self.points = [apply(world, point, 1) for point in glb.read(attributes["POSITION"])]
        # Supports rotations and uniform scales only.
        self.normals = ([apply(world, normal, 0) for normal in glb.read(attributes["NORMAL"])]
                        if "NORMAL" in attributes else None)
        indices = ([row[0] for row in glb.read(primitive["indices"])] if "indices" in primitive
                   else list(range(len(self.points))))
        self.faces = [tuple(indices[i : i + 3]) for i in range(0, len(indices), 3)]
        self.surface = Surface(glb.json["materials"][primitive["material"]])


class Surface:
    """kind: diffuse, mirror, glass, or why it is none of them. radiance: of its front, W/(sr m2)."""

    def __init__(self, material):
        surface, more = material.get("pbrMetallicRoughness", {}), material.get("extensions", {})
        self.color = surface.get("baseColorFactor", [1, 1, 1, 1])[:3]
        strength = more.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
        self.radiance = [strength * value for value in material.get("emissiveFactor", [0, 0, 0])]
        self.double_sided = material.get("doubleSided", False)
        self.ior = more.get("KHR_materials_ior", {}).get("ior", 1.5)
        volume = more.get("KHR_materials_volume", {})
        self.attenuation = (volume.get("attenuationDistance", 1), volume.get("attenuationColor", [1, 1, 1]))
        metalness, roughness = surface.get("metallicFactor", 1), surface.get("roughnessFactor", 1)
        if any(name.endswith("Texture") for name in [*surface, *material]):
            self.kind = "textures"
        elif more.get("KHR_materials_transmission", {}).get("transmissionFactor", 0) == 1:
            self.kind = "glass" if "KHR_materials_volume" in more and roughness == 0 else "thin or rough glass"
        elif metalness == 0 and roughness == 1:
            self.kind = "diffuse"
        else:
            self.kind = "mirror" if metalness == 1 and roughness < .1 else "rough specular surfaces"


def matrix_of(node):
    if "matrix" in node:
        return [[node["matrix"][4 * j + i] for j in range(4)] for i in range(4)]
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    move, scale = node.get("translation", [0, 0, 0]), node.get("scale", [1, 1, 1])
    turn = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[turn[i][j] * scale[j] for j in range(3)] + [move[i]] for i in range(3)] + [[0, 0, 0, 1]]


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def apply(matrix, point, w):
    return [sum(matrix[i][j] * point[j] for j in range(3)) + w * matrix[i][3] for i in range(3)]


def stop(folder, reason):
    sys.exit(f"entry.py: {folder}: {reason}")


def sha256_of(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def open_pack(folder):
    """Returns scene.json."""
    try:
        with open(os.path.join(folder, "scene.json")) as file:
            pack = json.load(file)
    except (OSError, ValueError) as error:
        stop(folder, f"no scene pack: {error}")
    if pack.get("format") != "manylight scene pack" or pack.get("version") != 1:
        stop(folder, "no scene pack of version 1")
    if os.path.basename(pack["picture"]["file"]) != pack["picture"]["file"]:
        stop(folder, "picture.file is no plain name")
    return pack


def read_pack(folder):
    """Returns scene.json and its Glb; `materials: diffuse` makes all surfaces diffuse."""
    pack = open_pack(folder)
    glb = Glb(os.path.join(folder, pack["scene"]["file"]))
    for mesh in glb.meshes:
        if pack["picture"]["materials"] == "diffuse" and mesh.surface.kind != "textures":
            mesh.surface.kind = "diffuse"
        if not pack["emissive_surfaces"]:
            mesh.surface.radiance = [0, 0, 0]
    check(folder, pack, glb)
    return pack, glb


def check(folder, pack, glb):
    if pack["environment"]:
        stop(folder, "an environment; this script draws points, spots and emissive surfaces alone")
    for light in pack["lights"]:
        if light["type"] not in ("point", "spot") or light["shape"] != "point" or light["range"]:
            stop(folder, f"a light of type {light['type']} with a size or a range; this script draws points and spots alone")
    for mesh in glb.meshes:
        if mesh.surface.kind not in ("diffuse", "mirror", "glass"):
            stop(folder, f"{mesh.surface.kind}; this script draws diffuse colours, smooth metals and clear glass alone")
    if pack["camera"]["type"] != "perspective":
        stop(folder, "an orthographic camera; this script draws perspectives alone")


def write_method(entry, drawn, covers="the program from start to end", **fields):
    """drawn: names of pictures and their seconds. covers: what these are of."""
    times = [seconds for _, seconds in drawn]
    method = {"history_frames": 0, "denoiser": None, "hardware_rays": False, **fields,
              "ms": {"median": 1000 * statistics.median(times), "p99": None, "frames": len(times), "covers": covers},
              "sha256": {file: sha256_of(os.path.join(entry, file)) for file, _ in drawn}}
    with open(os.path.join(entry, "method.json"), "w") as file:
        json.dump(method, file, indent=1)
        file.write("\n")
