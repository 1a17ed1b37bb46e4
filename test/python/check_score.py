"""check_score.py MANYLIGHT FOLDER: bench/score.py has the figures of manylight compare, and names each planted fault."""
import hashlib
import json
import pathlib
import re
import subprocess
import sys

import numpy as np

import manylight

PROGRAM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
ENTRY, REFERENCES, JSON = FOLDER / "entry", FOLDER / "references", FOLDER / "score.json"
NAME = "box.96x72.exr"
BOX = "scenes/cornell-box.glb"


def run(*words, status=0, stdout=False):
    """What the command prints: on standard output alone, or all of it."""
    done = subprocess.run([*map(str, words)], stdout=subprocess.PIPE, text=True, check=False,
                          stderr=subprocess.PIPE if stdout else subprocess.STDOUT)
    print(f"    {' '.join(map(str, words))[-90:]} -> {done.returncode} {done.stdout[-200:]}")
    assert done.returncode == status, (done.returncode, done.stdout)
    return done.stdout


def score(*options, status=0, stdout=False):
    return run(sys.executable, "bench/score.py", ENTRY, REFERENCES, *options, status=status, stdout=stdout)


def write_entry(picture, file=NAME, **method):
    for path in ENTRY.glob("*"):
        path.unlink()
    (ENTRY / "method.json").write_text(json.dumps({"name": "test", **method}))
    manylight.write(ENTRY / file, picture)


def check_fault(fault, picture, **method):
    """The fault is named, and no other."""
    write_entry(picture, **method)
    text = score(status=1)
    assert fault in text and text.count("fault: ") == 1, text
    return text


def encoded(linear):
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= .0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - .055)


def changed(layers, places, value):
    beauty = layers["beauty"].copy()
    for y, x, channel in places:
        beauty[y, x, channel] = value
    return {**layers, "beauty": beauty}


def check_planted(frame, fine):
    check_fault("exposure: all of it is 1.25 times", {name: layer * 1.25 for name, layer in frame.items()})
    check_fault("encoded: its values are sRGB", {name: encoded(layer) for name, layer in frame.items()})
    check_fault("mirrored: it is mirrored left to right", {name: layer[:, ::-1] for name, layer in frame.items()})
    check_fault("mirrored: it is mirrored top to bottom", {name: layer[::-1] for name, layer in frame.items()})
    # A pixel is the mean of four small ones, which begin one further to the left.
    left = np.roll(fine["beauty"], 1, axis=1)
    left[:, 0] = left[:, 1]
    beauty = left.reshape(72, 2, 96, 2, -1).mean(axis=(1, 3))
    shift = re.search("about (.*) pixels to the right and (.*) down", check_fault("shifted", {"beauty": beauty}))
    assert abs(float(shift[1]) - .5) < .15 and abs(float(shift[2])) < .1, shift[0]
    check_fault("fireflies: pixels eight times as bright as the reference around them: 3",
                changed(frame, [(30, 20 + 20 * i, 1) for i in range(3)], 500))
    check_fault("not-finite: 2 values", changed(frame, [(10, 10, 0), (10, 11, 2)], np.inf))
    check_fault("missing-layer: ", {"beauty": frame["beauty"]}, layers=["indirect"])
    check_fault("size: it is 48x36, the reference 96x72", {"beauty": frame["beauty"][:36, :48]})
    write_entry(frame)
    run(PROGRAM, "render", BOX, "--size", "96x72", "-q", "--camera", "0 eye=-2,4,1 forward=1,-.5,-.4", "-o", ENTRY / NAME)
    text = score(status=1)
    assert "fault: other-view: another camera, scene or light" in text and text.count("fault: ") == 1


def check_names(frame):
    write_entry(frame, layers=["indirect", "glow"])
    assert "no layer 'glow'" in score(status=1)  # of the reference: it is no fault of the entry
    write_entry(frame, "box.96x72.3.exr")
    manylight.write(ENTRY / "box.exr", frame)
    text = score(status=1)
    assert all(f"fault: {fault}" in text for fault in ("missing-picture", "no-reference", "name"))
    manylight.write(ENTRY / NAME, frame)
    digits = hashlib.sha256((ENTRY / NAME).read_bytes()).hexdigest()
    write_entry(frame, sha256={NAME: digits})
    text = score("-o", "-", stdout=True)
    assert json.loads(text)["method"]["sha256"] == {NAME: digits}  # the table is elsewhere
    check_fault("sha256: its SHA-256 is ", frame, sha256={NAME: digits[::-1]})
    check_fault("missing-picture: method.json lists its SHA-256", frame, sha256={"a.1x1.exr": digits})


def check_figures():
    """The digits of compare, and no fault, be the technique right or wrong."""
    for technique in ("clustered", "unshadowed", "lightcuts"):
        run(PROGRAM, "render", BOX, "--size", "96x72", "--technique", technique, "-q", "-o", ENTRY / NAME)
        (ENTRY / "method.json").write_text('{"name": "test", "layers": ["indirect"]}')
        score("-o", JSON)
        row = json.loads(JSON.read_text())["scores"][1]
        metrics = [f"-m{name}" for name in row["metrics"]]
        text = run(PROGRAM, "compare", ENTRY / NAME, REFERENCES / NAME, "--json", "-l", "indirect", *metrics)
        for name, value in row["metrics"].items():
            assert f'"{name}": {value}' in text, (name, value)
        assert 0 < row["noise"] < 1 and row["faults"] == []


def check_schemas(frame):
    try:
        import jsonschema  # noqa: F401
    except ImportError:
        print("    skipped: no jsonschema")
        return
    write_entry(frame, version="1", url=None, licence="MIT", layers=["indirect"], denoiser=None, hardware_rays=False,
                ms={"median": 3.5, "p99": 4, "frames": 100, "covers": "all passes"}, history_frames=0, precomputed_s=0)
    score("-o", JSON)
    check = (sys.executable, "test/apps/check_schema.py", "bench/schema/method.schema.json", ENTRY / "method.json")
    run(*check, "bench/schema/score.schema.json", JSON)
    (ENTRY / "method.json").write_text('{"name": "test", "ms": {"median": -1}}')
    run(*check, status=1)


def check_refusals(frame):
    JSON.unlink(missing_ok=True)
    for method, message in (
            ("{}", "method.json: name is missing"), ('{"name": ""}', "name: it is no text"), ("[1]", "it is no object"),
            ('{"name"', "no JSON"), ('{"name": "a", "ms": {"median": -1}}', "ms: median: it is no number from 0 up"),
            ('{"name": "a", "ms": 3}', "ms: it is no object"), ('{"name": "a", "layers": "d"}', "layers: it is no list of texts"),
            ('{"name": "a", "ms": {"frames": 1.5}}', "ms: frames: it is no whole number"),
            ('{"name": "a", "hardware_rays": 1}', "hardware_rays: it is neither true nor false"),
            ('{"name": "a", "sha256": {"b.exr": "ab"}}', "sha256: b.exr: it is no 64 lower-case hexadecimal digits"),
            ('{"name": "a", "sha256": []}', "sha256: it is no object"), ('{"name": "a", "speed": 1}', "'speed' is no field of it")):
        write_entry(frame)
        (ENTRY / "method.json").write_text(method)
        assert message in score("-o", JSON, status=1)
    write_entry(frame)
    assert "is the input" in score("-o", ENTRY / "method.json", status=1)
    assert "is the input" in score("-o", REFERENCES / NAME, status=1)
    assert "scene: REFERENCES has no picture of 'sponza'" in score("--scene", "sponza", status=1)
    (ENTRY / NAME).write_bytes((ENTRY / NAME).read_bytes()[:2000])
    assert NAME in score("-o", JSON, status=1) and not JSON.exists()
    for folders in (("nowhere", REFERENCES), (ENTRY, "nowhere")):
        assert "nowhere" in run(sys.executable, "bench/score.py", *folders, status=1)


def main():
    for folder in (ENTRY, REFERENCES):
        folder.mkdir(exist_ok=True)
    run(PROGRAM, "reference", BOX, "--size", "96x72", "--spp", "32", "-q", "-o", REFERENCES / NAME)
    for size, file in (("96x72", "frame.exr"), ("192x144", "fine.exr")):
        run(PROGRAM, "render", BOX, "--size", size, "-q", "-o", FOLDER / file)
    frame = manylight.read(FOLDER / "frame.exr", ["beauty", "indirect"])
    check_planted(frame, manylight.read(FOLDER / "fine.exr", ["beauty"]))
    check_names(frame)
    check_figures()
    check_schemas(frame)
    check_refusals(frame)


main()
