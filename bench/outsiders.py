"""make outsiders: POV-Ray, Sunflow and Blender's Cycles beside the reference: rooms, caustics, materials, halls.

    PYTHONPATH=build/python python3 bench/outsiders.py FOLDER rooms|caustics|materials|halls...

Pictures and packs stay in FOLDER. Prints tables in Markdown. A program that is not installed has no rows.
"""
import csv
import math
import os
import resource
import shutil
import subprocess
import sys

import numpy as np

import furnace
import manylight
from glb import glb

BINARY = os.environ.get("MANYLIGHT_BINARY", "./manylight")
ENTRIES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "entries")
PROGRAMS = {"blender": ["blender", "-b", "--factory-startup", "-noaudio", "-P", f"{ENTRIES}/blender/entry.py", "--"],
            **{name: [sys.executable, f"{ENTRIES}/{name}/entry.py"] for name in ("povray", "sunflow")}}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"outsiders.py: {' '.join(map(str, command))}:\n{(done.stdout + done.stderr)[-3000:]}")


def ours(folder, name, command, scene, *options):
    """The layers of a picture of manylight, which is kept."""
    path = f"{folder}/{name}.exr"
    if not os.path.exists(path):
        run(BINARY, command, scene, "-o", path, "-q", *options)
    return manylight.read(path)


def packed(folder, scene, name, *options):
    path = f"{folder}/{name}"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if not os.path.exists(path):
        run(BINARY, "export", scene, "-o", path, "-q", *options)
    return path


def theirs(program, entry, packs, *options):
    """Pictures of packs, in order, or None where the program is not installed. A folder that is there is kept."""
    if not shutil.which("java" if program == "sunflow" else program):
        return None
    if not os.path.exists(entry + "/method.json"):
        run(*PROGRAMS[program], entry, *packs, *options)
    pictures = []
    for pack in packs:
        names = [name for name in os.listdir(entry) if name.startswith(os.path.basename(pack) + ".")]
        pictures.append(manylight.read(f"{entry}/{names[0]}")["beauty"][..., :3])
    return pictures


def grown(mask):
    """The mask and the pixels beside it."""
    wide = np.pad(mask, 1)
    return np.any([wide[i : i + mask.shape[0], k : k + mask.shape[1]] for i in range(3) for k in range(3)], axis=0)


def blocks(picture, use, size):
    """Means of blocks of which at least half is used, and 0 elsewhere; and which these are."""
    h, w = (extent // size for extent in use.shape)
    cut = (slice(h * size), slice(w * size))

    def sums(values):
        return values[cut].reshape(h, size, w, size).sum((1, 3))
    count = sums(use.astype(float))
    return np.where(count > 0, sums(np.where(use, picture, 0)) / np.maximum(count, 1), 0), count >= size * size / 2


def percent(value):
    return f"{100 * value:+.2g} %" if abs(value) < .1 else f"{100 * value:+.0f} %"


# --- rooms of Globillum ----------------------------------------------------------------------------


ROOM_SIZE = "90x60"
# Two pictures each: another seed shows noise (reference, Cycles), another setting its effect (POV-Ray, Sunflow).
ROOM_PROGRAMS = {
    "reference": (),
    "Cycles, 256 spp": ("blender", ("--spp", 256), ("--spp", 256, "--seed", 1)),
    "POV-Ray": ("povray", ("--count", 300, "--error-bound", .4, "--photons", 100000, "--samples", 2, "--lamp-parts", 3),
                ("--count", 150, "--error-bound", .5, "--photons", 100000, "--samples", 1, "--lamp-parts", 2)),
    "Sunflow": ("sunflow", ("--gi", 8), ("--gi", 6)),
}


def room_pictures(folder, room, name, samples):
    scene = f"{folder}/rooms/{room}.glb"
    if name == "reference":
        return [ours(folder, f"{room}.{seed}", "reference", scene, "--size", ROOM_SIZE, "--bounces", 8, "--spp", samples,
                     "--seed", seed)["beauty"][..., :3] for seed in (0, 1)]
    program, *options = ROOM_PROGRAMS[name]
    if program == "sunflow" and "mirror" in room:
        return None
    pack = packed(folder, scene, f"packs/{room}", "--size", ROOM_SIZE, "--bounces", 8)
    kinds = [theirs(program, f"{folder}/{room}.{name.split(',')[0]}.{i}", [pack], *option) for i, option in enumerate(options)]
    return [pictures[0] for pictures in kinds] if kinds[0] else None


def rooms(folder):
    run(sys.executable, f"{os.path.dirname(ENTRIES)}/rooms.py", f"{folder}/rooms")
    print("| room | program | mean | blocks: RMS, worst | noise or other setting: mean, RMS of blocks |\n|---|---|---|---|---|")
    for room in ("plain", "obstructed", "mirror-side", "mirror-end", "mirrors-facing"):
        found = {name: room_pictures(folder, room, name, 128) for name in ROOM_PROGRAMS}
        found = {name: [picture.mean(2) for picture in pictures] for name, pictures in found.items() if pictures}
        # The lamp and what mirrors show of it.
        lamp = grown(found.get("POV-Ray", found["reference"])[0] > .5)
        pair = found["reference"]
        found["reference"] = [np.add(*pair) / 2]
        found["reference"] += [found["reference"][0] + np.subtract(*pair) / 2]
        kept = blocks(found["reference"][0], ~lamp, 10)
        if room in ("plain", "obstructed"):
            frame = ours(folder, f"{room}.frame", "render", f"{folder}/rooms/{room}.glb", "--size", ROOM_SIZE, "--set",
                         "lights.bounces=8")
            found["default frame"] = [frame["beauty"][..., :3].mean(2)]
        for name, pictures in found.items():
            off = [(blocks(picture, ~lamp, 10)[0] / np.where(kept[1], kept[0], 1) - 1)[kept[1]] for picture in pictures]
            mean = [picture[~lamp].mean() / found["reference"][0][~lamp].mean() - 1 for picture in pictures]
            noise = "" if len(off) < 2 else f"{percent(mean[1] - mean[0])}, {percent(np.sqrt(np.mean((off[1] - off[0])**2)))}"
            if name == "reference":
                print(f"| {room} | {name} | | | {noise} |")
                continue
            worst = off[0][abs(off[0]).argmax()]
            print(f"| {room} | {name} | {percent(mean[0])} | {percent(np.sqrt(np.mean(off[0]**2)))}, {percent(worst)} |"
                  f" {noise} |", flush=True)


# --- caustics --------------------------------------------------------------------------------------


CAUSTIC_SIZE = ("--size", "200x150")
FRAME = ("--technique", "unshadowed", "--set", "vpls=64,rsm-size=64,samples=1,caustics.surface=patches")


def radiance(layers):
    return layers["albedo"][..., :3] * layers["caustic"][..., :3]


def caustic_pictures(folder, scene):
    """Names and radiances of caustics alone, the reference first, and the pixels of the table alone."""
    path = f"scenes/{scene}.glb"
    first, second = (ours(folder, f"{scene}.{seed}", "reference", path, *CAUSTIC_SIZE, "--bounces", 0, "--spp", 64,
                          "--light-paths", 40000000, "--aov", "id.material", "--seed", seed) for seed in (0, 1))
    table = ~grown(first["id.material"].reshape(first["id.material"].shape[:2]) != 1)
    found = {"reference": (radiance(first) + radiance(second)) / 2, "reference, half": radiance(first)}
    for size in (256, 512):
        found[f"frame, {size} rays a side"] = radiance(ours(folder, f"{scene}.frame{size}", "render", path, *CAUSTIC_SIZE,
                                                            FRAME[0], FRAME[1], FRAME[2], f"{FRAME[3]},caustics.size={size}"))
    pack = packed(folder, path, f"packs/{scene}", *CAUSTIC_SIZE, "--bounces", 0)
    for name, program, few, many in (("POV-Ray", "povray", 500000, 2000000), ("Sunflow", "sunflow", 500000, 2000000)):
        for photons in (few, many):
            lit, dark = (theirs(program, f"{folder}/{scene}.{name}.{count}", [pack], "--photons", count)
                         for count in (photons, 0))
            if lit:
                found[f"{name}, {photons / 1e6:g} million photons"] = lit[0] - dark[0]
    return found, table


def rmse(picture, reference, use, size):
    a, kept = blocks(picture, use, size)
    b, _ = blocks(reference, use, size)
    return np.sqrt(np.mean((a - b)[kept]**2)) / b[kept].mean()


def caustics(folder):
    print("| scene | program | light | RMSE: pixels, 4x4, 16x16 | correlation |\n|---|---|---|---|---|")
    for scene in ("ring", "pawns"):
        found, table = caustic_pictures(folder, scene)
        grey = {name: picture.mean(2) for name, picture in found.items()}
        reference = grey.pop("reference")
        for name, picture in grey.items():
            errors = [percent(rmse(picture, reference, table, size))[1:] for size in (1, 4, 16)]
            close = np.corrcoef(*(blocks(values, table, 4)[0].ravel() for values in (picture, reference)))[0, 1]
            light = picture[table].sum() / reference[table].sum() - 1
            print(f"| {scene} | {name} | {percent(light)} | {', '.join(errors)} | {close:.3f} |")


# --- materials -------------------------------------------------------------------------------------


def furnace_packs(folder):
    """Names, albedos and packs of the furnace's materials, one pack each angle."""
    os.makedirs(f"{folder}/furnace", exist_ok=True)
    white = f"{folder}/furnace/white.exr"
    manylight.write(white, {"beauty": np.ones((32, 64, 3), np.float32)})
    for number, row in enumerate(furnace.materials()):
        meshes, more = furnace.parts_of(row)
        packs = []
        for angle in furnace.ANGLES:
            path = f"{folder}/furnace/{number:02}-{angle}.glb"  # pictures have the names of scenes
            with open(path, "wb") as file:
                file.write(glb(meshes, [row.material], **more))
            away = [3 * math.sin(math.radians(angle)), 3 * math.cos(math.radians(angle)), 0]
            view = (f"eye={away[0]},{away[1]},0 forward={-away[0] / 3},{-away[1] / 3},0 up=0,0,1 extent=.5")
            packs.append(packed(folder, path, f"furnace/{number:02}-{angle}", "--size", "16x16", "--bounces", 16,
                                "--environment", white, "--camera", view))
        yield row.name, [row.albedo(math.cos(math.radians(angle))) for angle in furnace.ANGLES], packs


def materials(folder):
    rows = list(furnace_packs(folder))
    drawn = theirs("blender", f"{folder}/furnace/cycles", [pack for _, _, packs in rows for pack in packs], "--spp", 256)
    if not drawn:
        return
    print("| material | albedo | Cycles |\n|---|---|---|")
    for number, (name, albedos, _) in enumerate(rows):
        means = [float(picture.mean()) for picture in drawn[3 * number : 3 * number + 3]]
        off = ", ".join(f"{100 * (mean / albedo - 1):+.1f}" for mean, albedo in zip(means, albedos))
        print(f"| {name} | {', '.join(f'{albedo:.4g}' for albedo in albedos)} | {off} |")


# --- halls: the path tracer, the frame and Cycles in the same time ----------------------------------


HALL_SIZE = ("--size", "240x160")
HALL_METHODS = {"default frame": ("render",), "4 spp": ("reference", "--spp", 4), "16 spp": ("reference", "--spp", 16),
                "4 spp, denoised": ("reference", "--spp", 4, "--denoise")}


def seconds(path, *command):
    """The beauty of the picture that a command makes, and the CPU seconds of the process. Both are kept."""
    if not os.path.exists(path + ".cpu"):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        run(*command)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        with open(path + ".cpu", "w") as file:
            file.write(str(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime))
    with open(path + ".cpu") as file:
        return manylight.read(path)["beauty"][..., :3], float(file.read())


def frame_seconds(folder, path):
    """CPU seconds of a frame after the first."""
    table = f"{folder}/{os.path.basename(path)}.csv"
    if not os.path.exists(table):
        run(BINARY, "bench", "times", path, *HALL_SIZE, "--variant", "fast", "--whole-frames", "--frames", 3, "--csv", table)
    with open(table) as file:
        return next(float(row["value"]) for row in csv.DictReader(file) if row["what"] == "cpu") / 1000


def hall(folder, scene):
    path = f"{folder}/halls/{scene}.glb"
    pack = packed(folder, path, f"packs/{scene}", *HALL_SIZE)

    def own(name, command, *options):
        picture = f"{folder}/{scene}.{name.replace(' ', '-')}.exr"
        return seconds(picture, BINARY, command, path, *HALL_SIZE, "-q", "-o", picture, *options)

    def cycles(spp, seed=0):
        entry = f"{folder}/{scene}.cycles.{spp}.{seed}"
        return seconds(f"{entry}/{scene}.240x160.exr", *PROGRAMS["blender"], entry, pack, "--spp", spp, "--seed", seed)

    def line(few, many, draw):
        """CPU seconds without samples, and of a sample."""
        each = (draw(many)[1] - draw(few)[1]) / (many - few)
        return draw(few)[1] - few * each, each
    pair = [own(f"reference {seed}", "reference", "--spp", 64, "--seed", seed)[0] for seed in (100, 101)]
    reference = np.add(*pair) / 2

    def errors(picture):
        figures = [manylight.compare(picture, reference, metric=metric) for metric in ("relative-rmse", "relative-bias", "hdr-flip")]
        return f"{100 * figures[0]:.3g} %, {percent(figures[1])}, {figures[2]:.2g}"
    print(f"| {scene} | noise of the reference | | {errors(pair[0])} | {errors(cycles(512, 1)[0])} at 512 spp | |")
    start, each = line(4, 64, cycles)
    own_start, _ = line(1, 4, lambda spp: own(f"{spp} spp", "reference", "--spp", spp))
    for name, command in HALL_METHODS.items():
        for i in range(4 if command[0] == "render" else 1):  # until the shader cache is full
            picture, whole = own(f"{name}{' again' * i}", *command)
        rest = frame_seconds(folder, path) if command[0] == "render" else whole - own_start
        row = f"| {scene} | {name} | {whole:.3g}, {rest:.3g} | {errors(picture)} |"
        for time in (whole - start, rest):
            spp = round(time / each)
            row += f" {spp} spp: {errors(cycles(spp)[0])} |" if spp > 0 else " no sample |"
        print(row, flush=True)


def halls(folder):
    run(sys.executable, f"{os.path.dirname(ENTRIES)}/halls.py", f"{folder}/halls")
    print("| scene | manylight | CPU s: process, without start | RMSE, bias, FLIP | Cycles in the time of the process |"
          " in the time without start |\n|---|---|---|---|---|---|")
    for scene in ("lights", "spheres") if shutil.which("blender") else ():
        hall(folder, scene)


def main():
    kinds = {"rooms": rooms, "caustics": caustics, "materials": materials, "halls": halls}
    folder, *names = sys.argv[1:] or [None]
    if not names or set(names) - set(kinds):
        sys.exit(__doc__)
    os.makedirs(folder, exist_ok=True)
    for name in names:
        kinds[name](os.path.abspath(folder))


main()
