#!/bin/sh
# Assimp 5.2.5 keeps one of several lamps that share a light. In glTF a row of lamps is one light of KHR_lights_punctual
# and a node for each lamp. The model of Assimp has the lamp of the last node alone; the others are dark, without a word.
# Who loads scenes by Assimp gets a darker room than the file describes. The JSON is valid glTF 2.0.
#
# Seen on Debian 12 with libassimp-dev 5.2.5~ds0-1+b1:
#     3 lamps in the file, 1 in the model: lamp-c
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
cat > lamps.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
 "nodes": [{"name": "lamp-a", "translation": [-1, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
           {"name": "lamp-b", "translation": [0, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
           {"name": "lamp-c", "translation": [1, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
           {"mesh": 0}],
 "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}},
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri":
 "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
GLTF
cat > lamps.cpp <<'CPP'
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cstdio>
int main() {
    Assimp::Importer importer;
    const aiScene *scene = importer.ReadFile("lamps.gltf", 0);
    if (!scene)
        return 2;
    std::printf("3 lamps in the file, %u in the model:", scene->mNumLights);
    for (unsigned i = 0; i < scene->mNumLights; i++)
        std::printf(" %s", scene->mLights[i]->mName.C_Str());
    std::printf("\n");
    return scene->mNumLights == 1 ? 0 : 1;
}
CPP
library=root/usr/lib/x86_64-linux-gnu
g++ -O0 -isystem root/usr/include lamps.cpp -o lamps -L"$library" -lassimp -Wl,-rpath-link,"$library" || exit 2
LD_LIBRARY_PATH="$folder/$library" ./lamps
