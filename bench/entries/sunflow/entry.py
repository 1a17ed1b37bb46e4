"""Draws scene packs with Sunflow's path tracing and photons and writes an entry that bench/score.py reads.

    python3 bench/entries/sunflow/entry.py ENTRY PACK... [--gi N] [--photons N]

ENTRY is the folder to fill, PACK a folder that `manylight export` made. Points and spots without size, surfaces of one
colour: diffuse, emissive, smooth metal, clear glass; other packs are refused. Both sides of a surface are its front.
Tried with Sunflow 0.07.2 of Debian 12, package sunflow, with a JDK. SUNFLOW_JARS is its class path.
"""
import argparse
import math
import os
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
from scene_pack import read_pack, stop, write_method  # noqa: E402

# Units of Sunflow a metre. It takes photons within .05 x radius^2 of a plane .001 off the surface: in metres it finds none.
SCALE = 100
JARS = os.environ.get("SUNFLOW_JARS", "/usr/share/java/sunflow.jar:/usr/share/java/janino.jar:/usr/share/java/commons-compiler.jar")
# Light passes glass with exp((color - 1) x length / distance), and shadows with 1 - color at each side: a color near 1.
NEAR_ONE = 1000


def numbers(values):
    return " ".join(f"{value:.9g}" for value in values)


def color_text(values):
    return f'{{ "sRGB linear" {numbers(values)} }}'


def scaled(point):
    return [SCALE * value for value in point]


def shader_text(name, kind):
    return f"shader {{ name {name} type {kind} }}\n"


def mesh_text(name, shader, points, faces, normals=None):
    vertex_normals = f"normals vertex {numbers(value for normal in normals for value in normal)}" if normals else "normals none"
    return (f"object {{ shader {shader} type generic-mesh name {name}\n points {len(points)} "
            f"{numbers(value for point in points for value in scaled(point))}\n triangles {len(faces)} "
            f"{' '.join('%d %d %d' % tuple(face) for face in faces)}\n {vertex_normals}\n uvs none }}\n")


def light_line(light):
    """As Draw.java reads it."""
    is_spot = light["type"] == "spot"
    return numbers([*scaled(light["position"]), *(light["direction"] if is_spot else (0, 0, 1)),
                    *(SCALE**2 * value for value in light["intensity"]), light["cos_inner"] if is_spot else -2,
                    light["cos_outer"] if is_spot else -1]) + "\n"


def surface_text(name, surface, photons):
    if surface.kind == "diffuse":
        return shader_text(name, f"diffuse diff {color_text(surface.color)}")
    if photons == 0:
        return shader_text(name, f"constant color {color_text([0, 0, 0])}")
    if surface.kind == "mirror":
        return shader_text(name, f"mirror refl {color_text(surface.color)}")
    distance, tint = surface.attenuation
    fade = [1 + math.log(value) / NEAR_ONE for value in tint]
    return shader_text(name, f"glass eta {surface.ior} color {color_text([1, 1, 1])} absorption.distance "
                             f"{SCALE * distance / NEAR_ONE:.9g} absorption.color {color_text(fade)}")


def object_text(number, mesh, arguments):
    name = f"mesh{number}"
    if any(mesh.surface.radiance):
        points = numbers(value for point in mesh.points for value in scaled(point))
        return (f"light {{ type meshlight name {name} emit {color_text(mesh.surface.radiance)} radiance 1 samples 16\n"
                f" points {len(mesh.points)} {points}\n triangles {len(mesh.faces)} "
                f"{' '.join('%d %d %d' % face for face in mesh.faces)} }}\n")
    normals = mesh.normals if mesh.surface.kind != "diffuse" else None
    return (surface_text(f"shader{number}", mesh.surface, arguments.photons)
            + mesh_text(name, f"shader{number}", mesh.points, mesh.faces, normals))


def scene_text(pack, glb, arguments):
    picture, camera = pack["picture"], pack["camera"]
    aspect = picture["width"] / picture["height"]
    fov = 2 * math.degrees(math.atan(aspect * math.tan(math.radians(camera["fov_y_degrees"]) / 2)))
    target = scaled(a + b for a, b in zip(camera["position"], camera["forward"]))
    smooth = arguments.photons and any(mesh.surface.kind in ("mirror", "glass") for mesh in glb.meshes)
    return (f"image {{ resolution {4 * picture['width']} {4 * picture['height']} aa 0 0 samples 1 filter box }}\n"
            f"trace-depths {{ diff {picture['bounces']} refl 32 refr 32 }}\n"
            + (f"photons {{ caustics {arguments.photons} kd {arguments.gather} {SCALE * arguments.radius} }}\n" if smooth else "")
            + (f"gi {{ type path samples {arguments.gi} }}\n" if picture["bounces"] else "")
            + f"camera {{ type pinhole eye {numbers(scaled(camera['position']))} target {numbers(target)}\n"
            f" up {numbers(camera['up'])} fov {fov:.9g} aspect {aspect:.9g} }}\n"
            + "".join(object_text(i, mesh, arguments) for i, mesh in enumerate(glb.meshes)))


def draw(folder, pack, glb, arguments):
    if any(any(mesh.surface.radiance) for mesh in glb.meshes) and any(mesh.surface.kind != "diffuse" for mesh in glb.meshes):
        stop(folder, "emissive surfaces beside mirrors or glass, to which Sunflow sends a part of their photons alone")
    path = os.path.abspath(os.path.join(arguments.entry, pack["picture"]["file"]))
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as work:
        for name, text in (("scene.sc", scene_text(pack, glb, arguments)), ("lights", "".join(map(light_line, pack["lights"])))):
            with open(os.path.join(work, name), "w") as file:
                file.write(text)
        try:
            done = subprocess.run(["java", "-Xmx4G", "-cp", JARS, os.path.join(HERE, "Draw.java"), "scene.sc", "lights", path],
                                  cwd=work, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        except OSError as error:
            sys.exit(f"entry.py: java does not start: {error}")
    if done.returncode or not os.path.exists(path):
        sys.exit(f"entry.py: {folder}: sunflow fails:\n{(done.stdout + done.stderr)[-2000:]}")
    return pack["picture"]["file"], time.monotonic() - start


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("entry")
    parser.add_argument("packs", nargs="+")
    parser.add_argument("--gi", type=int, default=16, help="paths of a sample of a pixel; a pixel has 16 samples")
    parser.add_argument("--photons", type=int, default=2000000, help="photons of all lights; 0: smooth surfaces are black")
    parser.add_argument("--gather", type=int, default=60, help="photons of an estimate, at most")
    parser.add_argument("--radius", type=float, default=.1, help="of an estimate, metres, at most")
    arguments = parser.parse_args()
    packs = [(folder, *read_pack(folder)) for folder in arguments.packs]
    os.makedirs(arguments.entry, exist_ok=True)
    drawn = [draw(*pack, arguments) for pack in packs]
    write_method(arguments.entry, drawn, name="Sunflow", version="0.07.2", url="https://sunflow.sourceforge.net",
                 licence="MIT")


main()
