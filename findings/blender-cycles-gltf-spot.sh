#!/bin/sh
# Cycles of Blender 3.4.1 darkens the spots of glTF away from their axis. A spot of KHR_lights_punctual has one intensity
# up to its inner angle. Imported into Blender and drawn by Cycles, it is right on the axis, and elsewhere it is
# multiplied by the cosine of the angle to the axis: a quarter of the light is missing at 40 degrees.
# The camera stands at the lamp, within a white sphere, so that brightness is intensity.
#
# Seen on Debian 12 with blender 3.4.1+dfsg-2+b1:
#     20 degrees: 0.940 of the axis, cosine 0.940
#     40 degrees: 0.767 of the axis, cosine 0.766
#
# Needs apt-get, dpkg, python3-numpy and 80 MB of packages.
# Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
packages=$(apt-get install -s --reinstall --no-install-recommends "blender=3.4.1+dfsg-2+b1" |
    sed -n 's/^Inst \([^ ]*\) .*/\1/p') || exit 2
apt-get download -qq $packages blender-data=3.4.1+dfsg-2 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > spot.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"name": "lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}}],
 "extensions": {"KHR_lights_punctual": {"lights": [
   {"type": "spot", "intensity": 683, "spot": {"innerConeAngle": 1.2, "outerConeAngle": 1.25}}]}}}
GLTF
cat > spot.py <<'PY'
import os
import bpy, numpy
numpy.bool = bool
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module='io_scene_gltf2')
bpy.ops.import_scene.gltf(filepath='spot.gltf')
scene = bpy.context.scene
lamp = next(thing for thing in bpy.data.objects if thing.type == 'LIGHT')
lamp.data.shadow_soft_size = 0
bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=1)
white = bpy.data.materials.new('white')
white.use_nodes = True
white.node_tree.nodes.clear()
add = white.node_tree.nodes.new
white.node_tree.links.new(add('ShaderNodeBsdfDiffuse').outputs[0], add('ShaderNodeOutputMaterial').inputs[0])
bpy.context.object.data.materials.append(white)
camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
camera.matrix_world, camera.data.angle, camera.data.clip_start = lamp.matrix_world, 2 * numpy.arctan(1.5), .01
scene.collection.objects.link(camera)
scene.camera, scene.render.engine = camera, 'CYCLES'
scene.cycles.samples, scene.cycles.max_bounces, scene.cycles.use_denoising = 16, 0, False
scene.render.resolution_x, scene.render.resolution_y = 120, 4
scene.render.image_settings.file_format = 'OPEN_EXR'
scene.render.image_settings.color_depth = '32'
scene.render.filepath = os.path.abspath('spot.exr')
bpy.ops.render.render(write_still=True)
row = numpy.array(bpy.data.images.load(scene.render.filepath).pixels[:]).reshape(4, 120, 4)[1, :, 0]
for degrees in (20, 40):
    angle = numpy.radians(degrees)
    part = row[int(60 + 60 * numpy.tan(angle) / 1.5)] / row[60]
    like = abs(part - numpy.cos(angle)) < .02
    print(f"{'spot' if like else 'changed'} {degrees} degrees: {part:.3f} of the axis, cosine {numpy.cos(angle):.3f}")
PY
data=$folder/root/usr/share/blender library=$folder/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH="$library:$library/blas:$library/lapack:$library/pulseaudio:$folder/root/usr/lib"
export BLENDER_SYSTEM_SCRIPTS="$data/scripts" BLENDER_SYSTEM_DATAFILES="$data/datafiles"
root/usr/bin/blender -b --factory-startup -noaudio -P spot.py > log 2>&1 || exit 2
sed -n 's/^spot //p; s/^changed //p' log
[ "$(grep -c '^spot' log)" = 2 ]
