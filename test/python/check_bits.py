"""check_bits.py PROGRAM FOLDER: the module's pictures are those of the program, bit by bit."""
import os
import subprocess
import sys

import numpy as np

import manylight

PROGRAM, FOLDER = sys.argv[1:]
SIZE = (64, 48)
BOX = "scenes/cornell-box.glb"


def program(*arguments):
    """Runs the program, which writes picture.exr and, without layers, picture.pfm."""
    subprocess.run([PROGRAM, *arguments, "--size", "64x48", "-q"], check=True)


def same_files(layers, file):
    """Layers that Python writes are the bytes of the program's file, but for its metadata: they read the same."""
    own = os.path.join(FOLDER, "own.exr")
    manylight.write(own, layers)
    mine, its = manylight.read(own), manylight.read(file)
    assert sorted(mine) == sorted(its), (sorted(mine), sorted(its))
    for layer, array in mine.items():
        assert array.tobytes() == its[layer].tobytes(), layer
    print(f"    {len(mine)} layers of {file}: equal")


def check_render(device, options, **settings):
    """The mean of float layers is exact in a PFM, all layers are in an EXR."""
    exr, pfm = os.path.join(FOLDER, "picture.exr"), os.path.join(FOLDER, "picture.pfm")
    program("render", BOX, "-o", exr, "-o", pfm, *options)
    layers = device.render(BOX, SIZE, **settings)
    for layer, array in layers.items():
        assert array.flags.owndata and array.dtype == np.float32 and array.shape[:2] == (48, 64), layer
    beauty = manylight.read(pfm)["beauty"]
    assert beauty.tobytes() == np.ascontiguousarray(layers["beauty"][..., :3]).tobytes()
    same_files(layers, exr)
    return layers


def check_settings(device):
    """Names with _ or as they are, and a last word, say the same."""
    options = ("--set", "gather.interleave=4", "--set", "lights.vpls=256", "--technique", "clustered")
    first = check_render(device, options, gather_interleave=4, vpls=256, technique="clustered")
    second = device.render(BOX, SIZE, settings={"gather.interleave": "4", "lights.vpls": 256})
    assert all(first[layer].tobytes() == second[layer].tobytes() for layer in first)
    default = device.render(BOX, SIZE, layers="indirect")
    assert list(default) == ["indirect"] and default["indirect"].tobytes() != first["indirect"].tobytes()


def check_sequence(device):
    """Frames of an animation are those of render --frames."""
    files = os.path.join(FOLDER, "frame.###.exr")
    program("render", "scenes/door.glb", "-o", files, "--frames", "0..2", "--fps", "2")
    count = 0
    for number, layers in enumerate(device.frames("scenes/door.glb", SIZE, frames=range(3), fps=2)):
        same_files(layers, files.replace("###", f"{number:03}"))
        count += 1
    assert count == 3


def check_mattes(device):
    """Cryptomatte of the program's file, and of Python's. A name covers its pixels of ids."""
    file, own, mattes = os.path.join(FOLDER, "picture.exr"), os.path.join(FOLDER, "own.exr"), ["crypto.node", "crypto.mesh"]
    program("render", BOX, "-o", file, "--aov", ",".join(mattes))
    layers = device.render(BOX, SIZE, layers=mattes)
    manylight.write(own, layers)
    for mine in (manylight.read(file), manylight.read(own)):
        assert all(mine[name].tobytes() == layers[name].tobytes() for name in mattes)
    scene = manylight.Scene(BOX)
    ids = device.render(scene, SIZE, layers=["id.node"])["id.node"]
    covers = {number: manylight.matte(layers["crypto.node"], name) for number, name in scene.names("node").items()}
    assert all(np.array_equal(ids[covered > .99], np.full((covered > .99).sum(), number)) for number, covered in covers.items())
    assert np.allclose(sum(covers.values()), layers["crypto.node"][..., 1].sum(-1)) and (covers[9] > .99).sum() > 100


def check_reference():
    """The path tracer's layers, and its error by numpy."""
    file = os.path.join(FOLDER, "reference.exr")
    program("reference", BOX, "-o", file, "--spp", "4")
    reference = manylight.reference(BOX, SIZE, samples=4)
    same_files(reference, file)
    return reference


def check_metric(layers, reference):
    """RMSE and its map against numpy in doubles."""
    value, errors = manylight.error_map(layers, reference, layer="indirect", metric="rmse")
    difference = layers["indirect"].astype(float) - reference["indirect"]
    expected = np.sqrt(np.mean(difference**2))
    print(f"    RMSE {value:.6g}, by numpy {expected:.6g}")
    assert abs(value - expected) <= 1e-5 * expected
    assert errors.shape == (48, 64) and errors.flags.owndata and errors.max() > 0
    assert manylight.compare(layers, layers) == 0


def check_display(device):
    """What a display shows is the program's PNG."""
    file = os.path.join(FOLDER, "picture.png")
    program("render", BOX, "-o", file)
    with device.renderer(BOX, SIZE) as renderer:
        renderer.render(layers=[])
        shown = renderer.display()
    assert shown.dtype == np.uint8 and shown.shape == (48, 64, 4)
    stored = manylight.read(file)["beauty"]
    assert np.array_equal(np.rint(255 * stored[..., :3]), shown[..., :3])


def check_other_bridge(layers):
    """OpenImageIO is found: a TIFF keeps the floats."""
    file = os.path.join(FOLDER, "own.tif")
    manylight.write(file, {"beauty": layers["beauty"]})
    assert manylight.read(file)["beauty"].tobytes() == layers["beauty"].tobytes()


def check_arrays(device):
    """A scene from arrays and its bytes from memory."""
    with open(BOX, "rb") as file:
        scene = manylight.Scene(file.read())
    assert scene.info.triangles > 10 and scene.info.cameras == 1
    camera = scene.camera()
    same = [device.render(scene, SIZE, camera=view)["beauty"].tobytes() for view in (None, camera)]
    assert same[0] == device.render(BOX, SIZE)["beauty"].tobytes() == same[1]
    square = manylight.Mesh([[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]], [[0, 1, 2], [0, 2, 3]])
    scene = manylight.Scene(meshes=[square], materials=[manylight.Material((.5, .5, .5, 1))],
                            lights=[manylight.Light("point", (0, 1, 0), intensity=(1, 1, 1))],
                            cameras=[manylight.Camera((0, 2, 0), (0, -1, 0), (0, 0, -1), fov_y=.2)])
    layers = device.render(scene, (9, 9), layers=["direct", "albedo", "Z"])
    # E / pi of 1 W/sr from 1 m, straight above.
    print(f"    direct light {layers['direct'][4, 4, 0]:.6g} (1 / pi), depth {layers['Z'][4, 4]:.6g} (2)")
    assert abs(layers["direct"][4, 4, 0] * np.pi - 1) < 2e-3
    assert abs(layers["albedo"][4, 4, 0] - .5) < 3e-3 and abs(layers["Z"][4, 4] - 2) < 1e-3


def main():
    with manylight.Device(allow_software=True) as device:
        layers = check_render(device, ())
        check_settings(device)
        check_sequence(device)
        check_mattes(device)
        check_display(device)
        check_arrays(device)
    check_other_bridge(layers)
    check_metric(layers, check_reference())


main()
