"""Draws scene packs with Blender and writes an entry that bench/score.py reads.

    blender -b --factory-startup -P bench/entries/blender/entry.py -- ENTRY PACK... [OPTION ...]

ENTRY is the folder to fill, PACK a folder that `manylight export` made. Tried with Blender 3.4 and 4.3.
"""
import argparse
import json
import math
import os
import struct
import sys
import time

import bpy
import numpy
from mathutils import Matrix, Vector

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from scene_pack import open_pack, write_method  # noqa: E402

# The importer of Blender 3.4 uses names that NumPy 1.24 has no longer.
for name, kind in (("bool", bool), ("int", int), ("float", float)):
    if name not in numpy.__dict__:
        setattr(numpy, name, kind)


def parse_arguments():
    parser = argparse.ArgumentParser(prog="entry.py")
    parser.add_argument("entry")
    parser.add_argument("packs", nargs="+")
    parser.add_argument("--engine", choices=["cycles", "eevee"], default="cycles")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--denoise", action="store_true", help="Open Image Denoise, with albedo and normal")
    parser.add_argument("--probes", type=int, default=4, help="light probes of EEVEE along each axis; 0: direct light")
    parser.add_argument("--seed", type=int, default=0)
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else [])


def turned(vector):
    """glTF has +Y up, Blender +Z."""
    return Vector((vector[0], -vector[2], vector[1]))


# --- materials -------------------------------------------------------------------------------------


def gltf_materials(path):
    """The materials as the file has them: Blender's importer keeps neither side nor reflectance apart."""
    with open(path, "rb") as file:
        file.seek(12)
        size = struct.unpack("<II", file.read(8))[0]
        return json.loads(file.read(size)).get("materials", [])


def is_diffuse(source):
    """As manylight takes it: rough as can be and without a word on reflectance; or without reflectance."""
    surface = source.get("pbrMetallicRoughness", {})
    extensions = source.get("extensions", {})
    if surface.get("metallicFactor", 1) != 0:
        return False
    if extensions.get("KHR_materials_specular", {}).get("specularFactor", 1) == 0:
        return True
    plain = not {"KHR_materials_specular", "KHR_materials_ior"} & set(extensions)
    return plain and surface.get("roughnessFactor", 1) == 1 and "metallicRoughnessTexture" not in surface


class Tree:
    """Nodes of a material, a light or the world, linked as they are made."""

    def __init__(self, owner):
        owner.use_nodes = True
        self.nodes, self.links = owner.node_tree.nodes, owner.node_tree.links

    def add(self, kind, **inputs):
        node = self.nodes.new(kind)
        for name, value in inputs.items():
            socket = node.inputs[int(name[1:]) if name[0] == "_" else name.replace("_", " ")]
            if isinstance(value, bpy.types.NodeSocket):
                self.links.new(value, socket)
            else:
                socket.default_value = value
        return node

    def math(self, operation, *values):
        node = self.add("ShaderNodeMath", **{f"_{i}": value for i, value in enumerate(values)})
        node.operation = operation
        return node.outputs[0]

    def mix(self, factor, first, second):
        return self.add("ShaderNodeMixShader", _0=factor, _1=first, _2=second).outputs[0]


def source_of(socket):
    return socket.links[0].from_socket if socket.is_linked else socket.default_value


def color_of(value):
    return value if isinstance(value, bpy.types.NodeSocket) else tuple(value)[:3] + (1,)


def build_material(material, source, pack):
    tree = Tree(material)
    old = next((node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"), None)
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    if not old:  # unlit: stays as it is
        return
    shader = old.outputs[0]
    glow = old.inputs["Emission Color" if bpy.app.version >= (4, 0, 0) else "Emission"]
    color, emission = source_of(old.inputs["Base Color"]), source_of(glow)
    alpha, strength = source_of(old.inputs["Alpha"]), source_of(old.inputs["Emission Strength"])
    if pack["picture"]["materials"] == "diffuse" or is_diffuse(source):
        shader = tree.add("ShaderNodeBsdfDiffuse", Color=color_of(color), Roughness=0).outputs[0]
    for link in list(glow.links):
        tree.links.remove(link)
    old.inputs["Emission Strength"].default_value = 0
    if pack["emissive_surfaces"] and any(source.get("emissiveFactor", [0])):
        glow = tree.add("ShaderNodeEmission", Color=color_of(emission), Strength=strength).outputs[0]
        shader = tree.add("ShaderNodeAddShader", _0=shader, _1=glow).outputs[0]
    if not source.get("doubleSided", False):
        # Its back is black, and the camera does not see it.
        black = tree.add("ShaderNodeBsdfDiffuse", Color=(0, 0, 0, 1)).outputs[0]
        clear = tree.add("ShaderNodeBsdfTransparent").outputs[0]
        camera = tree.add("ShaderNodeLightPath").outputs["Is Camera Ray"]
        back = tree.add("ShaderNodeNewGeometry").outputs["Backfacing"]
        shader = tree.mix(back, shader, tree.mix(camera, black, clear))
    if isinstance(alpha, bpy.types.NodeSocket) and source.get("alphaMode", "OPAQUE") != "OPAQUE":
        clear = tree.add("ShaderNodeBsdfTransparent").outputs[0]
        cutoff = source.get("alphaCutoff", 0.5) if source["alphaMode"] == "MASK" else 0.5
        shader = tree.mix(tree.math("GREATER_THAN", alpha, cutoff), clear, shader)
    tree.links.new(shader, output.inputs["Surface"])


def build_materials(path, pack):
    sources = gltf_materials(path)
    by_name = {source.get("name", f"Material_{i}"): source for i, source in enumerate(sources)}
    for material in bpy.data.materials:
        name = material.name if material.name in by_name else material.name.rsplit(".", 1)[0]
        if material.use_nodes and material.users:
            build_material(material, by_name.get(name, {}), pack)


# --- camera, lights --------------------------------------------------------------------------------


def place(thing, source, axes):
    """axes: which of the source's vectors the object's own x, y and z are."""
    columns = [turned(vector) for vector in axes] + [turned(source["position"])]
    thing.matrix_world = Matrix([[column[row] for column in columns] for row in range(3)] + [[0, 0, 0, 1]])


def minus(vector):
    return [-value for value in vector]


def add_object(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_camera(source):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    if source["type"] == "orthographic":
        camera.type = "ORTHO"
        camera.ortho_scale = 2 * source["half_height"]
    else:
        camera.lens = camera.sensor_height / 2 / math.tan(math.radians(source["fov_y_degrees"]) / 2)
    camera.clip_start = source["near"] or 1e-3
    camera.clip_end = source["far"] or 1e6
    thing = add_object("camera", camera)
    place(thing, source, (source["right"], source["up"], minus(source["forward"])))
    bpy.context.scene.camera = thing


def set_cone(light, source):
    """The falloff ((cos a - cos outer) / (cos inner - cos outer))^2: by nodes of a point, as the spots of Cycles 3.4
    fall off with the cosine, too. EEVEE, which ignores nodes of lights, has spots with a blend."""
    outer, width = source["cos_outer"], max(0.001, source["cos_inner"] - source["cos_outer"])
    if light.type == "SPOT":
        light.spot_size = 2 * math.acos(outer)
        light.spot_blend = min(1, width / (1 - outer))
        return
    tree = Tree(light)
    tree.nodes.clear()
    incoming = tree.add("ShaderNodeNewGeometry").outputs["Incoming"]
    along = tree.add("ShaderNodeVectorMath", _0=incoming, _1=turned(source["direction"]))
    along.operation = "DOT_PRODUCT"
    part = tree.math("DIVIDE", tree.math("SUBTRACT", along.outputs["Value"], outer), width)
    part = tree.math("MINIMUM", tree.math("MAXIMUM", part, 0.0), 1.0)
    glow = tree.add("ShaderNodeEmission", Strength=tree.math("MULTIPLY", part, part))
    output = tree.add("ShaderNodeOutputLight")
    tree.links.new(glow.outputs[0], output.inputs[0])


def add_panel(source):
    """An area light as a mesh, which the camera sees."""
    width, height = source["width"] / 2, (source["height"] or source["width"]) / 2
    if source["shape"] == "disk":
        around = [2 * math.pi * i / 128 for i in range(128)]
        corners = [(width * math.cos(a), width * math.sin(a), 0) for a in around]
    else:
        corners = [(-width, -height, 0), (width, -height, 0), (width, height, 0), (-width, height, 0)]
    mesh = bpy.data.meshes.new("panel")
    mesh.from_pydata(corners, [], [list(range(len(corners)))])
    material = bpy.data.materials.new("panel")
    tree = Tree(material)
    tree.nodes.clear()
    most = max(source["radiance"]) or 1
    color = tuple(value / most for value in source["radiance"]) + (1,)
    glow = tree.add("ShaderNodeEmission", Color=color, Strength=most).outputs[0]
    clear = tree.add("ShaderNodeBsdfTransparent").outputs[0]
    back = tree.add("ShaderNodeNewGeometry").outputs["Backfacing"]
    output = tree.add("ShaderNodeOutputMaterial", Surface=tree.mix(back, glow, clear))
    assert output
    mesh.materials.append(material)
    thing = add_object("panel", mesh)
    place(thing, source, (minus(source["right"]), source["up"], source["direction"]))


def add_light(source):
    kinds = {"spot": "SPOT", "point": "POINT", "directional": "SUN", "area": "AREA"}
    value = source["irradiance"] or source["intensity"]
    if bpy.context.scene.render.engine == "CYCLES":
        kinds["spot"] = "POINT"
        if source["type"] == "area":
            add_panel(source)
            return
    light = bpy.data.lights.new(source["type"], kinds[source["type"]])
    most = max(value) or 1
    light.color = [part / most for part in value]
    if source["type"] == "directional":
        light.energy = most  # W/m2
        light.angle = math.radians(source["angle_degrees"] or 0)
    elif source["type"] == "area":
        light.energy = math.pi * most
        light.shape = "DISK" if source["shape"] == "disk" else "RECTANGLE"
        light.size, light.size_y = source["width"], source["height"] or source["width"]
    else:
        light.energy = 4 * math.pi * most  # a watt of Blender's is one into all directions, of spots, too
        light.shadow_soft_size = (source["width"] or 0) / 2
    if source["type"] == "spot":
        set_cone(light, source)
    thing = add_object(source["type"], light)
    place(thing, source, (source["right"], source["up"], minus(source["direction"])))


def set_world(folder, environment):
    world = bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    tree = Tree(world)
    tree.nodes.clear()
    background = tree.add("ShaderNodeBackground", Color=(0, 0, 0, 1))
    output = tree.add("ShaderNodeOutputWorld", Surface=background.outputs[0])
    assert output
    if not environment:
        return
    # Blender's panorama lies as manylight's; a turn goes from +Z of glTF towards +X.
    where = tree.add("ShaderNodeTexCoord").outputs["Generated"]
    turn = (0, 0, -math.radians(environment["turn_degrees"]))
    picture = tree.add("ShaderNodeTexEnvironment",
                       Vector=tree.add("ShaderNodeMapping", Vector=where, Rotation=turn).outputs[0])
    picture.image = bpy.data.images.load(os.path.abspath(os.path.join(folder, environment["file"])))
    newer = bpy.app.version >= (4, 0, 0)
    picture.image.colorspace_settings.name = "Linear Rec.709" if newer else "Linear"
    picture.interpolation = "Closest"
    tree.links.new(picture.outputs[0], background.inputs["Color"])
    background.inputs["Strength"].default_value = environment["strength"]
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = max(1024, environment["width"])


# --- rendering -------------------------------------------------------------------------------------


def set_cycles(scene, picture, arguments):
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = arguments.spp
    cycles.seed = arguments.seed
    cycles.use_adaptive_sampling = False
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = picture["bounces"]
    cycles.transmission_bounces = cycles.volume_bounces = 0
    cycles.transparent_max_bounces = 64
    # Defaults that lose light.
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.use_denoising = arguments.denoise
    if arguments.denoise:
        cycles.denoiser = "OPENIMAGEDENOISE"
        cycles.denoising_input_passes = "RGB_ALBEDO_NORMAL"


def set_eevee(scene, picture, arguments):
    eevee = scene.eevee
    eevee.taa_render_samples = arguments.spp
    eevee.use_gtao = False
    eevee.use_soft_shadows = True
    eevee.shadow_cube_size, eevee.shadow_cascade_size = "2048", "2048"
    eevee.use_shadow_high_bitdepth = True
    eevee.light_threshold = 1e-4
    eevee.gi_diffuse_bounces = picture["bounces"]
    eevee.gi_glossy_clamp = 0
    scene.render.filter_size = 0.01
    if arguments.probes == 0:
        return
    corners = [thing.matrix_world @ Vector(corner) for thing in scene.objects if thing.type == "MESH"
               for corner in thing.bound_box]
    low = Vector([min(corner[axis] for corner in corners) for axis in range(3)])
    high = Vector([max(corner[axis] for corner in corners) for axis in range(3)])
    bpy.ops.object.lightprobe_add(type="GRID", location=(low + high) / 2)
    probe = bpy.context.object
    probe.scale = (high - low) / 2
    probe.data.influence_distance = 0.1
    for axis in "xyz":
        setattr(probe.data, f"grid_resolution_{axis}", arguments.probes)
    bpy.ops.scene.light_cache_bake()


def build(folder, arguments):
    pack = open_pack(folder)
    path = os.path.join(folder, pack["scene"]["file"])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES" if arguments.engine == "cycles" else "BLENDER_EEVEE"
    bpy.ops.import_scene.gltf(filepath=path)
    for thing in list(bpy.data.objects):
        if thing.type in ("LIGHT", "CAMERA"):
            bpy.data.objects.remove(thing)
    scene.render.fps = 1000
    scene.frame_set(round(1000 * pack["scene"]["time_s"]))
    build_materials(path, pack)
    add_camera(pack["camera"])
    for light in pack["lights"]:
        add_light(light)
    set_world(folder, pack["environment"])
    return pack


def set_output(scene, picture, path):
    render = scene.render
    render.resolution_x, render.resolution_y = picture["width"], picture["height"]
    render.resolution_percentage = 100
    render.film_transparent = False
    render.dither_intensity = 0
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.image_settings.color_mode = "RGB"
    # EXR is linear whatever the view; these keep it so.
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.exposure, scene.view_settings.gamma = 0, 1
    render.filepath = os.path.abspath(path)


def draw(folder, arguments):
    """Returns the picture's name, and the seconds of rendering, and of the work before it."""
    pack = build(folder, arguments)
    scene, picture = bpy.context.scene, pack["picture"]
    set_output(scene, picture, os.path.join(arguments.entry, picture["file"]))
    start = time.monotonic()
    if arguments.engine == "cycles":
        set_cycles(scene, picture, arguments)
    else:
        set_eevee(scene, picture, arguments)
    ready = time.monotonic()
    bpy.ops.render.render(write_still=True)
    return picture["file"], time.monotonic() - ready, ready - start


def processor():
    try:
        with open("/proc/cpuinfo") as file:
            names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
        return f"{names[0]}, {len(names)} threads"
    except (OSError, IndexError):
        return None


def write(arguments, drawn):
    cycles = arguments.engine == "cycles"
    name = "Blender Cycles" if cycles else "Blender EEVEE"
    write_method(arguments.entry, [(file, seconds) for file, seconds, _ in drawn],
                 "a picture of each scene, with its acceleration structure and the file",
                 name=f"{name}, {arguments.spp} spp" + (", denoised" if arguments.denoise and cycles else ""),
                 version=bpy.app.version_string, url="https://www.blender.org", licence="GPL-2.0-or-later",
                 device=processor(), driver=None, layers=None,
                 denoiser="Open Image Denoise" if arguments.denoise and cycles else None,
                 precomputed_s=None if cycles else max(before for _, _, before in drawn))


def check_denoiser(arguments):
    import _cycles

    if arguments.denoise and arguments.engine == "eevee":
        raise SystemExit("entry.py: --denoise is for --engine cycles")
    if arguments.denoise and not _cycles.with_openimagedenoise:
        raise SystemExit("entry.py: --denoise: this Blender is built without Open Image Denoise, as Debian's is")


def main():
    arguments = parse_arguments()
    check_denoiser(arguments)
    for folder in arguments.packs:
        open_pack(folder)
    os.makedirs(arguments.entry, exist_ok=True)
    write(arguments, [draw(folder, arguments) for folder in arguments.packs])


try:
    main()
except SystemExit as end:
    if isinstance(end.code, str):
        print(end.code, file=sys.stderr)
    sys.stdout.flush()
    os._exit(1 if end.code else 0)
except Exception:
    import traceback

    traceback.print_exc()
    os._exit(1)
