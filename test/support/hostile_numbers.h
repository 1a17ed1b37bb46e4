/* Tiny glTF files of which one number or name is wrong, and what each is refused with. */
#ifndef TEST_HOSTILE_NUMBERS_H
#define TEST_HOSTILE_NUMBERS_H

#include "hostile_parts.h"

#define LIGHT(fields) "extensions: {KHR_lights_punctual: {lights: [{" fields "}]}},"
#define SPOT(cone, fields) LIGHT("type: spot, spot: {" cone "}" fields)
#define AREA(fields) "extensions: {EXT_lights_area: {lights: [{" fields "}]}},"
#define PICTURE(uri) "images: [{uri: '" uri "'}], textures: [{source: 0}],"
#define TEXTURED "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]"
#define BALLS_OF(fields) NODE("extras: {metaballs: {" fields "}}")

#define REQUIRED(extension) "extensionsRequired: ['" extension "'],"
#define KTX2 "data:image/ktx2;base64,q0tUWCAyMLsNChoK"
#define GREEN                                                                                      \
    "data:image/"                                                                                  \
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNg+"                     \
    "M8AAAICAQB7CYF4AAAAAElFTkSuQmCC"
/* A texture whose picture has that format; more: a source besides, image 1 is a PNG. */
#define IN_FORMAT_OF(extension, uri, more)                                                         \
    "images: [{uri: '" uri "'}, {uri: '" GREEN "'}], textures: [{" more "extensions: {'" extension \
    "': {source: 0}}}],"

static const struct hostile hostile_numbers[] = {
    CASE(
        "required KTX2",
        "image 0: the required extension 'KHR_texture_basisu': KTX2 is not read; convert it to PNG",
        .materials = TEXTURED,
        .more = REQUIRED("KHR_texture_basisu") IN_FORMAT_OF("KHR_texture_basisu", KTX2, "")),
    CASE("required DDS",
         "image 0: the required extension 'MSFT_texture_dds': not a picture of a known format",
         .materials = TEXTURED,
         .more = REQUIRED("MSFT_texture_dds")
             IN_FORMAT_OF("MSFT_texture_dds", "data:;base64,RERTIA==", "")),
    CASE("required KTX2 that is none of the images",
         "texture 0: extensions: KHR_texture_basisu: source: 7, but there are 1 images",
         .materials = TEXTURED,
         .more = REQUIRED("KHR_texture_basisu") "images: [{uri: a}], textures: [{extensions: "
                                                "{KHR_texture_basisu: {source: 7}}}],"),
    CASE("size that is no list", "extras: size: these are no two lengths",
         .more = SPOT("", ", extras: {size: 3}")),
    CASE("size of worlds", "extras: size: these are no two lengths",
         .more = SPOT("", ", extras: {size: [2e9, 1]}")),
    CASE("radius of worlds", "extras: radius: it is no number from 0",
         .more = SPOT("", ", extras: {radius: 1e9}")),
    CASE("colour too large", "light 0: color: 1e+300 is too large",
         .more = LIGHT("type: point, color: [1e300, 1, 1]")),
    CASE("light too large", "light 0: intensity: it is negative or above 1e+12",
         .more = LIGHT("type: point, intensity: 1e38")),
    CASE("area light too large", "area light 0: intensity: it is negative or above 1e+12",
         .more = AREA("type: disk, intensity: 1.1e12")),
    CASE("disk of none", "area light 0: size: 0 by 0 m", .more = AREA("type: disk, size: 0")),
    CASE("disk of worlds", "area light 0: size: 1e+10 by 1e+10 m",
         .more = AREA("type: disk, size: 1e10")),
    CASE("aspect of none", "area light 0: size: 0 by 1 m",
         .more = AREA("type: rect, rect: {aspect: 0}")),
    CASE("aspect of worlds", "area light 0: size: 1e+12 by 1 m",
         .more = AREA("type: rect, rect: {aspect: 1e12}")),
    CASE("field of none", "camera 0: yfov: 0 radians",
         .more = "cameras: [{type: perspective, perspective: {yfov: 0, znear: 1}}],"),
    CASE("picture of none", "camera 0: ymag: 0 m",
         .more = "cameras: [{type: orthographic, orthographic: {xmag: 1, ymag: 0, zfar: 2, znear: "
                 "1}}],"),
    CASE("picture of worlds", "camera 0: ymag: inf m",
         .more = "cameras: [{type: orthographic, orthographic: {xmag: 1, ymag: 1e39, zfar: 2, "
                 "znear: 1}}],"),

    CASE("translation too large", "node 0 'one': translation: 1e+300 is too large",
         .nodes = NODE("translation: [1e300, 0, 0]")),
    CASE("rotation too large", "node 0 'one': rotation: 1e+300 is too large",
         .nodes = NODE("rotation: [1e300, 0, 0, 1]")),
    CASE("scale too large", "node 0 'one': scale: 1e+300 is too large",
         .nodes = NODE("scale: [1e300, 1, 1]")),
    CASE("last row, second", "its last row is not 0 0 0 1",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,1, 0,0,1,0, 0,0,0,1]")),
    CASE("last row, third", "its last row is not 0 0 0 1",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,0, 0,0,1,1, 0,0,0,1]")),
    CASE("last row, end", "its last row is not 0 0 0 1",
         .nodes = NODE("matrix: [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]")),
    CASE("weights without a mesh", "there is no triangle", .nodes = "[{weights: [1]}]"),
    CASE("metaballs without fields", "extras: these are no metaballs",
         .nodes = BALLS_OF("count: 3")),
    CASE("metaballs in words", "extras: these are no metaballs",
         .nodes =
             BALLS_OF("count: 3, reach: 1, cell: 1, period: 1, low: [0, 0, x], high: [4, 4, 4]")),
    CASE("metaballs without height", "extras: these are no metaballs",
         .nodes = BALLS_OF("count: 3, reach: 1, cell: 1, period: 1, low: [0, 0, 0], high: 4")),
    CASE("metaballs for ever", "extras: these are no metaballs",
         .nodes = BALLS_OF(
             "count: 3, reach: 1, cell: 1, period: 1e300, low: [0, 0, 0], high: [4, 4, 4]")),
    CASE("metaballs without cells", "extras: these are no metaballs",
         .nodes =
             BALLS_OF("count: 3, reach: 1, cell: 0, period: 1, low: [0, 0, 0], high: [4, 4, 4]")),

    CASE("cutoff too large", "material 0: alphaCutoff: 1e+300 is too large",
         .materials = "[{alphaMode: MASK, alphaCutoff: 1e300}]"),
    CASE("base colour too large",
         "note: numbers that are not from 0 to 1 are clamped: material 0: baseColorFactor",
         .materials = "[{pbrMetallicRoughness: {baseColorFactor: [1e300, 1, 1, 1]}}]"),
    CASE("less than metal",
         "note: numbers that are not from 0 to 1 are clamped: material 0: metallicFactor",
         .materials = "[{pbrMetallicRoughness: {metallicFactor: -1}}]"),
    CASE("rougher than rough",
         "note: numbers that are not from 0 to 1 are clamped: material 0: roughnessFactor",
         .materials = "[{pbrMetallicRoughness: {roughnessFactor: 2}}]"),
    CASE("scale of normals", "material 0: normalTexture: scale: 1e+300 is too large",
         .materials = "[{normalTexture: {index: 0, scale: 1e300}}]", .more = PICTURE("a.png")),
    CASE("WebP of nowhere", "note: textures without a picture are left out: texture 0",
         .materials = TEXTURED, .more = "textures: [{extensions: {EXT_texture_webp: {}}}],"),
    CASE("text for a picture", "note: image 0: secret-here.bin: not a picture of a known format",
         .materials = TEXTURED, .more = PICTURE("secret-here.bin")),
    CASE("picture without a name", "note: image 0: its name is empty", .materials = TEXTURED,
         .more = PICTURE("")),
    CASE("picture of another root", "note: image 0: '\\a' leads out of the folder ",
         .materials = TEXTURED, .more = PICTURE("\\\\a")),
    CASE("picture beside a dot", "note: image 0: cannot open build", .materials = TEXTURED,
         .more = PICTURE("./.a/b./none.png")),
    CASE("name that rings", "note: image 0: cannot open build", .materials = TEXTURED,
         .more = PICTURE("a\\u0007\\u001b[2J.png")),

    CASE("asset of an older reader", "it needs glTF version \"3.0\"; 2.0 is read",
         .asset = "{version: '2.0', minVersion: '3.0'}"),
    CASE("stride of none", "note: byteStride 0 is read as packed: buffer view 0",
         .views = "[{buffer: 0, byteLength: 320, byteStride: 0}]"),
    CASE("stride too wide",
         "primitive 0: POSITION: accessor 0: 4 elements of 12 bytes at 0 are outside buffer view 0",
         .views = "[{buffer: 0, byteLength: 320, byteStride: 256}]"),
    CASE("data without a comma", "buffer 0: its data URI has no comma",
         .buffers = "[{byteLength: 3, uri: 'data:text/plain'}]"),
    CASE("sparse of none", "accessor 0: sparse: 0 elements replace 4",
         .accessors = POSITIONS(VECTORS ", sparse: {count: 0, indices: {bufferView: 0, "
                                        "componentType: 5121}, values: {bufferView: 0}}")),
    CASE("sparse number of an index", "indices: sparse index 16256 is outside its 6 elements",
         .accessors = INDICES("bufferView: 0, byteOffset: 48," INDEX_TYPE
                              ", sparse: {count: 1, indices: {bufferView: 0, byteOffset: 14, "
                              "componentType: 5123}, values: {bufferView: 0}}")),
    CASE("matrices of bytes", "accessor 0: it holds matrices, and not of 4x4 floats",
         .accessors = POSITIONS("bufferView: 0, componentType: 5121, count: 4, type: MAT4")),
    CASE("offset beyond the view", "accessor 0: 4 elements of 12 bytes at 400 are outside",
         .accessors = POSITIONS("bufferView: 0, byteOffset: 400," VECTORS)),
    CASE("offset at its end", "accessor 0: 4 elements of 12 bytes at 316 are outside",
         .accessors = POSITIONS("bufferView: 0, byteOffset: 316," VECTORS)),
    CASE("indices without a number",
         "mesh 0 'quad': primitive 0: indices: true, but there are 2 accessors",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: true")),
    CASE("attributes in a list", "primitive 0: attributes: array is not an object",
         .meshes = PRIMITIVE("attributes: [0]")),
    CASE("children in an object", "node 0 'one': children: object is not an array",
         .nodes = NODE("children: {a: 0}")),
    CASE("targets in an object", "primitive 0: targets: object is not an array",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, targets: {}")),
    CASE("half a type", "componentType: 5126.5 is none of",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126.5, count: 4, type: VEC3")),
    CASE("two types", "type: \"VEC3 VEC4\" is none of",
         .accessors = POSITIONS("bufferView: 0, componentType: 5126, count: 4, type: 'VEC3 VEC4'")),
    {"no such sampler",
     "note: channels of clips that are not valid are left out: animation 0: channel 0: its sampler "
     "is 3, but there are 1",
     {.more = "animations: [{samplers: [{input: 0, output: 0}], channels: [{sampler: 3, target: "
              "{node: 0, path: scale}}]}],"}},
};

#endif
