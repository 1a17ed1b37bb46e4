#!/bin/sh
# Blender 3.4.1 of Debian 12 cannot import glTF: its add-on uses numpy.bool, which numpy 1.24 of
# Debian 12 no longer has. The file is a valid triangle. `import numpy; numpy.bool = bool` before the import helps.
#
# Seen on Debian 12 with blender 3.4.1+dfsg-2+b1 and python3-numpy 1:1.24.2-1+deb12u1:
#     import: AttributeError: module 'numpy' has no attribute 'bool'.
#     import with numpy.bool: 1 mesh
#
# Needs apt-get, dpkg, python3-numpy and 80 MB of packages.
# Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=3.4.1+dfsg-2
packages=$(apt-get install -s --no-install-recommends "blender=$version+b1" | sed -n 's/^Inst \([^ ]*\) .*/\1/p') || exit 2
apt-get download -qq $packages 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > triangle.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":
 "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
GLTF
cat > import.py <<'PY'
import bpy, numpy
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module='io_scene_gltf2')
try:
    bpy.ops.import_scene.gltf(filepath='triangle.gltf')
    print('import: %d mesh' % len(bpy.data.meshes))
except RuntimeError as error:
    print('\nimport:', [line for line in str(error).split('\n') if 'Error:' in line and 'numpy' in line][0])
numpy.bool = bool
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath='triangle.gltf')
print('import with numpy.bool: %d mesh' % len(bpy.data.meshes))
PY
data=$folder/root/usr/share/blender library=$folder/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH="$library:$library/blas:$library/lapack:$library/pulseaudio:$folder/root/usr/lib"
export BLENDER_SYSTEM_SCRIPTS="$data/scripts" BLENDER_SYSTEM_DATAFILES="$data/datafiles"
root/usr/bin/blender -b -P import.py > log 2>&1 || exit 2
grep '^import' log || exit 2
grep -q "^import: AttributeError: module 'numpy' has no attribute 'bool'" log
