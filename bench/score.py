#!/usr/bin/env python3
"""The errors of a folder of pictures, whoever made them, and faults that make such errors meaningless.

ENTRY holds method.json and pictures named SCENE.WxH.exr, of a frame of a clip SCENE.WxH.FRAME.exr. REFERENCES holds
pictures of the same names. The beauty layer is scored, and the layers that method.json lists. bench/schema has the form of
method.json, where null is unknown, and of the scores.
Metrics: as manylight compare has them. Noise: the reference's standard error of the indirect layer over its mean.
Exit status: 0; 1 where a fault is found or a file cannot be read; 2 for wrong usage.
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / os.environ.get("MANYLIGHT_BUILD", "build") / "python"))
import manylight  # noqa: E402

METRICS = ("relative-rmse", "mrse", "smape", "hdr-flip", "relative-bias")
NAME = re.compile(r"(.+?)\.[1-9]\d{0,4}x[1-9]\d{0,4}(?:\.\d{1,8})?\.exr")
BOXES = 12


# --- method.json ----------------------------------------------------------------------------------

def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and value >= 0


def is_texts(value):
    return isinstance(value, list) and all(isinstance(text, str) for text in value)


TEXT = (lambda value: isinstance(value, str) and value, "it is no text")
NUMBER = (is_number, "it is no number from 0 up")
WHOLE = (lambda value: is_number(value) and isinstance(value, int), "it is no whole number from 0 up")
SUM = (lambda value: isinstance(value, str) and re.fullmatch("[0-9a-f]{64}", value), "it is no 64 lower-case hexadecimal digits")
FIELDS = {"name": TEXT, "version": TEXT, "url": TEXT, "licence": TEXT, "device": TEXT, "driver": TEXT,
          "layers": (is_texts, "it is no list of texts"),
          "ms": {"median": NUMBER, "p99": NUMBER, "frames": WHOLE, "covers": TEXT},
          "history_frames": WHOLE, "denoiser": TEXT,
          "hardware_rays": (lambda value: isinstance(value, bool), "it is neither true nor false"),
          "precomputed_s": NUMBER, "sha256": None}


def check_fields(what, value, fields):
    """Fails where a field is not as its row of the table says; what is missing may be null as well."""
    if not isinstance(value, dict):
        sys.exit(f"{what}: it is no object")
    for key, item in value.items():
        if fields is not None and key not in fields:
            sys.exit(f"{what}: '{key}' is no field of it")
        row = SUM if fields is None else fields[key]
        if item is not None and not isinstance(row, tuple):
            check_fields(f"{what}: {key}", item, row)
        elif item is not None and not row[0](item):
            sys.exit(f"{what}: {key}: {row[1]}")


def read_method(path):
    try:
        method = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        sys.exit(f"score: cannot open {path}: {error.strerror}")
    except ValueError as error:
        sys.exit(f"score: {path}: no JSON: {error}")
    check_fields(f"score: {path}", method, FIELDS)
    if method.get("name") is None:
        sys.exit(f"score: {path}: name is missing")
    return method


# --- faults ---------------------------------------------------------------------------------------

def decoded(encoded):
    encoded = np.clip(encoded, 0, 1)
    return np.where(encoded <= .04045, encoded / 12.92, ((encoded + .055) / 1.055) ** 2.4)


def luminance(picture):
    return (picture @ np.array([.212636822, .715182982, .072180196])).astype(np.float64)


def moved(picture, right, down):
    """The picture at places that far to the right and down, between pixels interpolated, at edges the next pixel."""
    for axis, shift in ((1, right), (0, down)):
        at = np.arange(picture.shape[axis]) + shift
        low = np.floor(at).astype(int)
        weight = (at - low).reshape((1, -1) if axis else (-1, 1))
        ends = [picture.take(np.clip(low + i, 0, picture.shape[axis] - 1), axis) for i in (0, 1)]
        picture = (1 - weight) * ends[0] + weight * ends[1]
    return picture


def error_of(picture, reference):
    """The mean of |v - r| / (|v| + |r| + 2 % of the mean): no bright pixel decides alone."""
    size = abs(picture) + abs(reference) + .02 * reference.mean()
    return np.divide(abs(picture - reference), size, out=np.zeros_like(size), where=size > 0).mean()


def find_change(picture, reference):
    """The change of all of the picture whose removal lowers the error most, and clearly, as (fault, text)."""
    error = error_of(picture, reference)
    if error < .01:
        return None
    told = (reference > .05 * reference.mean()) & (picture > 0)
    ratios = np.sort(picture[told] / reference[told])
    factor = ratios[len(ratios) // 2] if len(ratios) else 1
    candidates = [
        ("exposure", f"all of it is {factor:.3g} times as bright as the reference", picture / factor),
        ("encoded", "its values are sRGB-encoded, where linear light is due", decoded(picture)),
        ("mirrored", "it is mirrored left to right", picture[:, ::-1]),
        ("mirrored", "it is mirrored top to bottom", picture[::-1]),
        ("mirrored", "it is mirrored both ways", picture[::-1, ::-1])]
    fault, text, undone = min(candidates, key=lambda row: error_of(row[2], reference))
    return (fault, text) if error_of(undone, reference) < .6 * error else None


def correlation(picture, reference):
    """Of the logarithms of means over boxes; 1 where one of both is all alike: nothing can be told."""
    height, width = reference.shape
    boxes = (np.arange(height) * BOXES // height)[:, None] * BOXES + np.arange(width) * BOXES // width
    counts = np.maximum(np.bincount(boxes.ravel(), minlength=BOXES * BOXES), 1)
    logs = []
    for values in (picture, reference):
        means = np.bincount(boxes.ravel(), values.ravel(), BOXES * BOXES) / counts
        logs.append(np.log(.01 * reference.mean() + np.maximum(means, 0)) if reference.mean() > 0 else means * 0)
    a, b = (log - log.mean() for log in logs)
    return (a @ b) / np.sqrt((a @ a) * (b @ b)) if a.any() and b.any() else 1


def find_shift(picture, reference):
    """The shift by which the reference's gradients explain the difference best [Lucas and Kanade 1981]. Noise of the
    reference and sharp edges make it up to a quarter smaller. Interpolation blurs what it shifts back, so that the error
    becomes little less."""
    mean = reference.mean()
    v, r = (np.maximum(values, 0) / (np.maximum(values, 0) + mean) for values in (picture, reference))
    x, y = ((moved(r, *step) - moved(r, *(-i for i in step))) / 2 for step in ((1, 0), (0, 1)))
    xx, xy, yy = (x * x).sum(), (x * y).sum(), (y * y).sum()
    if not xx * yy - xy * xy > 1e-6 * xx * yy:
        return None
    right, down = np.linalg.solve([[xx, xy], [xy, yy]], [-(x * (v - r)).sum(), -(y * (v - r)).sum()])
    error = error_of(picture, reference)
    if .25 < np.hypot(right, down) < 2 and error > .01 and \
            error_of(moved(picture, right, down), reference) < .95 * error:
        return "shifted", f"it is shifted by about {right:.2f} pixels to the right and {down:.2f} down"
    return None


def find_fireflies(picture, reference):
    """Pixels eight times as bright as all of the reference within two pixels, and as its mean."""
    steps = range(-2, 3)
    most = np.maximum.reduce([moved(reference, i, j) for i in steps for j in steps] + [np.full_like(reference, reference.mean())])
    count = int((picture > 8 * most).sum())
    return ("fireflies", f"pixels eight times as bright as the reference around them: {count}") if count else None


def faults_of(picture, reference):
    picture, reference = luminance(picture), luminance(reference)
    change = find_change(picture, reference)
    if change:
        return [change]
    alike = correlation(picture, reference)
    if alike < .5:
        return [("other-view", f"another camera, scene or light: lights and darks correlate by {alike:.2f}")]
    return [fault for fault in (find_shift(picture, reference), find_fireflies(picture, reference)) if fault]


# --- scores ---------------------------------------------------------------------------------------

def number(value):
    return float(f"{value:.12g}") if np.isfinite(value) else None


def noise_of(reference):
    """NaN where the reference does not tell."""
    if "indirect" not in reference or "standard_error" not in reference:
        return np.nan
    mean = reference["indirect"].mean(dtype=np.float64)
    return np.sqrt(np.mean(np.square(reference["standard_error"], dtype=np.float64))) / mean if mean > 0 else np.nan


def color(layers, name):
    layer = layers[name]
    return layer[..., :3] if layer.ndim == 3 and layer.shape[2] >= 3 else np.repeat(layer.reshape(*layer.shape[:2], -1)[..., :1], 3, 2)


def row_of(file, layer, faults, metrics=None, noise=None):
    return {"picture": file, "layer": layer, "metrics": metrics, "noise": noise,
            "faults": [{"fault": fault, "text": text} for fault, text in faults]}


def score_layer(file, layer, pictures, references, digits, listed):
    if layer not in references:
        sys.exit(f"score: {file}: the reference has no layer '{layer}'")
    if layer not in pictures:
        return row_of(file, layer, [("missing-layer", f"it has no layer '{layer}'")])
    picture, reference = color(pictures, layer), color(references, layer)
    sizes = [f"{image.shape[1]}x{image.shape[0]}" for image in (picture, reference)]
    if sizes[0] != sizes[1]:
        return row_of(file, layer, [("size", f"it is {sizes[0]}, the reference {sizes[1]}")])
    faults = [("sha256", f"its SHA-256 is {digits}, method.json lists {listed}")] if listed not in (None, digits) else []
    bad = ~np.isfinite(picture)
    if bad.any():
        faults.append(("not-finite", f"{bad.sum()} values are NaN or infinite, and taken as 0"))
    picture = np.where(bad, 0, picture)
    metrics = {metric: number(manylight.compare(picture, reference, metric=metric)) for metric in METRICS}
    return row_of(file, layer, faults + faults_of(picture, reference), metrics, number(noise_of(references)))


def exrs(folder):
    try:
        return sorted(path.name for path in folder.iterdir() if path.suffix == ".exr" and path.name[0] != ".")
    except OSError:
        sys.exit(f"score: cannot read the folder {folder}")


def score_all(entry, references, method, scenes):
    """Rows of all pictures of the asked scenes; of those that are missing, too many or named otherwise, too."""
    files, wanted, sums = exrs(entry), exrs(references), method.get("sha256") or {}
    named = {file: NAME.fullmatch(file)[1] for file in wanted + files if NAME.fullmatch(file)}
    for scene in scenes:
        if scene not in (named.get(file) for file in wanted):
            sys.exit(f"score: scene: REFERENCES has no picture of '{scene}'")
    if not any(file in named for file in wanted):
        sys.exit("score: REFERENCES has no picture named SCENE.WxH.exr")
    rows, asked = [], [file for file in named if not scenes or named[file] in scenes]
    for file in (file for file in wanted if file in asked):
        if file not in files:
            rows.append(row_of(file, "beauty", [("missing-picture", "the entry has none of that name")]))
            continue
        digits = hashlib.sha256((entry / file).read_bytes()).hexdigest()
        pictures, reference = manylight.read(entry / file), manylight.read(references / file)
        rows += [score_layer(file, layer, pictures, reference, digits, sums.get(file))
                 for layer in ["beauty", *(method.get("layers") or [])]]
    rows += [row_of(file, "beauty", [("no-reference", "REFERENCES has none of that name")])
             for file in files if file in asked and file not in wanted]
    rows += [row_of(file, "beauty", [("missing-picture", "method.json lists its SHA-256")])
             for file in sums if not scenes and file not in files and file not in wanted]
    return rows + [row_of(file, "beauty", [("name", "it is neither SCENE.WxH.exr nor SCENE.WxH.FRAME.exr")])
                   for file in files if file not in named]


def print_table(out, method, rows):
    head = " ".join(filter(None, (method["name"], method.get("version"))))
    print(", ".join(filter(None, (head, method.get("device")))), file=out)
    print(f"{'picture':28} {'layer':10}", *(f"{name:>13}" for name in (*METRICS, "noise")), file=out)
    for row in rows:
        values = [*row["metrics"].values(), row["noise"]] if row["metrics"] else []
        if values:
            print(f"{row['picture']:28} {row['layer']:10}",
                  *(f"{'-' if value is None else format(value, '.6g'):>13}" for value in values), file=out)
        for fault in row["faults"]:
            print(f"{row['picture']:28} {row['layer']:10} fault: {fault['fault']}: {fault['text']}", file=out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("entry", type=pathlib.Path, metavar="ENTRY")
    parser.add_argument("references", type=pathlib.Path, metavar="REFERENCES")
    parser.add_argument("--scene", action="append", default=[], metavar="NAME", help="score this scene alone; repeatable")
    parser.add_argument("-o", "--output", type=pathlib.Path, metavar="FILE.json",
                        help="write the scores as JSON; -: to standard output, and the table to standard error")
    asked = parser.parse_args()
    to_stdout = str(asked.output) == "-"
    if asked.output and not to_stdout and asked.output.exists() and any(
            asked.output.samefile(path) for folder in (asked.entry, asked.references) for path in folder.glob("*")):
        sys.exit(f"score: {asked.output} is the input")
    method = read_method(asked.entry / "method.json")
    try:
        rows = score_all(asked.entry, asked.references, method, asked.scene)
    except manylight.Error as error:
        sys.exit(f"score: {error}")
    print_table(sys.stderr if to_stdout else sys.stdout, method, rows)
    text = json.dumps(method, separators=(",", ":"), sort_keys=True), ",\n  ".join(map(json.dumps, rows))
    text = '{\n "method": %s,\n "scores": [\n  %s]}\n' % text
    if to_stdout:
        sys.stdout.write(text)
    elif asked.output:
        asked.output.write_text(text)
    return any(row["faults"] for row in rows)


sys.exit(main())
