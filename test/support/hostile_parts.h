/* Tiny glTF files of which one part is wrong, and what each is refused with. */
#ifndef TEST_HOSTILE_PARTS_H
#define TEST_HOSTILE_PARTS_H

#include "gltf_parts.h"

/* An accessor list whose positions or indices are replaced. */
#define POSITIONS(fields) "[{" fields "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE "}]"
#define INDICES(fields) "[{bufferView: 0," VECTORS "}, {" fields "}]"
#define VECTORS "componentType: 5126, count: 4, type: VEC3"
#define INDEX_TYPE "componentType: 5123, count: 6, type: SCALAR"
#define PRIMITIVE(fields) "[{name: quad, primitives: [{" fields "}]}]"
#define FOUR(type)                                                                                 \
    "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE                     \
    "}, {bufferView: 0, byteOffset: 64, componentType: " type                                      \
    ", count: 4, type: VEC4}, {bufferView: 0, byteOffset: 80, componentType: 5126, count: 4, "     \
    "type: VEC4}]"
#define JOINTS(joints, weights)                                                                    \
    "attributes: {POSITION: 0, JOINTS_0: " joints ", WEIGHTS_0: " weights "}, indices: 1"
#define ANIMATION(target, input, output)                                                           \
    "animations: [{samplers: [{input: " input ", output: " output                                  \
    "}], channels: [{sampler: 0, target: {" target "}}]}],"
#define BALLS(count, cell, period, low)                                                            \
    "{count: " count ", reach: 0.5, cell: " cell ", period: " period ", low: " low                 \
    ", high: [4, 4, 4]}"
#define NODE(fields) "[{name: one, mesh: 0, " fields "}]"

static const float nan_position[12] = {0, 0, 0, 0, 0x1p127F * 2, 0, 1, 1, 1, 2, 2, 2};
static const float negative_weights[16] = {-1, 1, 0, 0};
static const struct {
    unsigned char joints[4][4];
    float weights[4][4];
} second_joint = {{{1}}, {{1}}};
static const uint16_t wild_index[6] = {0, 1, 2, 0, 2, 17};

struct hostile {
    /* The message comes after "FILE: "; "note: " begins that of a file that opens with such a note,
     * or with none that matters, and is refused under --strict where there is one. */
    const char *name, *message;
    struct gltf_parts parts;
};

#define CASE(name, message, ...)                                                                   \
    {                                                                                              \
        name, message, {                                                                           \
            __VA_ARGS__                                                                            \
        }                                                                                          \
    }

static const struct hostile hostile[] = {
    CASE("no version", "asset: it has no 'version'", .asset = "{}"),
    CASE("old version", "glTF version 1.0; 2.0 is read", .asset = "{version: '1.0'}"),
    CASE("future version", "it needs glTF version \"2.1\"; 2.0 is read",
         .asset = "{version: '2.1', minVersion: '2.1'}"),
    CASE("required extension", "it requires the extension 'KHR_unheard_of', which is not read",
         .more = "extensionsRequired: [KHR_unheard_of],"),

    CASE("buffer of another type", "buffers: 7 is not an array", .buffers = "7"),
    CASE("empty buffer",
         "note: buffer views beyond byteLength, where there are bytes, are read: buffer view 0",
         .buffers = "[{byteLength: 0}]"),
    CASE("buffer larger than BIN",
         "note: buffers that have fewer bytes than they say are read as far as they are: buffer 0: "
         "320 bytes, not 1000",
         .buffers = "[{byteLength: 1000}]"),
    CASE("buffer without uri", "note: ", .buffers = "[{byteLength: 320}, {byteLength: 4}]"),
    CASE("negative size", "buffer 0: byteLength: -4 is not a whole number from 0",
         .buffers = "[{byteLength: -4}]"),
    CASE("missing buffer", "buffer 0: cannot open build",
         .buffers = "[{byteLength: 320, uri: 'missing.bin'}]"),
    CASE("parent folder", "buffer view 0: 320 bytes at 0 are outside buffer 0 of 6 bytes",
         .buffers = "[{byteLength: 320, uri: '../secret.bin'}]"),
    CASE("encoded parent folder", "buffer 0: 'x/../../../secret.bin' leads out of the folder ",
         .buffers = "[{byteLength: 320, uri: 'x/%2E%2E/%2e./%2e%2E/secret.bin'}]"),
    CASE("backslashes", "buffer 0: '..\\..\\secret.bin' leads out of the folder ",
         .buffers = "[{byteLength: 320, uri: \"..\\\\..\\\\secret.bin\"}]"),
    CASE("absolute path", "buffer 0: '/etc/passwd' leads out of the folder ",
         .buffers = "[{byteLength: 320, uri: '/etc/passwd'}]"),
    CASE("URL", "buffer 0: 'file:///etc/passwd' leads out of the folder ",
         .buffers = "[{byteLength: 320, uri: 'file:///etc/passwd'}]"),
    CASE("link out of the folder", "buffer 0: 'link.bin' leads out of the folder ",
         .buffers = "[{byteLength: 320, uri: 'link.bin'}]"),
    CASE("folder as a buffer", "folder: not a file", .buffers = "[{byteLength: 320, uri: folder}]"),
    CASE("data of another size", "buffer view 0: 320 bytes at 0 are outside buffer 0 of 3 bytes",
         .buffers = "[{byteLength: 320, uri: 'data:application/octet-stream;base64,AAAA'}]"),
    CASE("data in plain text", "buffer view 0: 320 bytes at 0 are outside buffer 0 of 3 bytes",
         .buffers = "[{byteLength: 3, uri: 'data:text/plain,abc'}]"),
    CASE("data with wrong digits",
         "buffer 0: its data URI has the byte 0x2A at 1, which is no digit of base64",
         .buffers = "[{byteLength: 3, uri: 'data:application/octet-stream;base64,A*AA'}]"),

    CASE("view beyond its buffer",
         "buffer view 0: 321 bytes at 0 are outside buffer 0 of 320 bytes",
         .views = "[{buffer: 0, byteLength: 321}]"),
    CASE("view offset near 2^64", "buffer view 0: 320 bytes at 18446744073709551600 are outside",
         .views = "[{buffer: 0, byteOffset: 18446744073709551600, byteLength: 320}]"),
    CASE("view offset beyond 2^64",
         "buffer view 0: byteOffset: 1.8446744073709552e+22 is not a whole",
         .views = "[{buffer: 0, byteOffset: 18446744073709551616000, byteLength: 320}]"),
    CASE("view of no buffer", "buffer view 0: buffer: 1, but there are 1 buffers",
         .views = "[{buffer: 1, byteLength: 320}]"),
    CASE("view of buffer 2^32", "buffer view 0: buffer: 4294967296, but there are 1 buffers",
         .views = "[{buffer: 4294967296, byteLength: 320}]"),
    CASE("stride", "primitive 0: POSITION: accessor 0: a stride of 6 for elements of 12 bytes",
         .views = "[{buffer: 0, byteLength: 320, byteStride: 6}]"),
    CASE("stride below the element",
         "mesh 0 'quad': primitive 0: POSITION: accessor 0: a stride of 4 for elements of 12 bytes",
         .views = "[{buffer: 0, byteLength: 320, byteStride: 4}]"),

    CASE("accessor beyond its view",
         "mesh 0 'quad': primitive 0: POSITION: accessor 0: 27 elements of 12 bytes at 0 are "
         "outside buffer view 0 of 320 bytes",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126, count: 27, type: VEC3")),
    CASE("accessor offset near 2^64",
         "primitive 0: POSITION: accessor 0: 4 elements of 12 bytes at 1844",
         .accessors = POSITIONS("bufferView: 0, byteOffset: 18446744073709551612," VECTORS)),
    CASE("count near 2^64",
         "primitive 0: POSITION: accessor 0: 1844674407370955161 elements of 12 bytes",
         .accessors = POSITIONS(
             "bufferView: 0, componentType: 5126, count: 1844674407370955161, type: VEC3")),
    CASE("count without bytes", "primitive 0: POSITION: accessor 0: more than 128 million",
         .accessors = POSITIONS("componentType: 5126, count: 1844674407370955161, type: VEC3")),
    CASE("count 0", "there is no triangle",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126, count: 0, type: VEC3")),
    CASE("component type", "accessor 0: componentType: 5130 is none of 5120 5121",
         .accessors = POSITIONS("bufferView: 0, componentType: 5130, count: 4, type: VEC3")),
    CASE("element type", "accessor 0: type: \"VEC5\" is none of SCALAR VEC2",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126, count: 4, type: VEC5")),
    CASE("positions in two dimensions",
         "primitive 0: POSITION: accessor 0 has 2 numbers an element, not 3",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126, count: 4, type: VEC2")),
    CASE("matrices", "primitive 0: POSITION: accessor 0: it holds matrices, and not",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126, count: 4, type: MAT3")),
    CASE("sparse index",
         "mesh 0 'quad': primitive 0: POSITION: sparse index 16256 is outside its 4 elements",
         .accessors = POSITIONS(VECTORS ", sparse: {count: 1, indices: {bufferView: 0, byteOffset: "
                                        "14, componentType: 5123}, values: {bufferView: 0}}")),
    CASE("sparse values", "accessor 0: sparse: 4 elements of 12 bytes at 300 are outside",
         .accessors =
             POSITIONS(VECTORS ", sparse: {count: 4, indices: {bufferView: 0, componentType: "
                               "5121}, values: {bufferView: 0, byteOffset: 300}}")),
    CASE("sparse count", "accessor 0: sparse: 5 elements replace 4",
         .accessors = POSITIONS(VECTORS ", sparse: {count: 5, indices: {bufferView: 0, "
                                        "componentType: 5121}, values: {bufferView: 0}}")),
    CASE("sparse without values", "accessor 0: sparse: it has no 'values'",
         .accessors = POSITIONS(
             VECTORS ", sparse: {count: 1, indices: {bufferView: 0, componentType: 5121}}")),

    CASE("no such accessor", "mesh 0 'quad': primitive 0: attributes: POSITION: 9, but there are 2",
         .meshes = PRIMITIVE("attributes: {POSITION: 9}")),
    CASE("no position", "there is no triangle", .meshes = PRIMITIVE("attributes: {NORMAL: 0}")),
    CASE("no attributes", "mesh 0 'quad': primitive 0: it has no 'attributes'",
         .meshes = PRIMITIVE("indices: 1")),
    CASE("no such material", "mesh 0 'quad': primitive 0: material: 1, but there are 1 materials",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, material: 1")),
    CASE("no such mode", "mesh 0 'quad': primitive 0: mode: 7 is none of 0 1 2 3 4 5 6",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, mode: 7")),
    CASE("negative index", "mesh 0 'quad': primitive 0: indices: -1, but there are 2 accessors",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: -1")),
    CASE("half a triangle",
         "note: indices that make no whole triangle are ignored: mesh 0 'quad': primitive 0",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}")),
    CASE("index out of range", "mesh 0 'quad': primitive 0: index 17 is outside its 4 vertices",
         .accessors = INDICES("bufferView: 0, byteOffset: 64," INDEX_TYPE), EXTRA(wild_index)),
    CASE("indices of floats", "primitive 0: indices: accessor 1 does not hold unsigned numbers",
         .accessors = INDICES("bufferView: 0, componentType: 5126, count: 6, type: SCALAR")),
    CASE("indices without a view", "note: ", .accessors = INDICES(INDEX_TYPE)),
    CASE("position not finite", "primitive 0: the position of vertex 1 is not finite",
         .accessors = POSITIONS("bufferView: 0, byteOffset: 64," VECTORS), EXTRA(nan_position)),
    CASE("normals too few", "primitive 0: NORMAL: 3 elements, not 4",
         .accessors = "[{bufferView: 0," VECTORS
                      "}, {bufferView: 0, componentType: 5126, count: 3, type: VEC3}]",
         .meshes = PRIMITIVE("mode: 5, attributes: {POSITION: 0, NORMAL: 1}")),
    CASE("no triangles", "there is no triangle", .nodes = "[{}]"),

    CASE("node matrix of 15", "node 0 'one': matrix: not an array of 16 numbers",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]")),
    CASE("matrix with words", "node 0 'one': matrix: not an array of 16 numbers",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,'NaN']")),
    CASE("matrix too large", "node 0 'one': matrix: 1e+300 is too large",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,0, 0,0,1,0, 1e300,0,0,1]")),
    CASE("infinite scale", "number overflow parsing '1e999'", .nodes = NODE("scale: [1e999,1,1]")),
    CASE("NaN", "syntax error while parsing value", .nodes = NODE("scale: [NaN,1,1]")),
    CASE("matrix not affine", "node 0 'one': matrix: its last row is not 0 0 0 1",
         .nodes = NODE("matrix: [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]")),
    CASE("zero rotation", "note: a quaternion of length 0 turns nothing: node 0 'one': rotation",
         .nodes = NODE("rotation: [0,0,0,0]")),
    CASE("far away", "mesh 0 'quad': a vertex lies 1e+30 m from the world's origin",
         .nodes = NODE("translation: [1e30,0,0]")),
    CASE("its own child", "node 0 'one': it is its own ancestor", .nodes = NODE("children: [0]")),
    CASE("loop", "node 1: it is its own ancestor",
         .nodes = "[{mesh: 0}, {children: [2]}, {children: [1]}]"),
    CASE("two parents", "node 2 'c': it has two parents, nodes 0 and 1",
         .nodes = "[{children: [2]}, {children: [2]}, {name: c, mesh: 0}]"),
    CASE("instances of two counts", "node 0 'one': instances: ROTATION: 6 elements, not 4",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {bufferView: 0, componentType: 5126, count: 6, type: VEC4}]",
         .nodes = NODE(
             "extensions: {EXT_mesh_gpu_instancing: {attributes: {TRANSLATION: 0, ROTATION: 2}}}")),
    CASE("instances without number", "of memory are wanted",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {componentType: 5126, count: 100000000, type: VEC3}]",
         .nodes = NODE("extensions: {EXT_mesh_gpu_instancing: {attributes: {TRANSLATION: 2}}}")),
    CASE("no such place",
         "node 0 'one': extensions: EXT_mesh_gpu_instancing: attributes: SCALE: 9, but there are 2",
         .nodes = NODE("extensions: {EXT_mesh_gpu_instancing: {attributes: {SCALE: 9}}}")),
    CASE("no such child", "node 0 'one': children: 5, but there are 1 nodes",
         .nodes = NODE("children: [5]")),
    CASE("no such mesh", "node 0: mesh: 1, but there are 1 meshes", .nodes = "[{mesh: 1}]"),
    CASE("no such camera", "node 0 'one': camera: 0, but there are 0 cameras",
         .nodes = NODE("camera: 0")),
    CASE("no such light",
         "node 0 'one': extensions: KHR_lights_punctual: light: 0, but there are 0",
         .nodes = NODE("extensions: {KHR_lights_punctual: {light: 0}}")),
    CASE("no such scene", "scene: 2, but there are 1 scenes",
         .more = "scenes: [{nodes: [0]}], scene: 2,"),
    CASE("no such root", "scene 0: nodes: 1, but there are 1 nodes",
         .more = "scenes: [{nodes: [1]}],"),

    CASE("radius less than none", "light 0 'bulb': extras: radius: it is no number from 0 to 5e+08",
         .more = "extensions: {KHR_lights_punctual: {lights: [{name: bulb, type: point, extras: "
                 "{radius: -1}}]}},"),
    CASE("radius in words", "light 0: extras: radius: it is no number from 0 to 5e+08",
         .more = "extensions: {KHR_lights_punctual: {lights: [{type: spot, spot: {}, extras: "
                 "{radius: wide}}]}},"),
    CASE("size with one side", "light 0: extras: size: these are no two lengths",
         .more = "extensions: {KHR_lights_punctual: {lights: [{type: spot, spot: {}, extras: "
                 "{size: [1]}}]}},"),
    CASE("sun all around", "light 0: extras: angle: it is no number from 0 to 3.14159",
         .more = "extensions: {KHR_lights_punctual: {lights: [{type: directional, extras: {angle: "
                 "7}}]}},"),
    CASE("area light without area", "area light 0 'panel': size: 0 by 0 m",
         .more = "extensions: {EXT_lights_area: {lights: [{name: panel, type: rect, size: 0}]}},"),
    CASE("no such area light",
         "node 0 'one': extensions: EXT_lights_area: light: 0, but there are 0",
         .nodes = NODE("extensions: {EXT_lights_area: {light: 0}}")),
    CASE("field of view", "camera 0: yfov: 3.5 radians",
         .more = "cameras: [{type: perspective, perspective: {yfov: 3.5, znear: 1}}],"),
    CASE("camera without parameters", "camera 0: it has no 'orthographic'",
         .more = "cameras: [{type: orthographic}],"),

    CASE("base colour of three",
         "note: colours of other than 3 or 4 numbers are cut or made opaque: material 0: "
         "baseColorFactor",
         .materials = "[{pbrMetallicRoughness: {baseColorFactor: [1, 1, 1]}}]"),
    CASE("more than metal",
         "note: numbers that are not from 0 to 1 are clamped: material 0: metallicFactor",
         .materials = "[{pbrMetallicRoughness: {metallicFactor: 1.5}}]"),
    CASE("roughness that is no number",
         "material 0: pbrMetallicRoughness: roughnessFactor: \"high\" is not a number",
         .materials = "[{pbrMetallicRoughness: {roughnessFactor: high}}]"),
    CASE("emission that takes light away",
         "material 0 'hole': emissiveFactor: it is negative or above 1e+12",
         .materials = "[{name: hole, emissiveFactor: [0, -1, 0]}]"),
    CASE("emission without bound", "material 0: emissiveFactor: it is negative or above 1e+12",
         .materials = "[{emissiveFactor: [1, 1, 1], extensions: {KHR_materials_emissive_strength: "
                      "{emissiveStrength: 1e39}}}]"),
    CASE("no such texture", "baseColorTexture: index: 0, but there are 0 textures",
         .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]"),
    CASE("alpha mode", "note: words that do not exist are left out: material 0 'leaf': alphaMode",
         .materials = "[{name: leaf, alphaMode: HOLES}]"),
    CASE("missing picture",
         "note: replaced, colours by a magenta checker: image 0 'lion': cannot open build",
         .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
         .more = "images: [{uri: 'lion.png', name: lion}], textures: [{source: 0}],"),
    CASE("picture outside", "material 0: image 0: '../../lion.png' leads out of the folder ",
         .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
         .more = "images: [{uri: '../../lion.png'}], textures: [{source: 0}],"),
    CASE("picture of another kind",
         "note: magenta checker: image 0: not a picture of a known format",
         .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
         .more = "images: [{bufferView: 0, mimeType: 'image/png'}], textures: [{source: 0}],"),
    CASE("picture of nowhere", "image 0: bufferView: 8, but there are 1 bufferViews",
         .more = "images: [{bufferView: 8}],"),
    CASE("texture without picture", "note: textures without a picture are left out: texture 0",
         .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
         .more = "textures: [{}],"),

    CASE("node that is a number", "node 0: 7 is not an object", .nodes = "[7]"),
    CASE("material that is a number", "material 0: pbrMetallicRoughness: 7 is not an object",
         .materials = "[{pbrMetallicRoughness: 7}]"),
    CASE("sides in words", "material 0: doubleSided: \"both\" is neither true nor false",
         .materials = "[{doubleSided: both}]"),
    CASE("alpha mode of the number 7",
         "note: words that do not exist are left out: material 0: alphaMode",
         .materials = "[{alphaMode: 7}]"),
    CASE("long word", "note: words that do not exist are left out: material 0: alphaMode",
         .materials = "[{alphaMode: OPAQUEOPAQUEOPAQUEOPAQUEOPAQUEOPAQUEOPAQUEOPAQUE}]"),
    CASE("picture of a number", "image 0: uri: 7 is not a string", .more = "images: [{uri: 7}],"),
    CASE("set of coordinates without end",
         "texCoord: 4294967296 is not a whole number from 0 to 2^31 - 1",
         .materials = "[{normalTexture: {index: 0, texCoord: 4294967296}}]",
         .more = "images: [{uri: 'a.png'}], textures: [{source: 0}],"),
    CASE("weights in words", "mesh 0 'quad': weights: not an array of numbers",
         .meshes = "[{name: quad, weights: [one], primitives: [{attributes: {POSITION: 0}, "
                   "indices: 1}]}]"),
    CASE("another drive", "buffer 0: cannot open build",
         .buffers = "[{byteLength: 320, uri: 'C:secret.bin'}]"),
    CASE("folder above at the end", ": not a file", .buffers = "[{byteLength: 320, uri: 'x/..'}]"),
    CASE("bell in a name", "buffer 0: '../../a??.bin' leads out of the folder ",
         .buffers = "[{byteLength: 320, uri: \"../../a\\u0007\\u007f.bin\"}]"),
    CASE("at infinity", "the node 'one' lies at infinity in the world",
         .nodes =
             "[{scale: [1e30, 1, 1], children: [1]}, {name: one, mesh: 0, scale: [1e30, 1, 1]}]"),
    CASE("times in halves",
         "note: channels of clips that are not valid are left out: animation 0: channel 0: input: "
         "accessor 1 does not hold floats",
         .more = ANIMATION("node: 0, path: translation", "1", "0")),
    CASE("times in space",
         "note: channels of clips that are not valid are left out: animation 0: channel 0: input: "
         "accessor 0 has 3 numbers an element, not 1",
         .more = ANIMATION("node: 0, path: translation", "0", "0")),
    CASE("matrix that moves",
         "note: channels of clips that are not valid are left out: animation 0: channel 0: the "
         "node 'one' has a matrix, which cannot be animated",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"),
         .more = ANIMATION("node: 0, path: scale", "0", "0")),
    CASE("weights for nothing",
         "note: weights without a morph target are ignored, and 0 where they lack: node 0 'one': 2 "
         "weights for 0 morph targets",
         .nodes = NODE("weights: [0, 1]")),
    CASE("weights of a mesh for nothing",
         "note: weights without a morph target are ignored, and 0 where they lack: mesh 0 'quad': "
         "1 weights for 0 morph targets",
         .meshes =
             "[{name: quad, weights: [1], primitives: [{attributes: {POSITION: 0}, indices: 1}]}]"),
    CASE("joints in fractions",
         "primitive 0: JOINTS_0: accessor 2 does not hold unsigned numbers of 8 or 16 bits",
         .accessors = FOUR("5126"), .meshes = PRIMITIVE(JOINTS("2", "2"))),
    CASE("joints without weights", "primitive 0: JOINTS_0 and WEIGHTS_0 go together",
         .accessors = FOUR("5121"),
         .meshes = PRIMITIVE("attributes: {POSITION: 0, JOINTS_0: 2}, indices: 1")),
    CASE("weights of one dimension",
         "primitive 0: WEIGHTS_0: accessor 1 has 1 numbers an element, not 4",
         .accessors = FOUR("5121"), .meshes = PRIMITIVE(JOINTS("2", "1"))),
    CASE("weights below none",
         "primitive 0: WEIGHTS_0: a weight of vertex 0 is negative or not finite",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {bufferView: 0, componentType: 5121, count: 4, type: VEC4}, {bufferView: "
                      "0, byteOffset: 64, componentType: 5126, count: 4, type: VEC4}]",
         .meshes = PRIMITIVE(JOINTS("2", "3")), EXTRA(negative_weights)),
    CASE("joint of another scene", "node 'one': joint 0 of its skin is not in the scene",
         .nodes = "[{name: one, mesh: 0, skin: 0}, {}]",
         .more = "skins: [{joints: [1]}], scenes: [{nodes: [0]}],"),
    CASE("fewer joints than it follows",
         "node 'one': primitive 0 of its mesh follows joint 1, but its skin has 1",
         .accessors = FOUR("5121"), .meshes = PRIMITIVE(JOINTS("2", "3")), .nodes = NODE("skin: 0"),
         .more = "skins: [{joints: [0]}],", EXTRA(second_joint)),
    CASE("matrices of a skin, too few", "skin 0 'bones': inverseBindMatrices: 1 for 2 joints",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {bufferView: 0, componentType: 5126, count: 1, type: MAT4}]",
         .more = "skins: [{name: bones, joints: [0, 0], inverseBindMatrices: 2}],"),
    CASE("matrices of a skin that are vectors",
         "skin 0: inverseBindMatrices: accessor 0 has 3 numbers an element, not 16",
         .more = "skins: [{joints: [0], inverseBindMatrices: 0}],"),
    CASE("targets of one primitive alone",
         "primitive 1: 0 morph targets, but the first primitive has 1",
         .meshes = "[{name: quad, primitives: [{attributes: {POSITION: 0}, indices: 1, targets: "
                   "[{POSITION: 0}]}, {attributes: {POSITION: 0}, indices: 1}]}]"),
    CASE("target not finite", "primitive 0: morph target 0: POSITION: a displacement is not finite",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {bufferView: 0, byteOffset: 64," VECTORS "}]",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: 1, targets: [{POSITION: 2}]"),
         EXTRA(nan_position)),
    CASE("target of indices",
         "primitive 0: morph target 0: NORMAL: accessor 1 has 1 numbers an element, not 3",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: 1, targets: [{NORMAL: 1}]")),
    CASE("targets that are none", "mesh 0 'quad': primitive 0: targets: 7 is not an array",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, targets: 7")),
    CASE("no such target", "mesh 0 'quad': primitive 0: targets: POSITION: 9, but there are 2",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, targets: [{POSITION: 9}]")),
    CASE("children that are none", "node 0 'one': children: 7 is not an array",
         .nodes = NODE("children: 7")),
    CASE("attributes that are none", "primitive 0: attributes: 7 is not an object",
         .meshes = PRIMITIVE("attributes: 7")),
    CASE("indices of three numbers",
         "primitive 0: indices: accessor 0 does not hold unsigned numbers",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: 0")),
    CASE("indices that are shares",
         "primitive 0: indices: accessor 1 does not hold unsigned numbers",
         .accessors = INDICES("bufferView: 0, normalized: true," INDEX_TYPE)),
    CASE("indices beyond their view",
         "primitive 0: indices: accessor 1: 6 elements of 2 bytes at 318 are outside",
         .accessors = INDICES("bufferView: 0, byteOffset: 318," INDEX_TYPE)),
    CASE("sparse index of indices",
         "primitive 0: indices: sparse index 16256 is outside its 6 elements",
         .accessors = INDICES("bufferView: 0, byteOffset: 48," INDEX_TYPE
                              ", sparse: {count: 1, indices: {bufferView: 0, byteOffset: 14, "
                              "componentType: 5123}, values: {bufferView: 0}}")),
    CASE("turn without direction",
         "note: a quaternion of length 0 turns nothing: instance 0: ROTATION",
         .accessors = FOUR("5126"),
         .nodes = NODE("extensions: {EXT_mesh_gpu_instancing: {attributes: {ROTATION: 2}}}")),
    CASE("size without a side", "light 0: extras: size: these are no two lengths",
         .more = "extensions: {KHR_lights_punctual: {lights: [{type: spot, spot: {}, extras: "
                 "{size: [1, 0]}}]}},"),
    CASE("size in words", "light 0: extras: size: these are no two lengths",
         .more = "extensions: {KHR_lights_punctual: {lights: [{type: spot, spot: {}, extras: "
                 "{size: [1, wide]}}]}},"),
    CASE("slower than light", "material 0: KHR_materials_ior: ior: 0.5 is neither 0 nor from 1 on",
         .materials = "[{extensions: {KHR_materials_ior: {ior: 0.5}}}]"),
    CASE("shine below none",
         "material 0: KHR_materials_specular: specularColorFactor: -1 is negative",
         .materials =
             "[{extensions: {KHR_materials_specular: {specularColorFactor: [1, -1, 1]}}}]"),
    CASE("more shine than there is",
         "note: numbers that are not from 0 to 1 are clamped: material 0: specularFactor",
         .materials = "[{extensions: {KHR_materials_specular: {specularFactor: 2}}}]"),
    CASE("metaballs that are none", "node 0 'one': extras: these are no metaballs",
         .nodes = NODE("extras: {metaballs: " BALLS("-1", "1", "10", "[-4, -4, -4]") "}")),
    CASE("metaballs without end", "node 0 'one': extras: these are no metaballs",
         .nodes = NODE("extras: {metaballs: " BALLS("3", "1e-9", "10", "[-4, -4, -4]") "}")),
    CASE("metaballs without a period", "node 0 'one': extras: these are no metaballs",
         .nodes = NODE("extras: {metaballs: " BALLS("3", "1", "0", "[-4, -4, -4]") "}")),
    CASE("metaballs in words", "node 0 'one': extras: these are no metaballs",
         .nodes = NODE("extras: {metaballs: " BALLS("3", "\"one\"", "10", "[-4, -4, -4]") "}")),
    CASE("metaballs in two dimensions", "node 0 'one': extras: these are no metaballs",
         .nodes = NODE("extras: {metaballs: " BALLS("3", "1", "10", "[-4, -4]") "}")),
    {"metaballs without room",
     "node 0 'one': extras: these are no metaballs",
     {.nodes = NODE("extras: {metaballs: " BALLS("3", "1", "10", "[3.9, -4, -4]") "}")}},
};

#endif
