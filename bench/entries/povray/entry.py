"""Draws scene packs with POV-Ray's radiosity and photons and writes an entry that bench/score.py reads.

    python3 bench/entries/povray/entry.py ENTRY PACK... [--count N] [--photons N]

ENTRY is the folder to fill, PACK a folder that `manylight export` made. Points and spots without size, surfaces of one
colour: diffuse, emissive, smooth metal, clear glass; other packs are refused. Both sides of a surface are its front.
Tried with POV-Ray 3.7.
"""
import argparse
import math
import os
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from scene_pack import read_pack, write_method  # noqa: E402

# POV-Ray's lights fade with 2 / (1 + (d / FADE)^2): far beyond FADE, metres, with the square of the distance.
FADE = 0.01


def vector(values, factor=1.0):
    return "<" + ",".join(f"{factor * value:.9g}" for value in values) + ">"


def between(a, b, fraction=1.0):
    return [p + fraction * (q - p) for p, q in zip(a, b)]


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def camera_text(camera, picture):
    length = 0.5 / math.tan(math.radians(camera["fov_y_degrees"]) / 2)
    return (f"camera {{ perspective location {vector(camera['position'])}\n direction "
            f"{vector(camera['forward'], length)} up {vector(camera['up'])}\n right "
            f"{vector(camera['right'], picture['width'] / picture['height'])} }}\n")


def source_text(position, intensity, more=""):
    """intensity: W/sr. A diffuse surface of POV-Ray reflects colour x light, without 1 / pi."""
    color = vector(intensity, 1 / (math.pi * 2 * FADE * FADE))
    return (f"light_source {{ {vector(position)} color rgb {color}\n fade_distance {FADE} fade_power 2{more}"
            " photons { reflection on refraction on } }\n")


def light_text(light):
    """A spot's edge is a smoothstep of the cosine, moved so that the flux is the same."""
    more = ""
    if light["type"] == "spot":
        width = max(0.001, light["cos_inner"] - light["cos_outer"])
        inner = light["cos_outer"] + width
        at = [a + b for a, b in zip(light["position"], light["direction"])]
        more = (f" spotlight point_at {vector(at)} tightness 0 radius {math.degrees(math.acos(inner)):.9g}"
                f" falloff {math.degrees(math.acos(inner - 2 * width / 3)):.9g}")
    return source_text(light["position"], light["intensity"], more)


def lamp_text(mesh, parts):
    """An emissive triangle as parts^2 lights with the cosine of a diffuse emitter, in the middles of even triangles."""
    text = ""
    for face in mesh.faces if any(mesh.surface.radiance) else []:
        a, b, c = (mesh.points[i] for i in face)
        doubled = cross(minus(b, a), minus(c, a))
        area = math.hypot(*doubled) / 2
        normal = [value / (2 * area) for value in doubled]
        for i in range(parts):
            for j in range(parts - i):
                for third in (1 / 3, 2 / 3)[: 1 if i + j == parts - 1 else 2]:
                    at = [p + q + r - 2 * s + 1e-5 * n for p, q, r, s, n in
                          zip(between(a, b, (i + third) / parts), between(a, c, (j + third) / parts), a, a, normal)]
                    more = f" spotlight point_at {vector([p + n for p, n in zip(at, normal)])} tightness 1 radius 90 falloff 90"
                    text += source_text(at, [area / parts**2 * value for value in mesh.surface.radiance], more)
    return text


def surface_text(surface, photons):
    color = surface.color
    if any(surface.radiance):  # its light_sources light the scene, not its picture
        return (f" no_radiosity texture {{ pigment {{ color rgb {vector(surface.radiance)} }}\n"
                " finish { emission 1 diffuse 0 } }")
    if surface.kind == "diffuse":
        return f" texture {{ pigment {{ color rgb {vector(color)} }} }}"
    if photons == 0:
        return " texture { pigment { color rgb 0 } }"
    target = " photons { target reflection on refraction on collect off }"
    if surface.kind == "mirror":
        return (f" texture {{ pigment {{ color rgb 0 }} finish {{ diffuse 0 reflection {{ rgb {vector(color)} }} }} }}"
                + target)
    # Light fades with exp((fade_color - 1) x length / fade_distance).
    distance, tint = surface.attenuation
    fade = [1 + math.log(value) / 4 for value in tint]
    return (" texture { pigment { color rgbt 1 } finish { diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } }\n"
            f" interior {{ ior {surface.ior} fade_power 1001 fade_distance {distance / 4:.9g} fade_color rgb {vector(fade)} }}"
            + target)


def mesh_text(mesh, photons):
    normals = ""
    if mesh.normals and mesh.surface.kind != "diffuse":
        normals = f" normal_vectors {{ {len(mesh.normals)}, {', '.join(map(vector, mesh.normals))} }}\n"
    return (f"mesh2 {{ vertex_vectors {{ {len(mesh.points)}, {', '.join(map(vector, mesh.points))} }}\n{normals}"
            f" face_indices {{ {len(mesh.faces)}, {', '.join('<%d,%d,%d>' % face for face in mesh.faces)} }}\n"
            f"{surface_text(mesh.surface, photons)} }}\n")


def scene_text(pack, glb, arguments):
    bounces = min(pack["picture"]["bounces"], 20)
    radiosity = (f" radiosity {{ count {arguments.count} nearest_count 10 error_bound {arguments.error_bound}\n"
                 " low_error_factor 0.5 gray_threshold 0\n"
                 f" recursion_limit {bounces} brightness 1 adc_bailout 1e-6 pretrace_start 0.08 pretrace_end 0.01 }}\n"
                 if bounces else "")
    smooth = arguments.photons and any(mesh.surface.kind in ("mirror", "glass") for mesh in glb.meshes)
    photons = (f" photons {{ count {arguments.photons} autostop 0 jitter 0.4 gather 20, 100 max_trace_level 32\n"
               " adc_bailout 1e-4 }\n" if smooth else "")
    return ("#version 3.7;\nglobal_settings { assumed_gamma 1.0 adc_bailout 1e-6 max_trace_level 32\n" + radiosity + photons
            + "}\n#default { finish { ambient 0 diffuse 1 } }\nbackground { color rgb 0 }\n"
            + camera_text(pack["camera"], pack["picture"]) + "".join(map(light_text, pack["lights"]))
            + "".join(lamp_text(mesh, arguments.lamp_parts) for mesh in glb.meshes)
            + "".join(mesh_text(mesh, arguments.photons) for mesh in glb.meshes))


def draw(folder, pack, glb, arguments):
    picture = pack["picture"]
    with tempfile.NamedTemporaryFile("w", suffix=".pov", delete=False) as file:
        file.write(scene_text(pack, glb, arguments))
    aa = ["+A0.0", "+AM1", f"+R{arguments.samples}", "-J"] if arguments.samples > 1 else ["-A"]
    command = ["povray", f"+I{file.name}", f"+O{os.path.join(arguments.entry, picture['file'])}", f"+W{picture['width']}",
               f"+H{picture['height']}", "+FE", "-D", "-GD", "-GR", "-GS", "-GW", *aa]
    start = time.monotonic()
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    except OSError as error:
        sys.exit(f"entry.py: povray does not start: {error}")
    finally:
        os.unlink(file.name)
    seconds = time.monotonic() - start
    if done.returncode:
        sys.exit(f"entry.py: {folder}: povray fails:\n{done.stderr[-2000:]}")
    return picture["file"], seconds


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("entry")
    parser.add_argument("packs", nargs="+")
    parser.add_argument("--count", type=int, default=800, help="rays of a radiosity sample")
    parser.add_argument("--error-bound", type=float, default=.2, help="of radiosity; smaller: more samples")
    parser.add_argument("--photons", type=int, default=1000000, help="photons to mirrors and glass; 0: these are black")
    parser.add_argument("--lamp-parts", type=int, default=4, help="lights along each side of an emissive triangle")
    parser.add_argument("--samples", type=int, default=4, help="samples along each side of a pixel")
    arguments = parser.parse_args()
    packs = [(folder, *read_pack(folder)) for folder in arguments.packs]
    os.makedirs(arguments.entry, exist_ok=True)
    drawn = [draw(*pack, arguments) for pack in packs]
    write_method(arguments.entry, drawn, name="POV-Ray radiosity", version="3.7", url="https://www.povray.org",
                 licence="AGPL-3.0-or-later")


main()
