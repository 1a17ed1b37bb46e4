"""check_changes.py: a scene whose parts change has the bits of one opened with them."""
import json
import os
import struct

import numpy as np

import manylight
from manylight import Camera, Light, Material, Mesh, Scene
from support import refuse

X, Z = (grid.ravel().astype(np.float32) for grid in np.meshgrid(np.linspace(-1, 1, 12), np.linspace(-1, 1, 12)))
CORNERS = np.arange(144).reshape(12, 12)
FACES = np.concatenate([np.stack([CORNERS[:-1, :-1], CORNERS[1:, :-1], CORNERS[:-1, 1:]], -1).reshape(-1, 3),
                        np.stack([CORNERS[:-1, 1:], CORNERS[1:, :-1], CORNERS[1:, 1:]], -1).reshape(-1, 3)])
SKIES = ("scenes/day.hdr", "cie:12,elevation=40")
# Settings whose data comes from triangles: casters of maps, points, elements, voxels, surfaces of bounces.
MORE = ({"settings": {"path": "maps"}}, {"technique": "imperfect-volume"}, {"technique": "implicit-visibility"},
        {"technique": "imperfect-shadow-maps"}, {"technique": "cluster-lights"}, {"technique": "lightcuts"},
        {"technique": "row-column"}, {"lights_bounces": 3}, {"passes": 3}, {"direct": "pcss", "keep_lights": True})
LAYERS = ["beauty", "indirect", "direct", "albedo", "Z", "id.material", "ao"]


def sheet(height, at=0.):
    return Mesh(np.stack([X + np.float32(at), height * np.sin(4 * X), Z], 1), FACES)


def scene_of(height=.1, color=(.8, .2, .2, 1), at=0., glow=0., mesh=None, **more):
    """A sheet over another, and a triangle that may glow."""
    return Scene(meshes=[mesh or sheet(height), sheet(0, at), Mesh(np.eye(3) * .2, material=1)],
                 materials=[Material(color), Material(emission=(glow,) * 3, double_sided=True)],
                 lights=[Light("spot", (0, 2, 0), intensity=(9, 9, 9))], cameras=[Camera((0, 2, 3), (0, -2, -3))], **more)


def moved(x):
    matrix = np.eye(4)
    matrix[0, 3] = x
    return matrix


def same(device, name, renderer, scene, expected, **options):
    """One renderer throughout against a new one of a new scene, and the path tracer."""
    pictures = renderer.render(layers=LAYERS), device.render(expected, (40, 30), layers=LAYERS, **options)
    traced = [manylight.reference(s, (16, 12), samples=2, threads=1) for s in (scene, expected)]
    for one, other in (pictures, traced):
        for layer in one:
            assert np.array_equal(one[layer], other[layer]), f"{name}: {layer}"
    print(f"    {name}: mean {pictures[0]['beauty'][..., :3].mean():.4f}")
    return pictures[0]["beauty"]


def check_arrays(device, **options):
    scene, now, seen = scene_of(), {}, []
    with device.renderer(scene, (40, 30), **options) as renderer:
        for name, change, more in (
                ("fewer", lambda: scene.set_mesh(1, Mesh(np.eye(3))), {"mesh": Mesh(np.eye(3))}),
                ("first", lambda: scene.set_mesh(1, sheet(.1)), {"mesh": None}),
                ("mesh", lambda: scene.set_mesh(1, sheet(.3)), {"height": .3}),
                ("other mesh", lambda: scene.set_mesh(1, Mesh(np.eye(3))), None),
                ("back", lambda: scene.set_mesh(1, sheet(.3)), {}),
                ("colour", lambda: scene.set_material(1, Material((.1, .7, .2, 1))), {"color": (.1, .7, .2, 1)}),
                ("node", lambda: scene.set_node(2, moved(.25)), {"at": .25}),
                ("lamp", lambda: scene.set_material(2, Material(emission=(5, 5, 5), double_sided=True)), {"glow": 5})):
            change()
            now.update(more or {})
            seen.append(same(device, name, renderer, scene, scene_of(**now), **options) if more is not None
                        else renderer.render()["beauty"])
    assert all(not np.array_equal(a, b) for a, b in zip(seen, seen[1:]))


def check_parts(device):
    """Triangles move from one mesh to the other, in the same order."""
    corners = np.array([[-1, 0, 1], [1, 0, 1], [0, 0, -1], [-1, .5, 1], [1, .5, 1], [0, .5, -1], [-2, 1, -1], [2, 1, -1],
                        [0, 2, -1]], float)

    def split(n):
        return Scene(meshes=[Mesh(corners[:n]), Mesh(corners[n:], material=1)],
                     materials=[Material((.9, .1, .1, 1)), Material((.1, .1, .9, 1))],
                     lights=[Light("spot", (0, 4, 2), intensity=(9, 9, 9))], cameras=[Camera((0, 2, 3), (0, -2, -3))])
    scene = split(6)
    with device.renderer(scene, (40, 30)) as renderer:
        renderer.render()
        scene.set_mesh(1, Mesh(corners[:3]))
        scene.set_mesh(2, Mesh(corners[3:], material=1))
        same(device, "parts", renderer, scene, split(3))


def check_solid(device):
    """A camera moves into a box, whose maps then have its backs."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (0, 2) for z in (-1, 1)], float)
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
             [1, 5, 7], [1, 7, 3]]

    def seen_from(z):
        return Scene(meshes=[Mesh(corners, faces), Mesh(corners * [3, 0, 3] - [0, .1, 0], faces)], materials=[Material()],
                     lights=[Light("spot", (2, 4, 2), (-.5, -1, -.5), (99, 99, 99))],
                     cameras=[Camera((0, 1, z), (0, 0, -1))])
    scene, inside = seen_from(5), np.eye(4)
    inside[1, 3] = 1
    with device.renderer(scene, (40, 30), settings={"path": "maps"}) as renderer:
        renderer.render()
        scene.set_node(4, inside)
        same(device, "solid", renderer, scene, seen_from(0), settings={"path": "maps"})


def check_sky(device):
    scene = scene_of(environment=SKIES[0])
    with device.renderer(scene, (40, 30)) as renderer:
        scene.set_sky(turn=30, strength=2)
        same(device, "turn", renderer, scene, scene_of(environment=SKIES[0], environment_turn=30, environment_strength=2))
        scene.set_sky(SKIES[1], turn=10)
        same(device, "sky", renderer, scene, scene_of(environment=SKIES[1], environment_turn=10))


def with_matrix(path, name, matrix):
    """The bytes of a GLB whose node has another matrix."""
    data = open(path, "rb").read()
    length = struct.unpack_from("<I", data, 12)[0]
    root = json.loads(data[20:20 + length])
    node, = (node for node in root["nodes"] if node.get("name") == name)
    node["matrix"] = matrix.T.ravel().tolist()
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sIII4s", b"glTF", 2, len(data) - length + len(text), len(text), b"JSON") + text + data[20 + length:]


def check_file(device):
    """A node of a file, moved here and in the file."""
    path = "scenes/cornell-box.glb"
    scene = Scene(path)
    with device.renderer(scene, (40, 30)) as renderer:
        first = renderer.render(layers=["beauty", "id.node"])
        node = int(first["id.node"][15, 20])
        name = scene.names("node")[node]
        scene.set_node(node, moved(.3))
        refuse("draws another", renderer.display)
        changed = same(device, name, renderer, scene, Scene(with_matrix(path, name, moved(.3))))
    assert not np.array_equal(first["beauty"], changed)


def check_refusals(device):
    """A refused change leaves the scene what it was; one that cannot be shown ends it."""
    scene, picture = scene_of(), np.zeros((2, 2, 3), np.uint8)
    for words, call in (("node 9: the scene has 1 to 5", lambda: scene.set_node(9, np.eye(4))),
                        ("node: -1", lambda: scene.set_node(-1, np.eye(4))),
                        ("last row not 0 0 0 1", lambda: scene.set_node(1, moved(np.nan))),
                        ("shape (3, 4)", lambda: scene.set_node(1, np.eye(4)[:3])),
                        ("mesh 1: the position of vertex 0", lambda: scene.set_mesh(1, sheet(np.nan, np.nan))),
                        ("mesh 1: material: it keeps", lambda: scene.set_mesh(1, Mesh(np.eye(3), material=1))),
                        ("is not a manylight.Mesh", lambda: scene.set_mesh(1, np.eye(3))),
                        ("material 1: base_color: 2", lambda: scene.set_material(1, Material((2, 0, 0, 1)))),
                        ("keeps its pictures", lambda: scene.set_material(1, Material(picture=picture))),
                        ("no environment", lambda: scene.set_sky(turn=4)),
                        ("has clips", lambda: Scene("scenes/door.glb").set_node(1, np.eye(4)))):
        refuse(words, call)

    def within(_done, _note):
        refuse("in use by another call", lambda: scene.set_node(1, moved(.5)))
        raise InterruptedError
    try:
        manylight.reference(scene, (64, 48), samples=400, progress=within)
    except InterruptedError:
        pass
    with device.renderer(scene, (40, 30)) as renderer:
        same(device, "unchanged", renderer, scene, scene_of())
        scene.set_node(1, moved(1e30))
        refuse("a vertex lies", renderer.render)
        refuse("ended with a change", renderer.render)


def main():
    with manylight.Device(allow_software=True) as device:
        check_arrays(device)
        for options in MORE[:None if os.environ.get("MANYLIGHT_LONG") else 2]:
            print(f"  {options}")
            check_arrays(device, **options)
        check_parts(device)
        check_solid(device)
        check_sky(device)
        check_file(device)
        check_refusals(device)


main()
