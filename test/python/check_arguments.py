"""check_arguments.py PROGRAM FOLDER: values of Python and numpy are taken as they are meant, or refused in words."""
import dataclasses
import os
import re
import subprocess
import sys

import numpy as np

import manylight
from manylight import Camera, Light, Material, Mesh, Scene
from support import refuse

PROGRAM, FOLDER = sys.argv[1:]
LONG = bool(os.environ.get("MANYLIGHT_LONG"))
QUAD = np.array([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]], float)
FACES = [[0, 2, 1], [0, 3, 2]]
SUN = Light("directional", intensity=(np.pi,) * 3)
ABOVE = Camera(eye=(0, 3, 0), forward=(0, -1, 0), up=(0, 0, -1), fov_y=0, y_extent=.01)


def scene_of(mesh=Mesh(QUAD, FACES), material=Material(), light=SUN, camera=ABOVE):
    """A square in the plane y = 0, seen from above."""
    return Scene(meshes=[mesh], materials=[material], lights=[light], cameras=[camera])


def centre(device, layer="albedo", text=None, **parts):
    """A layer in the middle of the square; text: lights in place of the scene's."""
    return device.render(scene_of(**parts), (9, 9), vpls=64, light=text)[layer][4, 4]


def near(name, value, expected, tolerance=2e-3):
    print(f"    {name}: {value}, expected {expected}")
    assert np.allclose(value, expected, rtol=tolerance, atol=1e-4), name


def check_area_lights(device):
    """The intensity of an area light is W/sr on its axis in structs, in texts of Python and on the command line."""
    for extent, height in (((.01, .01), 1), ((.02, .005), 2), ((.03, 0), 1.5))[:3 if LONG else 1]:
        lamp = Light("area", (0, height, 0), (0, -1, 0), (np.pi,) * 3, extent=extent)
        expected = 1 / height ** 2
        text = f"+area position=0,{height},0 intensity={np.pi},{np.pi},{np.pi} size={extent[0]},{extent[1]}"
        near(f"struct {extent}", centre(device, "direct", light=lamp)[0], expected)
        near(f"text {extent}", centre(device, "direct", text)[0], expected)
        near(f"reference {extent}",
             manylight.reference(scene_of(light=lamp), (3, 3), samples=16)["direct"][1, 1, 0], expected, .01)
    out = os.path.join(FOLDER, "area.exr")
    box = "scenes/cornell-box.glb"
    text = "+area position=0,5.4,0 direction=0,-1,0 size=1,1 intensity=20,20,20"
    subprocess.run([PROGRAM, "render", box, "-o", out, "--size", "16x16", "--light", text, "-q"], check=True)
    python = device.render(box, (16, 16), light=text)
    assert np.allclose(manylight.read(out)["direct"], python["direct"], rtol=2e-3, atol=1e-4)


def check_intrinsics(device):
    """Points of the square's picture are where K [R|t] puts them, in both conventions."""
    size, turn = (64, 48), np.array([[.8, 0, .6], [0, 1, 0], [-.6, 0, .8]])
    matrix = np.array([[50, 0, 20], [0, 40, 30], [0, 0, 1.]])
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn, (1.5, .8, 2)
    flipped = pose @ np.diag([1, -1, -1, 1])
    cameras = [Camera.from_intrinsics(matrix, pose, size, convention="opengl"),
               Camera.from_intrinsics((50, 40, 20, 30), flipped, size, convention="opencv", pixel_center=.5),
               Camera.from_intrinsics(matrix - [[0, 0, .5], [0, 0, .5], [0, 0, 0]], flipped, size, convention="opencv")]
    depth = device.render(scene_of(), size, camera=cameras[0], vpls=64)["Z"]
    rows, columns = np.nonzero(depth)
    assert len(rows) > 100
    local = np.stack([(columns + .5 - 20) / 50, -(rows + .5 - 30) / 40, -np.ones(len(rows))]) * depth[rows, columns]
    near("height of the square", (turn @ local).T[:, 1] + .8, 0, 0)
    for camera in cameras[1:]:
        near("axes", np.concatenate([camera.right, camera.up, camera.forward]),
             np.concatenate([cameras[0].right, cameras[0].up, cameras[0].forward]))
        near("shift", camera.shift, cameras[0].shift)
    make = lambda k=matrix, p=pose, c="opencv", **more: Camera.from_intrinsics(k, p, size, convention=c, **more)
    for words, call in (("convention: 'blender' is none of opencv, opengl", lambda: make(c="blender")),
                        ("not [fx skew cx", lambda: make(matrix + [[0, 0, 0], [1, 0, 0], [0, 0, 0]])),
                        ("pose: shape (3, 4)", lambda: make(p=pose[:3])),
                        ("pose: column 0 has the length 2", lambda: make(p=pose @ np.diag([2, 1, 1, 1]))),
                        ("focal lengths of -50", lambda: make((-50, 40, 20, 30))),
                        ("pixel_center: 'x'", lambda: make(pixel_center="x"))):
        refuse(words, call)


def check_surfaces(device):
    """Layers of surfaces of a square in y = 0, in frames and references, and in files."""
    layers = ("id.node", "id.mesh", "id.material", "position", "depth", "uv", "Z")
    camera = Camera(eye=(0, 2, 3), forward=(0, -2, -3), fov_y=.9)
    uvs = (QUAD[:, [0, 2]] + 1) / 2
    scene = Scene(meshes=[Mesh(QUAD + [9, 0, 0], FACES), Mesh(QUAD, FACES, uvs=uvs, material=1)],
                  materials=[Material(), Material(picture=np.full((2, 2, 3), 99, np.uint8))], lights=[SUN],
                  cameras=[camera])
    assert scene.names("material") == {1: "", 2: "", 3: "default"} and scene.names("mesh") == {1: "", 2: ""}
    refuse("kind: 'light' is none of node", lambda: scene.names("light"))
    for seen in (device.render(scene, (40, 30), layers=layers, vpls=64),
                 manylight.reference(scene, (40, 30), layers=layers, samples=1, centers=True)):
        shown = seen["id.node"] > 0
        assert seen["id.node"].dtype == np.uint32 and 100 < shown.sum() < 1100
        assert set(np.unique(seen["id.material"])) == {0, 2} and set(np.unique(seen["id.mesh"])) == {0, 2}
        assert not seen["position"][~shown].any() and not seen["depth"][~shown].any()
        place = seen["position"][shown]
        near("height", place[:, 1], 0)
        near("uv", seen["uv"][shown], (place[:, [0, 2]] + 1) / 2)
        near("depth", seen["depth"][shown], np.linalg.norm(place - [0, 2, 3], axis=1))
        path = os.path.join(FOLDER, "surfaces.exr")
        manylight.write(path, {"beauty": np.zeros((30, 40, 3)), **seen})
        read = manylight.read(path)
        assert all(np.array_equal(read[layer], seen[layer]) and read[layer].dtype == seen[layer].dtype
                   for layer in layers)
    steps = np.linspace(-1, 1, 401)  # more triangles than software OpenGL draws at once
    x, z = (axis.ravel() for axis in np.meshgrid(steps, steps))
    corner = np.arange(400 * 401).reshape(400, 401)[:, :400].ravel()
    faces = np.concatenate([corner[:, None] + [0, 401, 1], corner[:, None] + [1, 401, 402]])
    grid = Scene(meshes=[Mesh(np.stack([x, 0 * x, z], 1), faces)], materials=[Material()], lights=[SUN], cameras=[camera])
    pairs = [draw(grid, (40, 30), layers="position", **more)["position"]
             for draw, more in ((device.render, {"vpls": 64}), (manylight.reference, {"samples": 1, "centers": True}))]
    near("positions of many triangles", pairs[0], pairs[1])
    below = {"camera": Camera(eye=(0, -2, 3), forward=(0, 2, -3), fov_y=.9), "layers": "id.node"}
    assert not device.render(scene, (40, 30), vpls=64, **below)["id.node"].any()  # the back of a single-sided square
    assert not manylight.reference(scene, (40, 30), samples=1, **below)["id.node"].any()
    refuse("numbers are not from 0", lambda: manylight.write(path, {"id.node": np.full((2, 2), 1 << 24)}))
    refuse("the parameter is called samples", lambda: manylight.reference(scene, (9, 9), spp=1))
    refuse("'vpl' (manylight.settings() lists them)", lambda: device.render(scene, (9, 9), vpl=1))
    refuse("id.material, position", lambda: device.render(scene, (9, 9), layers="id.light", vpls=64))


def check_batch(device):
    """Views of a batch have the bits of pictures of their own; cameras that move give pixels their motion."""
    places = [Camera(eye=(x, 3, 0), forward=(0, -1, 0), up=(0, 0, -1), fov_y=.5) for x in (-.1, 0, .1, .25)]
    views = [places[0], {"camera": places[1], "next_camera": places[2], "previous_camera": places[3]},
             {"camera": places[2], "light": "0 intensity=1,1,1"}, "0 eye=0,4,0"]
    layers = ["beauty", "motion.next", "motion.previous"]
    pictures = list(device.render_batch(scene_of(), (30, 20), views, layers=layers, vpls=64))
    assert len(pictures) == len(views)
    for view, picture in zip(views, pictures):
        alone = device.render(scene_of(), (30, 20), layers=layers, vpls=64,
                              **(view if isinstance(view, dict) else {"camera": view}))
        assert all(np.array_equal(picture[layer], alone[layer]) for layer in layers)
    pixels = 10 / np.tan(.25) / 3  # of a metre
    near("next", pictures[1]["motion.next"][10, 15], [-.1 * pixels, 0])
    near("previous", pictures[1]["motion.previous"][10, 15], [-.25 * pixels, 0])
    assert not pictures[0]["motion.next"].any() and not pictures[3]["motion.previous"].any()
    traced = manylight.reference(scene_of(), (30, 20), layers=layers, samples=1, **views[1])
    near("traced", traced["motion.next"], pictures[1]["motion.next"])
    refuse("views: {'eye': 1}: the parts are camera", lambda: list(device.render_batch(
        scene_of(), (9, 9), [{"eye": 1}], vpls=64)))
    refuse("camera one too", lambda: device.render(scene_of(), (9, 9), next_camera=places[0], vpls=64))
    refuse("step: -1 is not from 0", lambda: device.render(scene_of(), (9, 9), motion_step=-1, vpls=64))


def check_renderer(device):
    """Parameters of frames are not those of a renderer."""
    for more in ({"layers": ["Z"]}, {"light": "0"}, {"camera": ABOVE}):
        refuse(f"{next(iter(more))}: pass it to Renderer.render", lambda: device.renderer(scene_of(), (9, 9), **more))


def check_colors(device):
    """Whole numbers are shares of their type's largest; floats are shares of 1."""
    taken = (np.full((4, 4), 64, np.uint8), np.full((4, 4), 64 * 257, np.uint16), np.full((4, 4), 64 / 255),
             [[64 / 255] * 4] * 4)
    for colors in taken[:4 if LONG else 2]:
        near("colors", centre(device, mesh=Mesh(QUAD, FACES, colors=colors)), [64 / 255] * 3)
    near("colors of 0 and 1", centre(device, mesh=Mesh(QUAD, FACES, colors=[[1, 0, 1, 1]] * 4)), [1, 0, 1])
    for colors in (np.full((4, 4), 64), np.full((4, 4), 64.), np.full((4, 4), -.1), np.full((4, 4), 1j),
                   np.full((4, 3), .5), np.full((4, 4), np.nan)):
        refuse("mesh 0: ", lambda: centre(device, mesh=Mesh(QUAD, FACES, colors=colors)))


def check_vectors(device):
    """Any sequence of real numbers, of the right length."""
    expected = centre(device, material=Material((.5, .25, .125, 1)))
    for kind in (np.float64, tuple, np.float32, np.float16, list)[:5 if LONG else 2]:
        color = kind([.5, .25, .125, 1]) if kind in (list, tuple) else np.array([.5, .25, .125, 1], kind)
        assert np.array_equal(centre(device, material=Material(color, np.float32(0), np.float64(1))), expected)
    eye = Camera(np.array([0, 3, 0]), np.array([0, -1, 0], np.int8), np.array([0, 0, -1.]), np.float32(0), np.float64(.01))
    near("camera", centre(device, "Z", camera=eye), 3)
    near("black", centre(device, material=Material((0, 0, 0, 0))), 0)
    for eye in ((0, 1), (0, 1, 2, 3), 5, "0,1,2", (0, 1j, 2), (0, None, 2), [[0], [1], [2]], np.zeros((3, 1)),
                (True, False, True), (0, np.inf, 0), [[0], [1, 2]]):
        refuse("eye: ", lambda: centre(device, camera=Camera(eye)))
    for color in (None, (.5, .5, .5), (200, 100, 50, 255), np.array([200, 100, 50, 255], np.uint8), (-.1, 0, 0, 1)):
        refuse("material 0: base_color: ", lambda: centre(device, material=Material(color)))
    refuse("camera: fov_y (radians): 60 is not from 0 to 3.142",
           lambda: device.render(scene_of(), (9, 9), camera=Camera(fov_y=60)))
    refuse("material 0: roughness: ", lambda: centre(device, material=Material(roughness=-1)))
    refuse("light 0: kind: ", lambda: centre(device, light=Light("lamp")))
    refuse("light 0: extent: ", lambda: centre(device, light=Light("area")))
    refuse("is not a manylight.Mesh", lambda: Scene(meshes=[QUAD]))
    refuse("is not a list", lambda: Scene(meshes=Mesh(QUAD)))


def check_meshes():
    """Indices are whole, normals have a direction, positions are real."""
    for indices in (np.array(FACES) + .5, np.array(FACES, float), np.array(FACES, complex), [["a", "b", "c"]], [[0, 1]]):
        refuse("mesh 0: indices: ", lambda: Scene(meshes=[Mesh(QUAD, indices)]))
    for positions in (QUAD + 1j, QUAD > 0, QUAD.astype(object), QUAD.T, [[0, 1, 2], [3]]):
        refuse("mesh 0: positions: ", lambda: Scene(meshes=[Mesh(positions)]))
    for normals in (np.zeros((4, 3)), np.full((4, 3), np.nan), np.ones((3, 3))):
        refuse("mesh 0: ", lambda: Scene(meshes=[Mesh(QUAD, FACES, normals)]))
    refuse("mesh 0: material: 0.5", lambda: Scene(meshes=[Mesh(QUAD, FACES, material=.5)]))


def check_pictures(device):
    """Arrays of bytes are pictures; other arrays are none."""
    uvs = np.full((4, 2), .5)
    for channels in (3, 4)[:2 if LONG else 0]:
        pixels = np.full((4, 4, channels), 128, np.uint8)
        near("picture", centre(device, mesh=Mesh(QUAD, FACES, uvs=uvs), material=Material(picture=pixels)), .2159, .01)
    pixels = np.zeros((2, 3, 3), np.uint8)
    pixels[0, 0] = 255
    for place, expected in (((1 / 6, .25), 1), ((1 / 6, .75), 0), ((5 / 6, .25), 0))[:3 if LONG else 2]:
        mesh = Mesh(QUAD, FACES, uvs=np.tile(place, (4, 1)))
        near(f"texel at {place}", centre(device, mesh=mesh, material=Material(picture=pixels)), expected)
    for picture in (pixels / 255., pixels.astype(int), pixels[..., 0], pixels[..., :2], pixels[:0], "picture.png",
                    b"no picture", b"", [1, 2], np.frombuffer(b"no picture", np.uint8)):
        refuse("material 0: picture: ", lambda: Scene(meshes=[Mesh(QUAD, FACES, uvs=uvs)],
                                                      materials=[Material(picture=picture)]))


def check_numbers(device):
    """Sizes, times, names and settings."""
    scene = scene_of()
    for size in (256, None, (32., 32), (32,), (1, 2, 3), "32x32", (2 ** 40, 32), (None, 8)):
        refuse("", lambda: device.render(scene, size))
        refuse("", lambda: manylight.reference(scene, size))
    assert device.render(scene, np.array([9, 7]), vpls=np.int64(64))["Z"].shape == (7, 9)
    assert device.render(scene, [9, 7], vpls=64, camera=np.int32(0), time=np.float32(0))["Z"].shape == (7, 9)
    for given in (dict(time="1"), dict(time=1j), dict(camera=.5), dict(light=SUN), dict(technique=5), dict(passes=1.5),
                  dict(passes=-1), dict(layers=[5]), dict(layers=5), dict(vpls=None)):
        refuse("", lambda: device.render(scene, (9, 9), **given))
    for member, value in (("noise", -1), ("noise", np.nan), ("samples", -1), ("bounces", -1), ("bounces", .5),
                          ("paths", -1), ("threads", -1), ("ao_distance", np.inf), ("seed", 2 ** 40)):
        refuse(f"{member}: ", lambda: manylight.reference(scene, (9, 9), **{member: value}))
    assert scene.camera(np.int64(0)) == scene.camera("0") == scene.camera()
    refuse("camera: 1.5 is neither", lambda: scene.camera(1.5))
    refuse("time: 'x' is not", lambda: scene.camera(time="x"))
    refuse("is neither a Camera, nor", lambda: device.render(scene, (9, 9), camera=np.eye(4)))
    refuse("a scene needs", Scene)
    refuse("environment_strength", lambda: Scene("scenes/cornell-box.glb", environment_strength=0))


def check_layers(device):
    """References have every layer that `layers` may name, and refuse others before they trace."""
    gem, options = "scenes/gem.glb", dict(samples=1, seen=True, ao_distance=1, light_paths=100)
    every = list(manylight.reference(gem, (4, 4), **options))
    assert list(manylight.reference(gem, (4, 4), layers=every, **options)) == every and len(every) == 24
    refuse("layers: 'normals' is none of beauty, ", lambda: manylight.reference(gem, (9999, 9999), layers=["normals"]))
    refuse("is no Cryptomatte layer", lambda: manylight.matte(np.zeros((4, 4), np.uint32), "lamp"))
    refuse("settings: 'vpls=64' is not a dict", lambda: device.render(scene_of(), (9, 9), settings="vpls=64"))
    refuse("layers: technique ", lambda: device.render(scene_of(), (9, 9), layers=["normals"]))


def check_help():
    """`help` names each member of a part."""
    for part in (Camera, Light, Material, Mesh):
        for member in dataclasses.fields(part):
            assert re.search(rf"^    (\w+, )*{member.name}(, \w+)* : ", part.__doc__, re.M), (part, member.name)


def check_images(device):
    """Maps of one channel are compared as they are; codes of displays are no light."""
    depth = device.render(scene_of(), (9, 9), vpls=64)["Z"]
    near("error of a map", manylight.compare(depth * 1.5, depth), .5)
    refuse("uint8", lambda: manylight.compare(np.zeros((4, 4, 3), np.uint8), np.zeros((4, 4, 3))))
    refuse("layer beauty: ", lambda: manylight.compare(np.zeros((4, 4, 3), complex), np.zeros((4, 4, 3))))
    refuse("layer a: ", lambda: manylight.write(os.path.join(FOLDER, "a.exr"), {"a": [["x"]]}))


def check_errors(device):
    """Each kind of error has its class; files that do not exist are Python's own error, too."""
    box = "scenes/cornell-box.glb"
    for kind, call in ((manylight.SceneError, lambda: Scene(box, variant="nothing")),
                       (manylight.SettingError, lambda: device.render(box, (16, 16), technique="magic")),
                       (manylight.ArgumentError, lambda: device.render(box, (16, 16), layers=["magic"])),
                       (manylight.ArgumentError, lambda: Scene("a\0b"))):
        try:
            call()
            raise AssertionError(f"no {kind}")
        except kind as error:
            print(f"    {kind.__name__}: {error}")
    for call in (Scene, manylight.read, manylight.reference):
        try:
            call(os.path.join(FOLDER, "missing.exr"))
            raise AssertionError("not missed")
        except FileNotFoundError as error:
            assert isinstance(error, manylight.Error) and "missing.exr" in str(error), error
    closed = manylight.Device(allow_software=True)
    closed.close()
    refuse("the device is closed", lambda: closed.render(box))


def main():
    with manylight.Device(allow_software=True) as device:
        check_errors(device)
        check_area_lights(device)
        check_intrinsics(device)
        check_surfaces(device)
        check_batch(device)
        check_colors(device)
        check_renderer(device)
        check_vectors(device)
        check_meshes()
        check_pictures(device)
        check_numbers(device)
        check_layers(device)
        check_help()
        check_images(device)


main()
