"""check_cameras.py PROGRAM FOLDER: lenses show points where their formulas put them, in frames and references."""
import subprocess
import sys

import numpy as np

import manylight
from manylight import Camera, Light, Material, Mesh, Scene
from support import refuse

PROGRAM, FOLDER = sys.argv[1:]
TURN = np.array([[.8, 0, .6], [0, 1, 0], [-.6, 0, .8]])
EYE = (.1, -.2, .3)


def room():
    """A white cube of 4 m from within, with a lamp; each side has a material of its own."""
    corners = np.array([[x, y, z] for x in (-2, 2) for y in (-2, 2) for z in (-2, 2)], float)
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [np.array([[a, b, c], [a, c, d]]) for a, b, c, d in sides]
    return Scene(meshes=[Mesh(corners, face, material=i) for i, face in enumerate(faces)],
                 materials=[Material((.6, .6, .6, 1), double_sided=True)] * 6,
                 lights=[Light("point", (0, 1, 0), intensity=(9, 9, 9))], cameras=[Camera(EYE)])


def camera_of(lens="pinhole", **more):
    return Camera(EYE, -TURN[:, 2], TURN[:, 1], lens=lens, **more)


def local(points):
    """Right, up and ahead of the camera."""
    return (points - np.array(EYE)) @ (TURN * [1, 1, -1])


def of_opencv(points, matrix, k):
    """Where cv::projectPoints puts them, y down, first pixel's centre at 0, 0."""
    x, y = points[..., 0] / points[..., 2], -points[..., 1] / points[..., 2]
    k1, k2, p1, p2, k3, k4, k5, k6 = list(k) + [0] * (8 - len(k))
    r2 = x * x + y * y
    radial = (1 + k1 * r2 + k2 * r2 ** 2 + k3 * r2 ** 3) / (1 + k4 * r2 + k5 * r2 ** 2 + k6 * r2 ** 3)
    u = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
    v = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
    return np.stack([matrix[0][0] * u + matrix[0][1] * v + matrix[0][2], matrix[1][1] * v + matrix[1][2]], -1)


def of_lens(points, lens, angle, size):
    """Where a wide lens puts them, pixels."""
    right, up, ahead = np.moveaxis(points, -1, 0)
    if lens == "equirectangular":
        return np.stack([(.5 + np.arctan2(right, ahead) / (2 * np.pi)) * size[0],
                         (.5 - np.arctan2(up, np.hypot(right, ahead)) / np.pi) * size[1]], -1) - .5
    if lens == "cube":
        sides = [(-ahead, up, right), (ahead, up, -right), (right, -ahead, up), (right, ahead, -up), (right, up, ahead),
                 (-right, up, -ahead)]
        face = np.argmax([forward for _, _, forward in sides], axis=0)
        x, y, z = (np.choose(face, [side[i] for side in sides]) for i in range(3))
        return np.stack([(face + .5 + .5 * x / z) * size[1], (.5 - .5 * y / z) * size[1]], -1) - .5
    aside = np.hypot(right, up)
    theta = np.arctan2(aside, ahead)
    radius = theta / (angle / 2) if lens == "equidistant" else np.sin(theta / 2) / np.sin(angle / 4)
    return np.stack([size[0] + size[1] * radius * right / aside, size[1] - size[1] * radius * up / aside], -1) / 2 - .5


def pictures(device, scene, size, camera, **more):
    layers = ["beauty", "position", "id.material", "depth", "Z", "indirect", "direct"]
    yield "frame", device.render(scene, size, camera=camera, layers=layers, **more)
    yield "paths", manylight.reference(scene, size, camera=camera, layers=layers, samples=1, centers=True)


def check_places(device, name, scene, size, camera, place):
    """The point that each pixel shows is where the formula puts it; those at edges may be of the triangle beside."""
    grid = np.stack(np.meshgrid(np.arange(size[0]), np.arange(size[1])), -1)
    found = []
    for kind, seen in pictures(device, scene, size, camera, vpls=64):
        away = np.abs(place(local(seen["position"])) - grid).max(-1)
        away = away[seen["depth"] > 0]
        print(f"    {name}, {kind}: {len(away)} pixels, off by {np.quantile(away, .95):.5f}, at most {away.max():.3f}")
        assert len(away) > .99 * size[0] * size[1]
        assert np.quantile(away, .9 if kind == "frame" else 1) < .01 and away.max() < (1 if camera.lens == "pinhole" else 4)
        found.append(seen)
        along = local(seen["position"])[..., 2] if camera.lens == "pinhole" else seen["depth"]
        assert np.allclose(local(seen["position"]), (seen["position"] - EYE) @ camera.axes.T * [1, 1, -1], atol=1e-5)
        assert (np.abs(seen["Z"] - along) < 1e-3).mean() > .9
    frame, paths = found
    assert (frame["id.material"] == paths["id.material"]).mean() > .97
    error = np.abs(frame["direct"] - paths["direct"]).mean() / paths["direct"].mean()
    print(f"    {name}: direct light differs by {error:.3f}")
    assert error < .12


def check_lenses(device):
    scene, matrix = room(), [[40, 1.5, 30], [0, 44, 22], [0, 0, 1]]
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = TURN @ np.diag([1, -1, -1]), EYE
    for k in ((), (-.2, .05, .002, -.003), (-.25, .08, .001, .002, -.01), (.3, -.1, .001, -.002, .02, .2, .05, .01)):
        camera = Camera.from_intrinsics(matrix, pose, (64, 48), convention="opencv", distortion=k)
        check_places(device, f"distortion {k}", scene, (64, 48), camera, lambda p: of_opencv(p, matrix, k))
    for lens, angle, size in (("equirectangular", 0, (96, 48)), ("cube", 0, (192, 32)), ("equidistant", 3.3, (48, 48)),
                              ("equisolid", 2.5, (64, 48))):
        check_places(device, lens, scene, size, camera_of(lens, fov_y=angle), lambda p: of_lens(p, lens, angle, size))


def check_seams(device):
    """Indirect light of a smooth room has no steps where the six pictures meet."""
    scene, size = room(), (256, 128)
    camera = Camera(EYE, (1, .7, 1), lens="equirectangular")  # whose edges cross the sides
    light = device.render(scene, size, camera=camera, layers=["indirect"], vpls=2048)["indirect"].mean(-1)
    x, y = np.meshgrid((np.arange(size[0]) + .5) / size[0], (np.arange(size[1]) + .5) / size[1])
    long, lat = (2 * x - 1) * np.pi, (.5 - y) * np.pi
    way = np.stack([np.cos(lat) * np.sin(long), np.sin(lat), np.cos(lat) * np.cos(long)], -1)
    face = np.argmax(np.concatenate([way, -way], -1), -1)
    side = manylight.reference(scene, size, camera=camera, layers=["id.material"], samples=1)["id.material"]
    step = np.abs(np.diff(light, axis=1)) / light.mean()
    across, smooth = face[:, 1:] != face[:, :-1], side[:, 1:] == side[:, :-1]
    print(f"    steps: {step[across & smooth].mean():.4f} across {(across & smooth).sum()} seams, "
          f"{step[~across & smooth].mean():.4f} elsewhere")
    assert (across & smooth).sum() > 100
    assert step[across & smooth].mean() < 1.2 * step[~across & smooth].mean()


def check_program(device):
    """The text of the program is the module's camera. A lens leaves later frames what they are."""
    path, out, text = "scenes/cornell-box.glb", f"{FOLDER}/lens.exr", "0 lens=equidistant"
    traced = manylight.reference(path, (24, 24), camera=text, samples=2)
    subprocess.run([PROGRAM, "reference", path, "-o", out, "--size", "24x24", "--camera", text, "-q", "--spp", "2"],
                   check=True)
    assert np.array_equal(manylight.read(out)["Z"], traced["Z"])
    with device.renderer(path, (24, 24)) as renderer:
        plain = renderer.render()["beauty"]
        assert np.median(np.abs(renderer.render(camera=text)["Z"] - traced["Z"])) < .01
        refuse("display: ", renderer.display)
        assert np.array_equal(renderer.render()["beauty"], plain) and renderer.display().any()


def check_refusals(device):
    scene, wide = room(), camera_of("equirectangular")
    trace = lambda camera, **more: manylight.reference(scene, (16, 8), camera=camera, samples=1, **more)
    show = lambda camera, *layers: device.render(scene, (16, 8), camera=camera, layers=layers)
    pinhole = lambda *k: Camera.from_intrinsics((40, 40, 32, 24), np.eye(4), (64, 48), convention="opencv", distortion=k)
    for words, call in (("lens: 'wide' is none of pinhole", lambda: trace(camera_of("wide"))),
                        ("fov_y (radians): 7 is not from 0 to 6.283", lambda: trace(camera_of("equisolid", fov_y=7))),
                        ("orthographic", lambda: trace(camera_of("cube", fov_y=0, y_extent=1))),
                        ("not six times as wide", lambda: trace(camera_of("cube"))),
                        ("not six times as wide", lambda: show(camera_of("cube"), "Z")),
                        ("for pinholes", lambda: trace(camera_of("cube", skew=.1))),
                        ("is not 4, 5 or 8 numbers", lambda: pinhole(1, 2, 3)),
                        ("distortion: nan is not finite", lambda: pinhole(np.nan, 0, 0, 0)),
                        ("no ray is seen at the pixel", lambda: pinhole(-3, 0, 0, 0)),
                        ("--light-paths", lambda: trace(wide, light_paths=9)),
                        ("motion.next: frames", lambda: show(wide, "motion.next")),
                        ("'lens=fish': there is pinhole", lambda: trace("lens=fish"))):
        refuse(words, call)


def main():
    with manylight.Device(allow_software=True) as device:
        check_lenses(device)
        check_seams(device)
        check_program(device)
        check_refusals(device)


main()
