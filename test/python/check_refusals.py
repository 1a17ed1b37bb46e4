"""check_refusals.py PROGRAM FOLDER: what the program refuses, the module refuses with the same words."""
import os
import subprocess
import sys

import manylight

PROGRAM, FOLDER = sys.argv[1:]
BOX = "scenes/cornell-box.glb"
LONG = bool(os.environ.get("MANYLIGHT_LONG"))


def words(*arguments):
    """What the program prints on failure, without its name, its subcommand and an option's name."""
    done = subprocess.run([PROGRAM, *arguments, "-q"], capture_output=True, text=True, check=False)
    assert done.returncode != 0, arguments
    return done.stderr.strip().removeprefix(f"manylight {arguments[0]}: ").removeprefix("device: ")


def refuse(kind, expected, call):
    """A call raises an exception of that kind with these words."""
    try:
        call()
    except kind as error:
        print(f"    {type(error).__name__}: {error}")
        assert isinstance(error, manylight.Error)
        assert str(error) == expected, f"the program says: {expected}"
        return
    raise AssertionError(f"no refusal, but: {expected}")


def check_scenes(device):
    """Files that are not there, no scenes, cut, or without a camera of that name."""
    cut = os.path.join(FOLDER, "cut.glb")
    with open(BOX, "rb") as whole, open(cut, "wb") as part:
        part.write(whole.read()[:1000])
    text = os.path.join(FOLDER, "text.gltf")
    with open(text, "w", encoding="utf-8") as file:
        file.write("no scene")
    out = os.path.join(FOLDER, "x.exr")
    for file in (cut, text, os.path.join(FOLDER, "missing.glb"))[:3 if LONG else 1]:
        expected = words("render", file, "-o", out)
        refuse(manylight.SceneError, expected, lambda: device.render(file))
        refuse(manylight.SceneError, expected, lambda: manylight.reference(file))
    for option in ("scene", "variant"):
        expected = words("render", BOX, "-o", out, f"--{option}", "nothing")
        refuse(manylight.SceneError, expected, lambda: manylight.Scene(BOX, **{option: "nothing"}))
    for option in ("camera", "light"):
        expected = words("render", BOX, "-o", out, f"--{option}", "nobody")
        refuse(manylight.Error, expected, lambda: device.render(BOX, (16, 16), **{option: "nobody"}))


def check_settings(device):
    """Names and values that the renderer does not know."""
    out = os.path.join(FOLDER, "x.exr")
    for name, value in (("gather.colour", "3"), ("gather.interleave", "many"), ("lights.vpls", "0"))[:3 if LONG else 1]:
        expected = words("render", BOX, "-o", out, "--set", f"{name}={value}")
        refuse(manylight.SettingError, expected, lambda: device.render(BOX, (16, 16), settings={name: value}))
    for option in ("technique", "direct")[:2 if LONG else 1]:
        expected = words("render", BOX, "-o", out, f"--{option}", "magic")
        refuse(manylight.SettingError, expected, lambda: device.render(BOX, (16, 16), **{option: "magic"}))
    expected = words("render", BOX, "-o", out, "--aov", "magic")
    expected += "; layers of every frame: beauty, Z, albedo, direct, indirect, normal"
    refuse(manylight.ArgumentError, expected, lambda: device.render(BOX, (16, 16), layers=["magic"]))


def check_missing():
    """Files that do not exist are Python's own error, too."""
    for call in (manylight.Scene, manylight.read, manylight.reference):
        try:
            call(os.path.join(FOLDER, "missing.exr"))
            raise AssertionError("not missed")
        except FileNotFoundError as error:
            assert isinstance(error, manylight.Error) and "missing.exr" in str(error), error


def check_devices():
    """Devices that are not there, and software that is not allowed."""
    out = os.path.join(FOLDER, "x.exr")
    for name in ("999", "cuda:99", "round"):
        expected = words("render", BOX, "-o", out, "--device", name)
        refuse(manylight.Error, expected, lambda: manylight.Device(name, allow_software=True))
    if "llvmpipe" in manylight.Device(allow_software=True).info.renderer:
        expected = words("render", BOX, "-o", out, "--device", "hardware")
        refuse(manylight.DeviceError, expected, manylight.Device)


def check_memory(device):
    """A picture that no machine holds: seconds go by until memory is short."""
    size = (16384, 16384)
    expected = words("render", BOX, "-o", os.path.join(FOLDER, "x.exr"), "--size", f"{size[0]}x{size[1]}")
    refuse(manylight.OutOfMemory, expected, lambda: device.render(BOX, size))


def check_own():
    """What Python alone can say wrongly."""
    closed = manylight.Device(allow_software=True)
    closed.close()
    refuse(manylight.ArgumentError, "the device is closed", lambda: closed.render(BOX))
    refuse(manylight.ArgumentError, "'a\\x00b' has a zero byte", lambda: manylight.Scene("a\0b"))
    refuse(manylight.ArgumentError, "mesh 0: positions: shape (2,), not (n, 3)",
           lambda: manylight.Scene(meshes=[manylight.Mesh([1, 2])]))


def main():
    with manylight.Device(allow_software=True) as device:
        check_scenes(device)
        check_settings(device)
        if os.environ.get("MANYLIGHT_LONG"):
            check_memory(device)
    check_missing()
    check_devices()
    check_own()


main()
