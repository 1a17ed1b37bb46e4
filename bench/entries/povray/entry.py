"""Draws scene packs with POV-Ray's radiosity and writes an entry that bench/score.py reads.

    python3 bench/entries/povray/entry.py ENTRY PACK...

ENTRY is the folder to fill, PACK a folder that `manylight export` made. Points and spots without size, diffuse surfaces of
one colour; other packs are refused. Tried with POV-Ray 3.7.
"""
import argparse
import hashlib
import json
import math
import os
import statistics
import struct
import subprocess
import sys
import tempfile
import time

# POV-Ray's lights fade with 2 / (1 + (d / FADE)^2): far beyond FADE, metres, with the square of the distance.
FADE = 0.01


class Glb:
    """Of GLBs what the project's own have: float accessors without sparse parts."""

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
            points = [apply(world, point, 1) for point in self.read(primitive["attributes"]["POSITION"])]
            indices = ([row[0] for row in self.read(primitive["indices"])] if "indices" in primitive
                       else list(range(len(points))))
            self.meshes.append((points, indices, self.json["materials"][primitive["material"]]))
        for child in node.get("children", []):
            self.walk(child, world)


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


def vector(values, factor=1.0):
    return "<" + ",".join(f"{factor * value:.9g}" for value in values) + ">"


def refuse(folder, reason):
    sys.exit(f"entry.py: {folder}: {reason}; this script draws points, spots and diffuse colours alone")


def check(folder, pack, glb):
    if pack["environment"] or pack["emissive_surfaces"]:
        refuse(folder, "an environment or emissive surfaces")
    for light in pack["lights"]:
        if light["type"] not in ("point", "spot") or light["shape"] != "point" or light["range"]:
            refuse(folder, f"a light of type {light['type']} with a size or a range")
    for _, _, material in glb.meshes:
        if "baseColorTexture" in material.get("pbrMetallicRoughness", {}):
            refuse(folder, "textures")
    if pack["camera"]["type"] != "perspective":
        refuse(folder, "an orthographic camera")


def camera_text(camera, picture):
    length = 0.5 / math.tan(math.radians(camera["fov_y_degrees"]) / 2)
    return (f"camera {{ perspective location {vector(camera['position'])}\n direction "
            f"{vector(camera['forward'], length)} up {vector(camera['up'])}\n right "
            f"{vector(camera['right'], picture['width'] / picture['height'])} }}\n")


def light_text(light):
    """A diffuse surface of POV-Ray reflects colour x light, without 1 / pi. A spot's edge is a smoothstep of the
    cosine, moved so that the flux is the same."""
    color = vector(light["intensity"], 1 / (math.pi * 2 * FADE * FADE))
    text = (f"light_source {{ {vector(light['position'])} color rgb {color}\n"
            f" fade_distance {FADE} fade_power 2")
    if light["type"] == "spot":
        width = max(0.001, light["cos_inner"] - light["cos_outer"])
        inner = light["cos_outer"] + width
        at = [a + b for a, b in zip(light["position"], light["direction"])]
        text += (f" spotlight point_at {vector(at)} tightness 0"
                 f" radius {math.degrees(math.acos(inner)):.9g}"
                 f" falloff {math.degrees(math.acos(inner - 2 * width / 3)):.9g}")
    return text + " }\n"


def mesh_text(points, indices, material):
    color = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1, 1, 1, 1])
    faces = [indices[i : i + 3] for i in range(0, len(indices), 3)]
    return (f"mesh2 {{ vertex_vectors {{ {len(points)}, {', '.join(map(vector, points))} }}\n"
            f" face_indices {{ {len(faces)}, {', '.join('<%d,%d,%d>' % tuple(face) for face in faces)} }}\n"
            f" texture {{ pigment {{ color rgb {vector(color[:3])} }} }} }}\n")


def scene_text(pack, glb):
    bounces = pack["picture"]["bounces"]
    radiosity = (f" radiosity {{ count 800 nearest_count 10 error_bound 0.2 low_error_factor 0.5 gray_threshold 0\n"
                 f" recursion_limit {bounces} brightness 1 adc_bailout 1e-6 pretrace_start 0.08 pretrace_end 0.01 }}\n"
                 if bounces else "")
    return ("#version 3.7;\nglobal_settings { assumed_gamma 1.0 adc_bailout 1e-6\n" + radiosity + "}\n"
            "#default { finish { ambient 0 diffuse 1 } }\nbackground { color rgb 0 }\n"
            + camera_text(pack["camera"], pack["picture"]) + "".join(map(light_text, pack["lights"]))
            + "".join(mesh_text(*mesh) for mesh in glb.meshes))


def sha256_of(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def draw(folder, entry):
    try:
        with open(os.path.join(folder, "scene.json")) as file:
            pack = json.load(file)
    except (OSError, ValueError) as error:
        sys.exit(f"entry.py: {folder}: no scene pack: {error}")
    path = os.path.join(folder, pack["scene"]["file"])
    glb, picture = Glb(path), pack["picture"]
    if os.path.basename(picture["file"]) != picture["file"]:
        sys.exit(f"entry.py: {folder}: picture.file is no plain name")
    check(folder, pack, glb)
    with tempfile.NamedTemporaryFile("w", suffix=".pov", delete=False) as file:
        file.write(scene_text(pack, glb))
    command = ["povray", f"+I{file.name}", f"+O{os.path.join(entry, picture['file'])}", f"+W{picture['width']}",
               f"+H{picture['height']}", "+FE", "-D", "-GD", "-GR", "-GS", "-GW", "+A0.0", "+AM1", "+R4", "-J"]
    start = time.monotonic()
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    except OSError as error:
        sys.exit(f"entry.py: povray does not start: {error}")
    finally:
        os.unlink(file.name)
    seconds = time.monotonic() - start
    if done.returncode:
        sys.exit(f"entry.py: {folder}: povray fails:\n{done.stderr[-2000:]}")
    return picture["file"], seconds


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("entry")
    parser.add_argument("packs", nargs="+")
    arguments = parser.parse_args()
    os.makedirs(arguments.entry, exist_ok=True)
    drawn = [draw(folder, arguments.entry) for folder in arguments.packs]
    method = {
        "name": "POV-Ray radiosity",
        "version": "3.7",
        "url": "https://www.povray.org",
        "licence": "AGPL-3.0-or-later",
        "ms": {"median": 1000 * statistics.median(seconds for _, seconds in drawn), "p99": None,
               "frames": len(drawn), "covers": "the program from start to end"},
        "history_frames": 0,
        "denoiser": None,
        "hardware_rays": False,
        "sha256": {file: sha256_of(os.path.join(arguments.entry, file)) for file, _ in drawn},
    }
    with open(os.path.join(arguments.entry, "method.json"), "w") as file:
        json.dump(method, file, indent=1)
        file.write("\n")


main()
