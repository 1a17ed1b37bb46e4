/* Tiny glTF files that other readers open, with a note or without, and the note that is due here */
#ifndef TEST_MENDED_PARTS_H
#define TEST_MENDED_PARTS_H

#include "hostile_numbers.h"

/* The quad's two accessors, with counts and types as written. */
#define COUNTS(vertices, indices)                                                                  \
    "[{bufferView: 0, componentType: 5126, count: " vertices                                       \
    ", type: VEC3}, {bufferView: 0, byteOffset: 48, componentType: 5123, count: " indices          \
    ", type: SCALAR}]"
#define TWO_VIEWS(first, second)                                                                   \
    "[{buffer: 0, byteLength: 48" first "}, {buffer: 0, byteOffset: 48, byteLength: 272" second "}]"
#define IN_TWO_VIEWS "[{bufferView: 0," VECTORS "}, {bufferView: 1," INDEX_TYPE "}]"
#define MATERIAL(fields) "[{pbrMetallicRoughness: {" fields "}}]"
#define SECOND(primitive)                                                                          \
    "[{name: quad, primitives: [{attributes: {POSITION: 0}, indices: 1}, " primitive "]}]"
#define MATRIX_OF(m41, m44) NODE("matrix: [1,0,0," m41 ", 0,1,0,0, 0,0,1,0, 0,0,0," m44 "]")
#define CAMERA(type, fields) "cameras: [{name: eye, type: " type ", " type ": {" fields "}}],"
#define FLAT "xmag: 1, ymag: 1"
#define ZNEAR "a camera's znear that is missing or no distance is taken as 0: "
#define ZFAR "a camera's zfar that is missing or not beyond its znear is ignored: "
#define CONE "angles of a spot that make no cone are clamped: "
#define LIT(extension) NODE("mesh: 0, extensions: {'" extension "': {light: 0}}")
#define FRACTIONS "numbers written as fractions are taken as whole: "
#define SHARES "numbers that are not from 0 to 1 are clamped: material 0: "
#define LAST_ROW "a last row of a matrix that is almost 0 0 0 1 is that: node 0 'one': matrix"
#define LEFT_OUT                                                                                   \
    "primitives without positions or triangles are left out: mesh 0 'quad': primitive 1: "

static const float small_weights[16] = {-1e-7F, 1, 0, 0, -1e-6F, 1};

struct mended {
    const char *name, *note; /* "" = none is due */
    struct gltf_parts parts;
};

static const struct mended mended[] = {
    CASE("count 4.0", FRACTIONS "accessor 0: count (and 1 more)",
         .accessors = COUNTS("4.0", "6.0")),
    CASE("count 4e0", FRACTIONS "accessor 0: count", .accessors = COUNTS("4e0", "6")),
    CASE("count .4e1", FRACTIONS "accessor 0: count", .accessors = COUNTS("0.4e1", "6")),
    CASE("length 320.0", FRACTIONS "buffer 0: byteLength", .buffers = "[{byteLength: 320.0}]"),
    CASE("index 0.0", FRACTIONS "node 0 'one': mesh", .nodes = "[{name: one, mesh: 0.0}]"),
    CASE("attributes 0.0", FRACTIONS "mesh 0 'quad': primitive 0: attributes",
         .meshes = PRIMITIVE("attributes: {POSITION: 0.0}, indices: 1")),
    CASE("mode 4.0", FRACTIONS "mesh 0 'quad': primitive 0: mode",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: 1, mode: 4.0")),
    CASE("scene 0.0", FRACTIONS "scene", .more = "scenes: [{nodes: [0.0]}], scene: 0.0,"),
    CASE("mesh -0", "", .nodes = "[{name: one, mesh: -0}]"),
    CASE("rough by rounding", SHARES "roughnessFactor",
         .materials = MATERIAL("roughnessFactor: 1.0000001")),
    CASE("metal by rounding", SHARES "metallicFactor",
         .materials = MATERIAL("metallicFactor: -1e-9")),
    CASE("negative zeros", "",
         .materials = MATERIAL("metallicFactor: -0.0, baseColorFactor: [-0.0, 1, 1, 1]")),
    CASE("base colour by rounding", SHARES "baseColorFactor",
         .materials = MATERIAL("baseColorFactor: [1.0000002, 1, 1, 1]")),
    CASE("emission of four",
         "colours of other than 3 or 4 numbers are cut or made opaque: material 0: emissiveFactor",
         .materials = "[{emissiveFactor: [0, 0, 0, 1]}]"),
    CASE("emission by rounding", "numbers just below 0 are taken as 0: material 0: emissiveFactor",
         .materials = "[{emissiveFactor: [0, -1e-8, 0]}]"),
    CASE("light by rounding", "numbers just below 0 are taken as 0: light 0: intensity",
         .more = LIGHT("type: point, intensity: -1e-8")),
    CASE("glass by rounding", "numbers that are off by rounding are clamped: material 0: ior",
         .materials = "[{extensions: {KHR_materials_ior: {ior: 0.9999999}}}]"),
    CASE("spot of four decimals",
         "numbers that are off by rounding are clamped: light 0: outerConeAngle",
         .more = SPOT("outerConeAngle: 1.5708", "")),
    CASE("spot without an object", "an object that is not there has its defaults: light 0: spot",
         .more = LIGHT("type: spot")),
    CASE("cone from below none", CONE "light 0: innerConeAngle",
         .more = SPOT("innerConeAngle: -1", "")),
    CASE("cone of none", "numbers that are off by rounding are clamped: light 0: outerConeAngle",
         .more = SPOT("outerConeAngle: 0", "")),
    CASE("cone beyond the half", CONE "light 0: outerConeAngle",
         .more = SPOT("outerConeAngle: 2", "")),
    CASE("cone inside out", CONE "light 0: innerConeAngle",
         .more = SPOT("innerConeAngle: 0.5, outerConeAngle: 0.25", "")),
    CASE("light type", "lights of an unknown type are left out: light 0",
         .more = LIGHT("type: area"), .nodes = LIT("KHR_lights_punctual")),
    CASE("light type of no node", "lights of an unknown type are left out: light 0",
         .more = LIGHT("type: laser")),
    CASE("area light type", "lights of an unknown type are left out: light 0",
         .more = AREA("type: sphere"), .nodes = LIT("EXT_lights_area")),
    CASE("negative light", "lights of less than no light are left out: light 0",
         .more = LIGHT("type: directional, intensity: -1"), .nodes = LIT("KHR_lights_punctual")),
    CASE("negative area light", "lights of less than no light are left out: light 0",
         .more = AREA("type: disk, intensity: -5"), .nodes = LIT("EXT_lights_area")),
    CASE("negative channel", "channels of a light below 0 are taken as 0: light 0: color",
         .more = LIGHT("type: point, color: [1, -0.5, 1]")),
    CASE("sides as numbers", "0 and 1 are taken as false and true: material 0: doubleSided",
         .materials = "[{doubleSided: 1}]"),
    CASE("wrap of another OpenGL", "words that do not exist are left out: sampler 0: wrapS",
         .more = "samplers: [{wrapS: 10496, magFilter: 9729}],"),
    CASE("null for nothing", "fields that are null are left out: node 0 'one': camera (and 1 more)",
         .nodes = NODE("camera: null, skin: null, extras: null")),
    CASE("version 2", "a version that is not \"2.0\" is taken for that: asset: 2",
         .asset = "{version: '2'}"),
    CASE("version as a number", "a version that is not \"2.0\" is taken for that: asset: 2.0",
         .asset = "{version: 2.0}"),

    CASE("camera that ends before it begins", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("perspective", "yfov: 1, znear: 5, zfar: 2")),
    CASE("camera that ends where it begins", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("perspective", "yfov: 1, znear: 5, zfar: 5")),
    CASE("camera that ends at 0", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("perspective", "yfov: 1, znear: 5, zfar: 0")),
    CASE("camera that ends behind itself", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("perspective", "yfov: 1, znear: 5, zfar: -9")),
    CASE("camera that begins at 0", ZNEAR "camera 0 'eye': znear",
         .more = CAMERA("perspective", "yfov: 1, znear: 0, zfar: 9")),
    CASE("camera that begins behind itself", ZNEAR "camera 0 'eye': znear",
         .more = CAMERA("perspective", "yfov: 1, znear: -1")),
    CASE("camera without znear", ZNEAR "camera 0 'eye': znear",
         .more = CAMERA("perspective", "yfov: 1")),
    CASE("camera that begins too far away", ZNEAR "camera 0 'eye': znear",
         .more = CAMERA("perspective", "yfov: 1, znear: 1e300")),
    CASE("orthographic, ends before it begins", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("orthographic", FLAT ", znear: 5, zfar: 2")),
    CASE("orthographic, begins and ends at 0", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("orthographic", FLAT ", znear: 0, zfar: 0")),
    CASE("orthographic without zfar", ZFAR "camera 0 'eye': zfar",
         .more = CAMERA("orthographic", FLAT ", znear: 0")),
    CASE("orthographic, begins behind itself", ZNEAR "camera 0 'eye': znear",
         .more = CAMERA("orthographic", FLAT ", znear: -9, zfar: 9")),

    CASE("stride 0 of both", "byteStride 0 is read as packed: buffer view 0 (and 1 more)",
         .views = TWO_VIEWS(", byteStride: 0", ", byteStride: 0"), .accessors = IN_TWO_VIEWS),
    CASE("stride of indices", "a byteStride of indices is ignored: accessor 1",
         .views = TWO_VIEWS("", ", byteStride: 4"), .accessors = IN_TWO_VIEWS),
    CASE("stride of indices that are so wide",
         "a byteStride that is no multiple of 4 from 4 to 252 is taken as it is: buffer view 1: 2",
         .views = TWO_VIEWS("", ", byteStride: 2"), .accessors = IN_TWO_VIEWS),
    CASE("a byte more than it says",
         "buffer views beyond byteLength, where there are bytes, are read: buffer view 0",
         .buffers = "[{byteLength: 100}]"),
    CASE("BIN of more bytes", "", .buffers = "[{byteLength: 64}]",
         .views = "[{buffer: 0, byteLength: 64}]"),
    CASE("missing buffer that no view needs",
         "buffers that no view needs are not read: buffer 1: cannot open",
         .buffers = "[{byteLength: 320}, {byteLength: 9, uri: 'none.bin'}]"),
    CASE("buffer of nothing", "", .buffers = "[{byteLength: 320}, {byteLength: 9}]"),

    CASE("row by rounding", LAST_ROW, .nodes = MATRIX_OF("0", "0.99999994")),
    CASE("row by a bit", LAST_ROW, .nodes = MATRIX_OF("1e-9", "1")),
    CASE("row by less than 1e-5", LAST_ROW, .nodes = MATRIX_OF("-9e-6", "1.000009")),
    CASE("turn of 0", "a quaternion of length 0 turns nothing: node 0 'one': rotation",
         .nodes = NODE("rotation: [0, 0.0, -0, 0]")),

    CASE("seven indices",
         "indices that make no whole triangle are ignored: mesh 0 'quad': primitive 0",
         .accessors = COUNTS("4", "7")),
    CASE("eight indices",
         "indices that make no whole triangle are ignored: mesh 0 'quad': primitive 0",
         .accessors = COUNTS("4", "8")),
    CASE("no positions", LEFT_OUT "it has no POSITION",
         .meshes = SECOND("{attributes: {_HEAT: 0}}")),
    CASE("no attributes", LEFT_OUT "it has no POSITION", .meshes = SECOND("{attributes: {}}")),
    CASE("a strip of two", LEFT_OUT "it has no triangle",
         .accessors =
             "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
             "}, {bufferView: 0, byteOffset: 48, componentType: 5123, count: 2, type: SCALAR}]",
         .meshes = SECOND("{attributes: {POSITION: 0}, indices: 2, mode: 5}")),
    CASE("no indices at all", LEFT_OUT "it has no triangle",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {componentType: 5123, count: 0, type: SCALAR}]",
         .meshes = SECOND("{attributes: {POSITION: 0}, indices: 2}")),
    CASE("lines and points beside", "shown without: points and lines",
         .meshes =
             SECOND("{attributes: {POSITION: 0}, mode: 0}, {attributes: {POSITION: 0}, mode: 3}")),
    CASE("weights of joints by rounding",
         "numbers just below 0 are taken as 0: mesh 0 'quad': primitive 0: WEIGHTS_0",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {componentType: 5121, count: 4, type: VEC4}, {bufferView: 0, byteOffset: "
                      "64, componentType: 5126, count: 4, type: VEC4}]",
         .meshes = PRIMITIVE(JOINTS("2", "3")), EXTRA(small_weights)),
    CASE("weights of a morph that is not there",
         "weights without a morph target are ignored, and 0 where they lack: mesh 0 'quad'",
         .meshes = "[{name: quad, weights: [1, 2], primitives: [{attributes: {POSITION: 0}, "
                   "indices: 1, targets: [{POSITION: 0}]}]}]"),

    CASE("picture without a source", "colours by a magenta checker: image 0: its name is empty",
         .materials = TEXTURED, .more = "images: [{}], textures: [{source: 0}],"),
    CASE("picture from a server",
         "image 0: 'https://example.org/a.png' is a URL, which is not fetched",
         .materials = TEXTURED, .more = PICTURE("https://example.org/a.png")),
    CASE("picture without base64",
         "image 0: its data URI has the byte 0x21 at 0, which is no digit of base64",
         .materials = TEXTURED, .more = PICTURE("data:image/png;base64,!")),
    CASE("texture without a source", "textures without a picture are left out: texture 0",
         .materials = TEXTURED, .more = "textures: [{}],"),
    CASE("KTX2 that is not required", "colours by a magenta checker: image 0: KTX2 is not read",
         .materials = TEXTURED, .more = IN_FORMAT_OF("KHR_texture_basisu", KTX2, "")),
    CASE("KTX2 as it is", "colours by a magenta checker: image 0: KTX2 is not read",
         .materials = TEXTURED, .more = REQUIRED("KHR_texture_basisu") PICTURE(KTX2)),
    CASE("AVIF that is not required",
         "colours by a magenta checker: image 0: not a picture of a known format",
         .materials = TEXTURED, .more = IN_FORMAT_OF("EXT_texture_avif", "data:;base64,AAAA", "")),
    {"missing picture that nobody uses", "", {.more = PICTURE("none.png")}},
};

/* Files that glTF-Validator finds valid, or warns of, and that hold a triangle. */
static const struct mended valid[] = {
    CASE("camera without end", "", .more = CAMERA("perspective", "yfov: 1, znear: 0.1")),
    CASE("camera that ends far away", "",
         .more = CAMERA("perspective", "yfov: 1, znear: 0.1, zfar: 1e300")),
    CASE("orthographic, begins at 0", "",
         .more = CAMERA("orthographic", FLAT ", znear: 0, zfar: 9")),
    CASE("nothing else", "", 0),
    CASE("KTX2 beside a PNG", "", .materials = TEXTURED,
         .more = REQUIRED("KHR_texture_basisu")
             IN_FORMAT_OF("KHR_texture_basisu", KTX2, "source: 1, ")),
    CASE("required KTX2 that nobody uses", "",
         .more = REQUIRED("KHR_texture_basisu") IN_FORMAT_OF("KHR_texture_basisu", KTX2, "")),
    CASE("unused objects", "",
         .more =
             "images: [{uri: 'none.png'}], textures: [{source: 0}], samplers: [{}], cameras: "
             "[{type: perspective, perspective: {yfov: 1, znear: 1}}], skins: [{joints: [0]}],"),
    CASE("other properties", "", .nodes = NODE("customProperty: [1, {a: null}], extras: text"),
         .more = "somethingElse: true, extras: [1.5],"),
    CASE("extensions not declared", "", .more = "extensions: {ANYBODY_thing: {a: 1}},"),
    CASE("extension used and unknown", "shown without: ANYBODY_thing",
         .more = "extensionsUsed: [ANYBODY_thing],"),
    CASE("bounds that do not match", "",
         .accessors = "[{bufferView: 0, min: [7, 8, 9], max: [0, x]," VECTORS
                      "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE "}]"),
    CASE("names alike", "", .nodes = "[{name: a, mesh: 0}, {name: a}, {name: a}]"),
    CASE("name with a bell", "", .nodes = "[{name: \"a\\u0007\\n\\u0000\", mesh: 0}]"),
    CASE("empty nodes", "", .nodes = "[{mesh: 0}, {}, {children: [1]}]"),
    CASE("empty lists", "", .more = "animations: [], cameras: [], textures: [],"),
    CASE("a strip", "", .meshes = PRIMITIVE("attributes: {POSITION: 0}, mode: 5")),
    CASE("a fan", "", .meshes = PRIMITIVE("attributes: {POSITION: 0}, mode: 6")),
    CASE("a line strip beside", "shown without: points and lines",
         .meshes = SECOND("{attributes: {POSITION: 0}, indices: 1, mode: 1}")),
    CASE("indices of zeros", "", .accessors = INDICES(INDEX_TYPE)),
    CASE("sparse indices over zeros", "",
         .accessors =
             INDICES(INDEX_TYPE ", sparse: {count: 2, indices: {bufferView: 0, byteOffset: 50, "
                                "componentType: 5123}, values: {bufferView: 0, byteOffset: 50}}")),
    CASE("sparse positions over zeros", "",
         .accessors =
             POSITIONS(VECTORS ", sparse: {count: 2, indices: {bufferView: 0, byteOffset: 50, "
                               "componentType: 5123}, values: {bufferView: 0, byteOffset: 12}}")),
    CASE("texture without a source", "textures without a picture are left out: texture 0",
         .materials = TEXTURED, .more = "textures: [{sampler: 0}], samplers: [{}],"),
    CASE("a clip without channels", "", .more = "animations: [{channels: [], samplers: []}],"),
    CASE("a clip of nothing",
         "channels of clips that are not valid are left out: animation 0: it has no channels",
         .more = "animations: [{}],"),
    CASE("a skin without a skeleton", "", .nodes = "[{mesh: 0, skin: 0}]",
         .more = "skins: [{joints: [0]}],"),
    CASE("an unlit material", "", .materials = "[{extensions: {KHR_materials_unlit: {a: 1}}}]",
         .more = "extensionsUsed: [KHR_materials_unlit],"),
    CASE("a newer minor version", "", .asset = "{version: '2.1', minVersion: '2.0'}"),
    CASE("a target of zeros", "",
         .accessors = "[{bufferView: 0," VECTORS "}, {bufferView: 0, byteOffset: 48," INDEX_TYPE
                      "}, {" VECTORS "}]",
         .meshes = PRIMITIVE("attributes: {POSITION: 0}, indices: 1, targets: [{POSITION: 2}]")),
    CASE("a tangent and a colour of its own", "",
         .meshes = PRIMITIVE("attributes: {POSITION: 0, _OWN: 0}, indices: 1, extras: {}")),
    {"no scene", "", {.more = "scenes: [{nodes: [0]}, {name: empty}],"}},
};

#endif
