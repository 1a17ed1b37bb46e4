#!/bin/sh
# Assimp 5.2.5 widens cameras of glTF: its horizontal angle is yfov times the aspect ratio. The angle that the file
# describes is 2 atan(tan(yfov / 2) aspect). A view 1 rad high and twice as wide has 1.66 rad in glTF, 2 rad in Assimp:
# pictures by the model's camera do not match those of other renderers, and above pi the angle has no meaning.
#
# Seen on Debian 12 with libassimp-dev 5.2.5~ds0-1+b1:
#     horizontal angle: 2.0000 of Assimp, 1.6592 of the file
#
# Needs apt-get, dpkg and g++. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
packages=$(apt-get install -s --reinstall --no-install-recommends libassimp-dev=5.2.5~ds0-1+b1 |
    sed -n 's/^Inst \([^ ]*\) .*/\1/p') || exit 2
apt-get download -qq $packages libassimp5 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > camera.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}], "nodes": [{"camera": 0}, {"mesh": 0}],
 "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": 2, "znear": 0.1, "zfar": 10}}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":
 "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
GLTF
cat > camera.cpp <<'CPP'
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cmath>
#include <cstdio>
int main() {
    Assimp::Importer importer;
    const aiScene *scene = importer.ReadFile("camera.gltf", 0);
    if (!scene || scene->mNumCameras != 1)
        return 2;
    float angle = scene->mCameras[0]->mHorizontalFOV;
    std::printf("horizontal angle: %.4f of Assimp, %.4f of the file\n", angle, 2 * std::atan(std::tan(.5) * 2));
    return std::fabs(angle - 2) < 1e-4 ? 0 : 1;
}
CPP
library=root/usr/lib/x86_64-linux-gnu
g++ -O0 -isystem root/usr/include camera.cpp -o camera -L"$library" -lassimp -Wl,-rpath-link,"$library" || exit 2
LD_LIBRARY_PATH="$folder/$library" ./camera
