#!/bin/sh
# tinygltf 2.7.0 leaves out empty objects in a list of an extension, so later elements get smaller numbers than in the
# file. A variant of KHR_materials_variants without any field is such an element. The JSON is valid glTF 2.0.
#
# Seen on Debian 12 with libtinygltf-dev 2.7.0+dfsg-2:
#     3 elements in the file, 2 in the model
#
# Needs apt-get, dpkg and g++. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libtinygltf-dev=2.7.0+dfsg-2 nlohmann-json3-dev=3.11.2-2 || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > list.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "extensions": {"VENDOR_list": {"items": [{"name": "a"}, {}, {"name": "c"}]}}}
GLTF
cat > list.cpp <<'CPP'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>
#include <cstdio>
int main() {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error, warning;
    if (!loader.LoadASCIIFromFile(&model, &error, &warning, "list.gltf"))
        return 2;
    const tinygltf::Value &items = model.extensions["VENDOR_list"].Get("items");
    std::printf("3 elements in the file, %zu in the model\n", items.ArrayLen());
    return items.ArrayLen() == 2 ? 0 : 1;
}
CPP
g++ -std=c++17 -O0 -isystem root/usr/include list.cpp -o list || exit 2
./list
