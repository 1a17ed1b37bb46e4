"""Reads what manylight export wrote with readers of its own, and compares it with the GLB.

    check_export.py mitsuba|pack FOLDER SCENE.glb

Triangles with their colours and emission, the camera by where it projects points, and the lights. Of GLBs it knows what
the project's own have: plain float accessors, one picture each, no animation.
"""
import json
import math
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree

checks = 0


def check(name, value, wanted, tolerance=1e-5):
    global checks
    checks += 1
    pairs = list(zip(value, wanted, strict=True)) if isinstance(wanted, (list, tuple)) else [(value, wanted)]
    for a, b in pairs:
        if not abs(a - b) <= tolerance * max(1, abs(b)):
            sys.exit(f"{name}: {value}, not {wanted}")


# --- vectors ----------------------------------------------------------------------------------------


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def multiply(a, b):
    """4 x 4, by rows."""
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def apply(matrix, point, w=1):
    return [dot(row[:3], point) + w * row[3] for row in matrix[:3]]


# --- GLB --------------------------------------------------------------------------------------------


def node_matrix(node):
    if "matrix" in node:
        m = node["matrix"]
        return [[m[4 * j + i] for j in range(4)] for i in range(4)]
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    t, s = node.get("translation", [0, 0, 0]), node.get("scale", [1, 1, 1])
    turn = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[turn[i][j] * s[j] for j in range(3)] + [t[i]] for i in range(3)] + [[0, 0, 0, 1]]


class Glb:
    def __init__(self, path):
        data = open(path, "rb").read()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20 : 20 + size])
        self.bytes = data[28 + size :]
        self.triangles, self.lights, self.camera = [], [], None
        for root in self.json["scenes"][self.json.get("scene", 0)]["nodes"]:
            self.walk(root, [[float(i == j) for j in range(4)] for i in range(4)])

    def read(self, number):
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        count = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        letter = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}[accessor["componentType"]]
        width = struct.calcsize(letter) * count
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width)
        rows = [struct.unpack_from(f"<{count}{letter}", self.bytes, start + i * stride)
                for i in range(accessor["count"])]
        return [row[0] for row in rows] if count == 1 else [list(row) for row in rows]

    def walk(self, number, parent):
        node = self.json["nodes"][number]
        world = multiply(parent, node_matrix(node))
        if "mesh" in node:
            for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
                self.add_primitive(primitive, world)
        if "camera" in node and not self.camera:
            self.camera = (self.json["cameras"][node["camera"]], world)
        light = node.get("extensions", {}).get("KHR_lights_punctual")
        if light:
            self.lights.append((self.json["extensions"]["KHR_lights_punctual"]["lights"][light["light"]], world))
        for child in node.get("children", []):
            self.walk(child, world)

    def add_primitive(self, primitive, world):
        points = [apply(world, point) for point in self.read(primitive["attributes"]["POSITION"])]
        indices = self.read(primitive["indices"]) if "indices" in primitive else list(range(len(points)))
        material = self.json["materials"][primitive["material"]]
        surface = material.get("pbrMetallicRoughness", {})
        color = None if "baseColorTexture" in surface else surface.get("baseColorFactor", [1, 1, 1, 1])[:3]
        strength = material.get("extensions", {}).get("KHR_materials_emissive_strength", {})
        emission = [x * strength.get("emissiveStrength", 1) for x in material.get("emissiveFactor", [0, 0, 0])]
        double = material.get("doubleSided", False)
        for i in range(0, len(indices), 3):
            if len(set(indices[i : i + 3])) == 3:
                self.triangles.append(([points[k] for k in indices[i : i + 3]], color, emission, double))


# --- PLY --------------------------------------------------------------------------------------------


def read_ply(path):
    data = open(path, "rb").read()
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().split("\n")
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"], path
    vertices = int(re.search(r"element vertex (\d+)", head.decode()).group(1))
    faces = int(re.search(r"element face (\d+)", head.decode()).group(1))
    width = sum(line.startswith("property float") for line in lines)
    rows = [struct.unpack_from(f"<{width}f", body, 4 * width * i) for i in range(vertices)]
    start = 4 * width * vertices
    assert len(body) == start + 13 * faces, f"{path}: of another length than its head says"
    triangles = []
    for i in range(faces):
        count, a, b, c = struct.unpack_from("<Biii", body, start + 13 * i)
        assert count == 3 and max(a, b, c) < vertices and min(a, b, c) >= 0, path
        triangles.append([list(rows[k][:3]) for k in (a, b, c)])
        for k in (a, b, c):
            check(f"{path}: length of a normal", dot(rows[k][3:6], rows[k][3:6]), 1, 1e-4)
    return triangles


# --- what both must have ----------------------------------------------------------------------------

CELL = 1e-3


def cell_of(points, offset):
    middle = [sum(point[axis] for point in points) / 3 for axis in range(3)]
    return tuple(math.floor(x / CELL) + d for x, d in zip(middle, offset))


def is_same(a, b):
    return any(all(max(map(abs, sub(a[k], b[(k + turn) % 3]))) < 2e-5 for k in range(3)) for turn in range(3))


def compare_triangles(glb, meshes):
    """meshes: (triangles, colour or None, emission, whether both sides reflect or shine)."""
    wanted = {}
    for triangle in glb.triangles:
        wanted.setdefault(cell_of(triangle[0], (0, 0, 0)), []).append(triangle)
    around = [(x, y, z) for x in (0, -1, 1) for y in (0, -1, 1) for z in (0, -1, 1)]
    found = 0
    for triangles, color, emission, double in meshes:
        for points in triangles:
            near = [(wanted.get(cell_of(points, offset), []), offset) for offset in around]
            for list_of, _ in near:
                match = next((t for t in list_of if is_same(points, t[0])), None)
                if match:
                    break
            else:
                sys.exit(f"a triangle of no mesh: {points}")
            list_of.remove(match)
            found += 1
            if color is not None or match[1] is not None:
                check("colour", color, match[1])
            check("emission", emission, match[2])
            if double is not None:
                check("both sides", double, match[3])
    check("triangles", found, len(glb.triangles))


def glb_place(glb, point, aspect):
    """Where the camera sees a point: from -1 to 1, x to the right, y up."""
    source, world = glb.camera
    right, up, back = ([world[i][axis] for i in range(3)] for axis in range(3))
    offset = sub(point, [world[i][3] for i in range(3)])
    half = math.tan(source["perspective"]["yfov"] / 2)
    depth = -dot(offset, back)
    return [dot(offset, right) / depth / half / aspect, dot(offset, up) / depth / half]


def compare_places(glb, place, aspect):
    eye = [glb.camera[1][i][3] for i in range(3)]
    forward = [-glb.camera[1][i][2] for i in range(3)]
    seen = 0
    for points, *_ in glb.triangles[:: max(1, len(glb.triangles) // 50)]:
        if dot(sub(points[0], eye), forward) > 0.1:
            check("place in the picture", place(points[0]), glb_place(glb, points[0], aspect), 1e-4)
            seen += 1
    assert seen > 3, "too few points before the camera"


def flux(falloff):
    """Over all directions, over 2 pi."""
    steps = 20000
    return sum(falloff(math.pi * (i + 0.5) / steps) * math.sin(math.pi * (i + 0.5) / steps)
               for i in range(steps)) * math.pi / steps


def glb_falloff(light):
    spot = light["spot"]
    inner, outer = math.cos(spot.get("innerConeAngle", 0)), math.cos(spot.get("outerConeAngle", math.pi / 4))
    return lambda a: min(1, max(0, (math.cos(a) - outer) / max(0.001, inner - outer))) ** 2


def compare_lights(glb, lights):
    """lights: (type, position, direction, intensity, falloff)."""
    check("lights", len(lights), len(glb.lights))
    for (kind, position, direction, intensity, falloff), (light, world) in zip(lights, glb.lights):
        assert kind == light["type"], (kind, light["type"])
        color = light.get("color", [1, 1, 1])
        check("intensity", intensity, [light.get("intensity", 1) * x for x in color])
        if kind != "directional":
            check("position of a light", position, [world[i][3] for i in range(3)])
        if kind != "point":
            check("direction of a light", unit(direction), unit([-world[i][2] for i in range(3)]))
        if kind == "spot":
            check("flux of a spot", flux(falloff), flux(glb_falloff(light)), 1e-4)


# --- Mitsuba ----------------------------------------------------------------------------------------


def numbers(text):
    return [float(x) for x in text.replace(",", " ").split()]


def value(element, name, default=None):
    child = element.find(f"*[@name='{name}']")
    return default if child is None else child.get("value")


def mitsuba_camera(sensor):
    """Of Mitsuba: the camera looks along +z and has x to the left."""
    look = sensor.find("transform/lookat")
    origin, target, up = (numbers(look.get(name)) for name in ("origin", "target", "up"))
    forward = unit(sub(target, origin))
    left = unit(cross(up, forward))
    up = cross(forward, left)
    assert value(sensor, "fov_axis") == "y"
    half = math.tan(math.radians(float(value(sensor, "fov"))) / 2)
    film = sensor.find("film")
    aspect = float(value(film, "width")) / float(value(film, "height"))

    def place(point):
        offset = sub(point, origin)
        depth = dot(offset, forward)
        return [-dot(offset, left) / depth / half / aspect, dot(offset, up) / depth / half]

    return place, aspect


def mitsuba_mesh(folder, shape):
    bsdf, double = shape.find("bsdf"), False
    if bsdf.get("type") == "twosided":
        bsdf, double = bsdf.find("bsdf"), True
    assert bsdf.get("type") == "diffuse", bsdf.get("type")
    color = bsdf.find("rgb[@name='reflectance']")
    emitter = shape.find("emitter")
    emission = [0, 0, 0] if emitter is None else numbers(value(emitter, "radiance"))
    return (read_ply(f"{folder}/{value(shape, 'filename')}"),
            None if color is None else numbers(color.get("value")), emission, double)


def mitsuba_light(emitter):
    look = emitter.find("transform/lookat")
    intensity = numbers(value(emitter, "irradiance" if emitter.get("type") == "directional" else "intensity"))
    if emitter.get("type") == "directional":
        return ("directional", None, numbers(value(emitter, "direction")), intensity, None)
    if emitter.get("type") == "point":
        return ("point", numbers(value(emitter, "position")), None, intensity, None)
    origin, target = numbers(look.get("origin")), numbers(look.get("target"))
    full, end = (math.radians(float(value(emitter, name))) for name in ("beam_width", "cutoff_angle"))
    return ("spot", origin, sub(target, origin), intensity,
            lambda a: min(1, max(0, (end - a) / (end - full))))


def check_mitsuba(folder, glb):
    scene = ElementTree.parse(f"{folder}/scene.xml").getroot()
    place, aspect = mitsuba_camera(scene.find("sensor"))
    compare_places(glb, place, aspect)
    meshes = [mitsuba_mesh(folder, shape) for shape in scene.findall("shape")
              if shape.get("type") == "ply" and "-back" not in value(shape, "filename")]
    compare_triangles(glb, meshes)
    compare_lights(glb, [mitsuba_light(e) for e in scene.findall("emitter") if e.get("type") != "envmap"])


# --- pack -------------------------------------------------------------------------------------------


def check_pack(folder, glb):

    pack = json.load(open(f"{folder}/scene.json"))
    check("triangles", pack["scene"]["triangles"], len(glb.triangles))
    camera, picture = pack["camera"], pack["picture"]
    aspect = picture["width"] / picture["height"]
    half = math.tan(math.radians(camera["fov_y_degrees"]) / 2)
    check("handedness", cross(camera["right"], camera["up"]), [-x for x in camera["forward"]])

    def place(point):
        offset = sub(point, camera["position"])
        depth = dot(offset, camera["forward"])
        return [dot(offset, camera["right"]) / depth / half / aspect, dot(offset, camera["up"]) / depth / half]

    compare_places(glb, place, aspect)
    compare_lights(glb, [pack_light(light) for light in pack["lights"]])
    shines = any(max(triangle[2]) > 0 for triangle in glb.triangles)
    check("emissive surfaces", pack["emissive_surfaces"], shines)


def pack_light(light):
    outer, inner = light["cos_outer"], light["cos_inner"]
    return (light["type"], light["position"], light["direction"], light["irradiance"] or light["intensity"],
            lambda a: min(1, max(0, (math.cos(a) - outer) / max(0.001, inner - outer))) ** 2)


kind, folder, scene = sys.argv[1:]
{"mitsuba": check_mitsuba, "pack": check_pack}[kind](folder, Glb(scene))
print(f"{kind}: {checks} values agree with {scene}")
