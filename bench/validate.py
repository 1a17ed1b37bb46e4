"""make validate: exact test cases of CIE 171:2006 by the path tracer, each direct method and each technique.

Rooms are in metres, x to the right, y up, z towards the viewer. Values are irradiances, pi times the layers `direct` and
`indirect`, at points of a surface that an orthographic camera faces. Prints a page in Markdown.
"""
import datetime
import math
import sys
import tempfile

import numpy as np

import furnace
import manylight
from furnace import plate_passes
from glb import open_glb, quad
from manylight import Camera, Light, Material

TEXELS = 40  # a metre; 8 where a mean counts
WALL_HEIGHTS = (2.75, 2.25, 1.75, 1.25, .75, .25)
FLOOR_DEPTHS = (.25, .75, 1.25, 1.75)
WIDE = [name for name in manylight.direct_methods() if name != "hard"]  # methods for lights with a size
# All but the one without visibility, and the default's other ways.
TECHNIQUES = sorted(["clustered, path=maps", "clustered, path=paper"] + [
    name for name in manylight.techniques() if name != "unshadowed"])
# A bounce of imperfect-volume takes a march: bounces by albedo, after which under .02 % of the light is left.
MARCHES = {.2: 8, .5: 16, .7: 24}
TECHNIQUES = ("clustered", "clustered, path=maps", "clustered, path=paper", "instant-radiosity", "lightcuts", "row-column",
              "cluster-lights", "imperfect-shadow-maps", "imperfect-volume", "implicit-visibility")


def box(low, high, material=0):
    (a, b, c), (d, e, f) = low, high
    x, y, z = (d - a, 0, 0), (0, e - b, 0), (0, 0, f - c)
    minus = [tuple(-k for k in v) for v in (x, y, z)]
    return [quad((a, b, f), x, y, material), quad((d, b, c), minus[0], y, material), quad((a, b, c), z, y, material),
            quad((d, b, f), minus[2], y, material), quad((a, e, f), x, minus[2], material),
            quad((a, b, c), x, z, material)]


def room(size, floor=0, back=0, others=0, ceiling=True):
    """A room from (0, 0, -depth) to (width, height, 0), seen from within. Numbers are materials."""
    w, h, d = size
    walls = [quad((0, 0, 0), (w, 0, 0), (0, 0, -d), floor), quad((0, 0, -d), (w, 0, 0), (0, h, 0), back),
             quad((w, 0, 0), (-w, 0, 0), (0, h, 0), others), quad((0, 0, 0), (0, 0, -d), (0, h, 0), others),
             quad((w, 0, -d), (0, 0, d), (0, h, 0), others)]
    return walls + ([quad((0, h, -d), (w, 0, 0), (0, 0, d), others)] if ceiling else [])


def grey(albedo, emission=0):
    return Material((albedo, albedo, albedo, 1), emission=(emission,) * 3)


def light(kind, intensity, **more):
    return Light(kind, intensity=(intensity,) * 3, **more)


class Surface:
    """A rectangle as its camera sees it, `away` metres in front, and points of it, metres from its lower left corner."""

    def __init__(self, corner, right, up, normal, points, away):
        self.corner, self.right, self.up = (np.array(v, float) for v in (corner, right, up))
        self.sides = [np.linalg.norm(self.right), np.linalg.norm(self.up)]
        self.points = points
        normal = np.array(normal, float)
        eye = self.corner + .5 * (self.right + self.up) + away * normal
        self.camera = Camera(tuple(eye), tuple(-normal), tuple(self.up / self.sides[1]), fov_y=0, y_extent=.5 * self.sides[1])
        self.set_texels(TEXELS if points else 8)

    def set_texels(self, texels):
        self.texels = texels
        self.size = tuple(int(round(side * texels)) for side in self.sides)

    def strip(self):
        """The part along the middle, .1 m wide, if all points lie on it: few pixels to trace."""
        middle = .5 * self.right
        if not self.points or any(x != .5 * self.sides[0] for x, _ in self.points):
            return self
        half = .05 / self.sides[0] * self.right
        eye = np.array(self.camera.eye)
        away = np.dot(eye - self.corner, -np.array(self.camera.forward))
        return Surface(self.corner + middle - half, 2 * half, self.up, -np.array(self.camera.forward),
                       [(.05, y) for _, y in self.points], away)

    def irradiance(self, layers):
        """W/m2 at the points, bilinear; of all of it where there are none."""
        values = math.pi * (layers["direct"] + layers["indirect"]).mean(2)[::-1]
        if not self.points:
            return np.array([values.mean()])
        return np.array([bilinear(values, self.texels * x - .5, self.texels * y - .5) for x, y in self.points])


def bilinear(values, x, y):
    i, j = (min(max(int(math.floor(t)), 0), n - 2) for t, n in ((x, values.shape[1]), (y, values.shape[0])))
    s, t = x - i, y - j
    return ((1 - s) * values[j, i] + s * values[j, i + 1]) * (1 - t) + ((1 - s) * values[j + 1, i] + s * values[j + 1, i + 1]) * t


ROOM = (4, 3, 4)


def wall(points=WALL_HEIGHTS, away=1.9, height=3):
    """The back wall, at x = 2 m; none: all of it."""
    return Surface((0, 0, -4), (4, 0, 0), (0, height, 0), (0, 0, 1), [(2, y) for y in points], away)


def floor(depths=FLOOR_DEPTHS, away=2.9):
    """The floor, at x = 2 m and depths from the back wall."""
    return Surface((0, 0, 0), (4, 0, 0), (0, 0, -4), (0, 1, 0), [(2, 4 - y) for y in depths], away)


def ceiling():
    return Surface((0, 3, -4), (4, 0, 0), (0, 0, 4), (0, -1, 0), [(2, y) for y in FLOOR_DEPTHS], 2.9)


def front_wall():
    """The wall behind the viewer."""
    return Surface((4, 0, 0), (-4, 0, 0), (0, 3, 0), (0, 0, -1), [(2, y) for y in WALL_HEIGHTS], 1.9)


class Case:
    def __init__(self, name, what, scene, parts, kind, factor=1, **settings):
        self.name, self.what, self.scene, self.parts, self.kind = name, what, scene, parts, kind
        self.factor, self.settings = factor, settings


def plane(width):
    return quad((-width / 2, 0, width / 2), (width, 0, 0), (0, 0, -width))


def plane_points(width, points):
    half = width / 2
    return Surface((-half, 0, half), (width, 0, 0), (0, 0, -width), (0, 1, 0), [(half + x, half + y) for x, y in points], 2)


# CIE general skies (ISO 15469:2004): gradation a, b and indicatrix c, d, e.
SKIES = {1: (4, -.7, 0, -1, 0), 5: (0, -1, 0, -1, 0), 12: (-1, -.32, 10, -3, .45)}


def sky_luminance(kind, x, y, z):
    """Of unit directions, over a sun in the south (+z) at 45 degrees. 0 below the horizon."""
    up = np.maximum(y, 1e-9)
    if kind == 16:  # traditional overcast sky
        return np.where(y > 0, 1 + 2 * up, 0)
    a, b, c, d, e = SKIES[kind]
    cosine = (y + z) / math.sqrt(2)
    away = np.arccos(np.clip(cosine, -1, 1))
    scatter = 1 + c * (np.exp(d * away) - math.exp(d * math.pi / 2)) + e * cosine**2
    return np.where(y > 0, (1 + a * np.exp(b / up)) * scatter, 0)


def horizontal(kind, steps=2000):
    """Illuminance of a level plane under the open sky, by the midpoint rule."""
    height, turn = np.meshgrid((np.arange(steps) + .5) / steps, 2 * math.pi * (np.arange(steps) + .5) / steps)
    flat = np.sqrt(1 - height**2)
    return (sky_luminance(kind, flat * np.cos(turn), height, flat * np.sin(turn)) * height).mean() * 2 * math.pi


def through(opening, points, normal, seen, passes=None, steps=400):
    """Illuminance of points through an opening (corner, side, side), by the midpoint rule. seen: luminance by place and
    direction."""
    corner, right, up = (np.array(v, float) for v in opening)
    s, t = np.meshgrid((np.arange(steps) + .5) / steps, (np.arange(steps) + .5) / steps)
    places, area = corner + s[..., None] * right + t[..., None] * up, np.cross(right, up)
    found = []
    for point in points:
        way = places - point
        distance = np.linalg.norm(way, axis=2)
        way /= distance[..., None]
        out = abs(way @ area) / np.linalg.norm(area)
        values = seen(np.array(point, float), way) * np.maximum(way @ np.array(normal), 0) * out / distance**2
        found.append((values * (passes(out) if passes else 1)).mean() * np.linalg.norm(area))
    return np.array(found)


def sky_case(name, what, kind, meshes, opening, pane=None, shining=None):
    """A black room with an opening to a sky, whose level illuminance is 100: values are daylight factors in %.
    shining: half the width of a ground before the room, which has .3 times the light of the sky."""
    scale = 100 / horizontal(kind)

    def seen(point, way):
        x, y, z = (way[..., i] for i in range(3))
        values = scale * sky_luminance(kind, x, y, z)
        if shining:
            to_ground = np.where(y < 0, -point[1] / np.minimum(y, -1e-9), 0)
            on = (y < 0) & (abs(point[0] + to_ground * x - 2) < shining) & (point[2] + to_ground * z < shining)
            values = np.where(on, .3 * 100 / math.pi, values)
        return values

    parts = []
    for surface, normal, points in ((wall(away=3.9), (0, 0, 1), [(2, y, -4) for y in WALL_HEIGHTS]),
                                    (floor(), (0, 1, 0), [(2, 0, y - 4) for y in FLOOR_DEPTHS])):
        parts.append((surface, through(opening, points, normal, seen, plate_passes if pane else None)))
    scene = dict(meshes=meshes, materials=[grey(0), grey(0, .3 * 100 / math.pi)], pane=pane,
                 environment=f"cie:{kind},horizontal=100")
    return Case(name, what, scene, parts, "sky")


def daylight_cases():
    w, h, d = ROOM
    roof = ((0, h, -d), (w, 0, 0), (0, 0, d))
    hole = ((1.5, h, -2.5), (1, 0, 0), (0, 0, 1))
    frame = [quad((0, h, -4), (4, 0, 0), (0, 0, 1.5)), quad((0, h, -1.5), (4, 0, 0), (0, 0, 1.5)),
             quad((0, h, -2.5), (1.5, 0, 0), (0, 0, 1)), quad((2.5, h, -2.5), (1.5, 0, 0), (0, 0, 1))]
    window = ((1, 1, 0), (2, 0, 0), (0, 1, 0))
    closed = room(ROOM)
    facade = closed[:2] + closed[3:] + [
        quad((4, 0, 0), (-4, 0, 0), (0, 1, 0)), quad((4, 2, 0), (-4, 0, 0), (0, 1, 0)),
        quad((1, 1, 0), (-1, 0, 0), (0, 1, 0)), quad((4, 1, 0), (-1, 0, 0), (0, 1, 0))]
    opened = room(ROOM, ceiling=False)
    for kind, what in ((5, "even"), (16, "overcast"), (12, "clear")):
        yield sky_case(f"5.9, {what}", f"sky `cie:{kind}` over an open room", kind, opened, roof)
    yield sky_case("5.9, 1 m", "even sky over an opening of 1 m", 5, opened + frame, hole)
    yield sky_case("5.10", "even sky over a roof of clear glass", 5, opened, roof, pane=roof)
    ground = quad((-28, 0, 30), (60, 0, 0), (0, 0, -30), 1)
    yield sky_case("5.11", "overcast sky before a window, and a shining ground", 16, facade + [ground], window, shining=30)


def form_factor_cases():
    """A square of albedo 1 lights another, by the sun or shining: F of the textbooks, in %."""
    black, white, shining = grey(0), grey(1), grey(0, 1)
    below = quad((0, 0, 1), (1, 0, 0), (0, 0, -1), 1)
    for name, other, sun, factor in (
            ("parallel", Surface((0, 1, 0), (1, 0, 0), (0, 0, 1), (0, -1, 0), [], .5), (1.5, -1, 0), 19.982),
            ("right angle", Surface((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), [], .5), (0, -1, 0), 20.004)):
        other.set_texels(TEXELS)
        meshes = [below, quad(other.corner, other.right, other.up)]
        down = -sun[1] / math.hypot(*sun)
        yield Case(f"F, {name}", f"form factor of two unit squares, {name}",
                   dict(meshes=meshes, materials=[black, shining]), [(other, (factor,))], "factor", factor=100 / math.pi)
        yield Case(f"F, {name}, lit", "the same, lit by a sun",
                   dict(meshes=meshes, materials=[black, white], lights=[light("directional", 1 / down, direction=sun)]),
                   [(other, (factor,))], "lit factor", factor=100)
    disk = light("area", math.pi, position=(0, 1, 0), extent=(2, 0))  # radiance 1, radius 1 m
    yield Case("F, disk", "form factor of a disk, from 1 m below its middle", dict(meshes=[plane(1)], materials=[black], lights=[disk]),
               [(plane_points(1, [(0, 0)]), (50,))], "factor", factor=100 / math.pi)


def cases():
    black, lambert = [grey(0)], light("area", 1000, position=(0, 3, 0), extent=(.02, .02))
    yield Case("5.2", "small Lambertian lamp over a plane", dict(meshes=[plane(4)], materials=black, lights=[lambert]),
               [(plane_points(4, [(0, 0), (.5, 0), (1, 0), (1.5, 0), (.5, .5), (1, .5), (1.5, .5), (1, 1), (1.5, 1), (1.5, 1.5)]),
                 (111.11, 105.21, 90.02, 71.11, 99.73, 85.64, 68.06, 74.36, 59.98, 49.39))], "direct")
    yield Case("5.2b", "isotropic lamp over a plane",
               dict(meshes=[plane(12)], materials=black, lights=[light("point", 1e4 / (4 * math.pi), position=(0, 3, 0))]),
               [(plane_points(12, [(x, 0) for x in range(6)]), [1e4 / (4 * math.pi) * 3 / (9 + x * x)**1.5 for x in range(6)])],
               "point")
    lamp = light("area", 1000, position=(2, 3, -2), extent=(1, 1))
    yield Case("5.3", "lamp of 1 m in the ceiling of a black room", dict(meshes=room(ROOM), materials=black, lights=[lamp]),
               [(wall(), (32.68, 75.19, 81.32, 69.06, 53.40, 40.00)), (floor(), (61.42, 79.26, 95.67, 105.78))], "direct")
    yield Case("5.6", "light from a floor of albedo .3",
               dict(meshes=room(ROOM, floor=1, ceiling=False), materials=black + [grey(.3)],
                    lights=[light("directional", 1000)]),
               [(wall(WALL_HEIGHTS[:5], away=3.9), (107.703, 83.976, 64.917, 50.148, 38.901)[::-1])], "indirect")
    yield Case("5.6, shining", "the same floor as an area light", dict(meshes=room(ROOM, floor=1), materials=black + [grey(0, 1)]),
               [(wall(WALL_HEIGHTS[:5]), (12.967, 16.716, 21.639, 27.992, 35.901)), (ceiling(), (26.80, 30.94, 33.98, 35.57))],
               "direct", factor=100 / math.pi)
    yield Case("5.7, shining", "a wall as an area light behind a box",
               dict(meshes=room(ROOM, back=1, ceiling=False) + box((0, 0, -2.7), (4, 1, -2.5)),
                    materials=black + [grey(0, 1)]),
               [(front_wall(), (16.10, 16.30, 15.36, 13.29, 10.28, 7.05)), (floor((3.75, 3.25, 2.75)), (3.39, 3.62, 2.99))],
               "direct", factor=100 / math.pi)
    for albedo in (.2, .5, .7, .9):
        cube = dict(meshes=room((4, 4, 4)), materials=[grey(albedo)],
                    lights=[light("point", 1e4 / (4 * math.pi), position=(2, 2, -2))])
        yield Case(f"5.8, {albedo:g}", f"all light in a cube of albedo {albedo:g}", cube,
                   [(wall((), away=3.9, height=4), (104.17 / (1 - albedo),))], "indirect", bounces=1000, albedo=albedo)
    yield from daylight_cases()
    yield from form_factor_cases()


def methods_of(case):
    """Names and arguments of what can draw the case."""
    if case.kind in ("direct", "factor"):
        return [(name, dict(direct=name)) for name in WIDE]
    if case.kind == "point":
        return [("hard", dict(direct="hard"))]
    if case.kind == "sky":
        return [("clustered", {})]
    found = []
    for name in TECHNIQUES:
        technique, _, path = name.partition(", path=")
        settings = {"path": path} if path else {}
        if "bounces" in case.settings:
            settings["lights.bounces"] = case.settings["bounces"]
            if name == "imperfect-volume":
                settings["lights.bounces"] = MARCHES.get(case.settings["albedo"])
        if settings.get("lights.bounces", 1):
            found.append((name, dict(technique=technique, settings=settings)))
    return found


def deviations(values, case, expected):
    return 100 * (case.factor * values / np.array(expected) - 1)


def scene_of(pane=None, **parts):
    """pane: corner and sides of one of clear glass, which only a file can have."""
    if not pane:
        return manylight.Scene(**parts)
    glass = {"doubleSided": True, "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
             "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.52}}}
    black = {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0, "roughnessFactor": 1}}
    return open_glb(parts["meshes"] + [quad(*pane, 1)], [black, glass], parts["environment"])


def measure(case, draw, thin=False):
    """Deviations in % at all points of the case."""
    scene = scene_of(**case.scene)
    found = []
    for surface, expected in case.parts:
        surface = surface.strip() if thin else surface
        found.append(deviations(surface.irradiance(draw(scene, surface)), case, expected))
    return np.concatenate(found)


def draw_reference(case):
    def draw(scene, surface):
        return manylight.reference(scene, surface.size, camera=surface.camera, bounces=case.settings.get("bounces", 1),
                                   noise={"sky": .01}.get(case.kind, .005 if surface.points else .04))
    return draw


def draw_frame(device, arguments):
    return lambda scene, surface: device.render(scene, surface.size, camera=surface.camera, **arguments)


def rows(device, names):
    """names: beginnings of the names of cases; none: all."""
    for case in cases():
        if names and not case.name.startswith(tuple(names)):
            continue
        for name, draw in [("reference", draw_reference(case))] + [
                (name, draw_frame(device, arguments)) for name, arguments in methods_of(case)]:
            try:
                off = measure(case, draw, name == "reference")
            except manylight.Error as error:
                print(f"{case.name}: {name}: {error}", file=sys.stderr)
                continue
            print(f"{case.name:10} {name:24} mean {off.mean():+7.2f} %  largest {off[abs(off).argmax()]:+7.2f} %", file=sys.stderr)
            yield case, name, off


# Why a method may err by more than 5 %.
REASONS = {
    "imperfect-volume": "voxels blur light, and a voxel at a wall has light of its neighbours",
    "implicit-visibility": "an element sees the nearest partner of each direction, and light between elements is interpolated",
    "clustered": "a sky is 120 area lights, few of which an opening shows, by rays of a block of pixels",
    "clustered, path=paper": "VALs stand for their VPLs in visibility",
    "pcss": "64 rays to a lamp as wide as the room, of which few see past the box",
    "msm": "four moments of one map, from the middle of a wide lamp",
    "vssm": "two moments of one map, from the middle of a wide lamp",
    "cssm": "a Fourier series of one map, from the middle of a wide lamp",
}

HEAD = f"""# Validation

Exact test cases of CIE 171:2006 [CIE 2006], whose values anybody can derive.
`make validate` measures this page: {datetime.date.today()}.
A cell is the mean deviation in % over the points of a case, then the largest. Lights are in lm and cd, as watts.
Cameras are orthographic, with 40 pixels a metre. Values are pi times the layers `direct` and `indirect`.
Those of 5.9 to 5.11 are integrals of the sky's formula over the opening, and of Fresnel's equations (5.10). Case 5.4
is part of 5.8, and 5.5 is in `test/reference/test_panes.c`.
"""


def table(cells, names, columns):
    print("|", " | ".join(["method"] + [case.name for case in columns]), "|")
    print("|---" * (len(columns) + 1) + "|")
    for name in names:
        row = [cells.get((name, case.name)) for case in columns]
        if any(off is not None for off in row):
            texts = ["" if off is None else f"{off.mean():+.2f}, {off[abs(off).argmax()]:+.2f}" for off in row]
            print(f"| `{name}` |", " | ".join(texts), "|")


def page(cells, columns):
    print(HEAD)
    for case in columns:
        print(f"- **{case.name}**: {case.what}.")
    names = list(dict.fromkeys(name for name, _ in cells))
    for title, kinds in (("Direct light", ("direct", "point")), ("Indirect light", ("indirect",)),
                         ("Daylight", ("sky",)), ("Form factors", ("factor", "lit factor"))):
        print(f"\n## {title}\n")
        table(cells, names, [case for case in columns if case.kind in kinds])
    print("\n## Mean over all cases\n\n| method | cases | mean of the cases' absolute mean deviations, % |\n|---|---|---|")
    for name in names:
        own = [abs(off.mean()) for (other, _), off in cells.items() if other == name]
        print(f"| `{name}` | {len(own)} | {np.mean(own):.2f} |")
    beyond = [(name, case, off) for (name, case), off in cells.items() if abs(off).max() > 5]
    print("\n## Cells beyond 5 %\n" if beyond else "\nNo cell is beyond 5 %.")
    for name, case, off in beyond:
        print(f"- `{name}`, {case}: {off[abs(off).argmax()]:+.1f} %: {REASONS.get(name, 'not explained yet')}.")


def main():
    cells, columns = {}, []
    with manylight.Device(allow_software=True) as device, tempfile.TemporaryDirectory() as folder:
        for case, name, off in rows(device, sys.argv[1:]):
            cells[name, case.name] = off
            if case.name not in [other.name for other in columns]:
                columns.append(case)
        page(cells, columns)
        if len(sys.argv) == 1 or "furnace" in sys.argv:
            furnace.page(furnace.measure(device, folder))


main()
