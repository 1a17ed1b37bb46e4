#!/bin/sh
# Blender 3.4.1 finds no Cryptomatte whose channels have a dot in the layer's name, if the EXR file holds a picture in R, G
# and B, too. The matte of the layer "crypto.node" is empty then, without a warning. The same values as "crypto_node" give
# the matte, and so do those of "crypto.node" in a file without R, G and B.
#
# Seen on Debian 12 with blender 3.4.1+dfsg-2+b1 and python3-openimageio 2.4.7.1+dfsg-2. The files have 8x8 pixels, whose
# left half has the id and coverage 1:
#     crypto_node: matte 0.5 of the picture
#     crypto.node: matte 0.0 of the picture
#
# Needs apt-get, dpkg, python3-numpy and 80 MB of packages.
# Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
packages=$(apt-get install -s --reinstall --no-install-recommends "blender=3.4.1+dfsg-2+b1" \
    python3-openimageio=2.4.7.1+dfsg-2 | sed -n 's/^Inst \([^ ]*\) .*/\1/p') || exit 2
apt-get download -qq $packages blender-data=3.4.1+dfsg-2 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > write.py <<'PY'
import OpenImageIO, numpy
size, key = 8, 'cryptomatte/1234567/'
for layer in ('crypto_node', 'crypto.node'):
    pixels = numpy.zeros((size, size, 7), 'f')
    pixels[:, :size // 2, 3:5] = 1.5, 1    # id, coverage
    spec = OpenImageIO.ImageSpec(size, size, 7, 'float')
    spec.channelnames = ['R', 'G', 'B'] + [f'{layer}00.{c}' for c in 'rgba']
    texts = {'name': layer, 'hash': 'MurmurHash3_32', 'conversion': 'uint32_to_float32', 'manifest': '{"box":"3fc00000"}'}
    for name, text in texts.items():
        spec.attribute(key + name, text)
    file = OpenImageIO.ImageOutput.create(layer + '.exr')
    file.open(layer + '.exr', spec)
    file.write_image(pixels)
    file.close()
PY
cat > read.py <<'PY'
import os
import bpy
scene = bpy.context.scene
scene.use_nodes = True
nodes, render = scene.node_tree.nodes, scene.render
render.resolution_x = render.resolution_y = 8
render.resolution_percentage = 100
render.image_settings.file_format, render.image_settings.color_depth = 'OPEN_EXR', '32'
for layer in ('crypto_node', 'crypto.node'):
    nodes.clear()
    matte, end = nodes.new('CompositorNodeCryptomatteV2'), nodes.new('CompositorNodeComposite')
    matte.source, matte.image = 'IMAGE', bpy.data.images.load(os.path.abspath(layer + '.exr'))
    matte.image.pixels[:1]
    matte.layer_name, matte.matte_id = layer, '<1.5>'
    scene.node_tree.links.new(matte.outputs['Matte'], end.inputs['Image'])
    render.filepath = os.path.abspath('matte.exr')
    bpy.ops.render.render(write_still=True)
    seen = bpy.data.images.load(render.filepath)
    print(f'seen {layer}: matte {sum(list(seen.pixels)[::4]) / 64:.1f} of the picture')
    bpy.data.images.remove(seen)
PY
data=$folder/root/usr/share/blender library=$folder/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH="$library:$library/blas:$library/lapack:$library/pulseaudio:$folder/root/usr/lib"
export BLENDER_SYSTEM_SCRIPTS="$data/scripts" BLENDER_SYSTEM_DATAFILES="$data/datafiles"
PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 write.py || exit 2
root/usr/bin/blender -b --factory-startup -noaudio -P read.py > log 2>&1 || exit 2
sed -n 's/^seen //p' log
grep -q '^seen crypto_node: matte 0.5' log && grep -q '^seen crypto.node: matte 0.0' log
