/* Hostile glTF files: each ends in one message that names the object, never in a crash, a hang or a
 * read outside the file's folder. */
#define _XOPEN_SOURCE 700
#include "gltf_parts.h"

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "scene/open.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* An accessor list whose positions or indices are replaced. */
#define POSITIONS(fields) "[{" fields "}, {\"bufferView\": 0, \"byteOffset\": 48," INDEX_TYPE "}]"
#define INDICES(fields) "[{\"bufferView\": 0," VECTORS "}, {" fields "}]"
#define VECTORS "\"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\""
#define INDEX_TYPE "\"componentType\": 5123, \"count\": 6, \"type\": \"SCALAR\""
#define PRIMITIVE(fields) "[{\"name\": \"quad\", \"primitives\": [{" fields "}]}]"
#define NODE(fields) "[{\"name\": \"one\", \"mesh\": 0, " fields "}]"

static const float nan_position[12] = {0, 0, 0, 0, 0x1p127F * 2, 0, 1, 1, 1, 2, 2, 2};
static const uint16_t wild_index[6] = {0, 1, 2, 0, 2, 17};

static const struct {
    const char *name, *message; /* what comes after "FILE: " */
    struct gltf_parts parts;
} hostile[] = {
    {"no version", "asset: it has no 'version'", {.asset = "{}"}},
    {"old version", "glTF version '1.0', not 2.0", {.asset = "{\"version\": \"1.0\"}"}},
    {"future version",
     "it needs glTF version '2.1'",
     {.asset = "{\"version\": \"2.1\", \"minVersion\": \"2.1\"}"}},
    {"required extension",
     "it requires the extension 'KHR_unheard_of', which is not read",
     {.more = "\"extensionsRequired\": [\"KHR_unheard_of\"],"}},
    {"KTX2",
     "texture 0: its picture is in the format of KHR_texture_basisu, which is not read",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]",
      .more = "\"images\": [{\"uri\": \"lion.ktx2\"}], \"textures\": [{\"extensions\":"
              " {\"KHR_texture_basisu\": {\"source\": 0}}}],"}},

    {"buffer of another type", "buffers: 7 is not an array", {.buffers = "7"}},
    {"empty buffer", "buffer 0: byteLength is 0", {.buffers = "[{\"byteLength\": 0}]"}},
    {"buffer larger than BIN",
     "buffer 0: byteLength is 1000, but the BIN chunk has 320 bytes",
     {.buffers = "[{\"byteLength\": 1000}]"}},
    {"buffer without uri",
     "buffer 1: it has no uri, and there is no BIN chunk for it",
     {.buffers = "[{\"byteLength\": 320}, {\"byteLength\": 4}]"}},
    {"negative size",
     "buffer 0: byteLength: -4 is not a whole number from 0",
     {.buffers = "[{\"byteLength\": -4}]"}},
    {"missing buffer",
     "buffer 0: cannot open build",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"missing.bin\"}]"}},
    {"parent folder",
     "buffer 0: '../secret.bin' is not a path inside the file's folder",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"../secret.bin\"}]"}},
    {"encoded parent folder",
     "buffer 0: 'x/../../secret.bin' is not a path inside",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"x/%2E%2E/%2e./secret.bin\"}]"}},
    {"backslashes",
     "buffer 0: '..\\secret.bin' is not a path inside the file's folder",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"..\\\\secret.bin\"}]"}},
    {"absolute path",
     "buffer 0: '/etc/passwd' is not a path inside the file's folder",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"/etc/passwd\"}]"}},
    {"URL",
     "buffer 0: 'file:///etc/passwd' is not a path inside the file's folder",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"file:///etc/passwd\"}]"}},
    {"link out of the folder",
     "buffer 0: 'link.bin' is a link out of the file's folder",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"link.bin\"}]"}},
    {"folder as a buffer",
     "buffer 0: cannot read build",
     {.buffers = "[{\"byteLength\": 320, \"uri\": \"folder\"}]"}},
    {"data of another size",
     "buffer 0: byteLength is 320, but its data URI has 3 bytes",
     {.buffers =
          "[{\"byteLength\": 320, \"uri\": \"data:application/octet-stream;base64,AAAA\"}]"}},
    {"data not in base64",
     "buffer 0: its data URI is not in base64",
     {.buffers = "[{\"byteLength\": 3, \"uri\": \"data:text/plain,abc\"}]"}},
    {"data with wrong digits",
     "buffer 0: byteLength is 3, but its data URI has 0 bytes",
     {.buffers = "[{\"byteLength\": 3, \"uri\": \"data:application/octet-stream;base64,A*AA\"}]"}},

    {"view beyond its buffer",
     "buffer view 0: 321 bytes at 0 are outside buffer 0 of 320 bytes",
     {.views = "[{\"buffer\": 0, \"byteLength\": 321}]"}},
    {"view offset near 2^64",
     "buffer view 0: 320 bytes at 18446744073709551600 are outside",
     {.views = "[{\"buffer\": 0, \"byteOffset\": 18446744073709551600, \"byteLength\": 320}]"}},
    {"view offset beyond 2^64",
     "buffer view 0: byteOffset: 1.8446744073709552e+22 is not a whole",
     {.views = "[{\"buffer\": 0, \"byteOffset\": 18446744073709551616000, \"byteLength\": 320}]"}},
    {"view of no buffer",
     "buffer view 0: buffer: 1, but there are 1 buffers",
     {.views = "[{\"buffer\": 1, \"byteLength\": 320}]"}},
    {"view of buffer 2^32",
     "buffer view 0: buffer: 4294967296, but there are 1 buffers",
     {.views = "[{\"buffer\": 4294967296, \"byteLength\": 320}]"}},
    {"stride",
     "buffer view 0: byteStride: 6 is not a multiple of 4 from 4 to 252",
     {.views = "[{\"buffer\": 0, \"byteLength\": 320, \"byteStride\": 6}]"}},
    {"stride below the element",
     "mesh 0 'quad': primitive 0: POSITION: accessor 0: a stride of 4 for elements of 12 bytes",
     {.views = "[{\"buffer\": 0, \"byteLength\": 320, \"byteStride\": 4}]"}},

    {"accessor beyond its view",
     "mesh 0 'quad': primitive 0: POSITION: accessor 0: 27 elements of 12 bytes at 0 are outside"
     " buffer view 0 of 320 bytes",
     {.accessors = POSITIONS("\"bufferView\": 0, \"componentType\": 5126, \"count\": 27,"
                             " \"type\": \"VEC3\"")}},
    {"accessor offset near 2^64",
     "primitive 0: POSITION: accessor 0: 4 elements of 12 bytes at 1844",
     {.accessors = POSITIONS("\"bufferView\": 0, \"byteOffset\": 18446744073709551612," VECTORS)}},
    {"count near 2^64",
     "primitive 0: POSITION: accessor 0: 1844674407370955161 elements of 12 bytes",
     {.accessors = POSITIONS("\"bufferView\": 0, \"componentType\": 5126, \"count\":"
                             " 1844674407370955161, \"type\": \"VEC3\"")}},
    {"count without bytes",
     "primitive 0: POSITION: accessor 0: more than 128 million",
     {.accessors = POSITIONS("\"componentType\": 5126, \"count\": 1844674407370955161, \"type\":"
                             " \"VEC3\"")}},
    {"count 0",
     "mesh 0 'quad': primitive 0: POSITION: accessor 0: it has no elements",
     {.accessors = POSITIONS(
          "\"bufferView\": 0, \"componentType\": 5126, \"count\": 0, \"type\": \"VEC3\"")}},
    {"component type",
     "accessor 0: componentType: 5130 is none of 5120 5121",
     {.accessors = POSITIONS(
          "\"bufferView\": 0, \"componentType\": 5130, \"count\": 4, \"type\": \"VEC3\"")}},
    {"element type",
     "accessor 0: type: \"VEC5\" is none of SCALAR VEC2",
     {.accessors = POSITIONS(
          "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC5\"")}},
    {"positions in two dimensions",
     "primitive 0: POSITION: accessor 0 has 2 numbers an element, not 3",
     {.accessors = POSITIONS(
          "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC2\"")}},
    {"matrices",
     "primitive 0: POSITION: accessor 0: it holds matrices, and not",
     {.accessors = POSITIONS(
          "\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"MAT3\"")}},
    {"sparse index",
     "mesh 0 'quad': primitive 0: POSITION: sparse index 16256 is outside its 4 elements",
     {.accessors = POSITIONS(
          VECTORS ", \"sparse\": {\"count\": 1, \"indices\": {\"bufferView\": 0, \"byteOffset\":"
                  " 14, \"componentType\": 5123}, \"values\": {\"bufferView\": 0}}")}},
    {"sparse values",
     "accessor 0: sparse: 4 elements of 12 bytes at 300 are outside",
     {.accessors = POSITIONS(VECTORS ", \"sparse\": {\"count\": 4, \"indices\": {\"bufferView\": 0,"
                                     " \"componentType\": 5121}, \"values\": {\"bufferView\": 0,"
                                     " \"byteOffset\": 300}}")}},
    {"sparse count",
     "accessor 0: sparse: 5 elements replace 4",
     {.accessors = POSITIONS(
          VECTORS ", \"sparse\": {\"count\": 5, \"indices\": {\"bufferView\": 0, \"componentType\":"
                  " 5121}, \"values\": {\"bufferView\": 0}}")}},
    {"sparse without values",
     "accessor 0: sparse: it has no 'values'",
     {.accessors = POSITIONS(VECTORS ", \"sparse\": {\"count\": 1, \"indices\": {\"bufferView\": 0,"
                                     " \"componentType\": 5121}}")}},

    {"no such accessor",
     "mesh 0 'quad': primitive 0: attributes: POSITION: 9, but there are 2",
     {.meshes = PRIMITIVE("\"attributes\": {\"POSITION\": 9}")}},
    {"no position",
     "mesh 0 'quad': primitive 0: it has no POSITION",
     {.meshes = PRIMITIVE("\"attributes\": {\"NORMAL\": 0}")}},
    {"no attributes",
     "mesh 0 'quad': primitive 0: it has no 'attributes'",
     {.meshes = PRIMITIVE("\"indices\": 1")}},
    {"no such material",
     "mesh 0 'quad': primitive 0: material: 1, but there are 1 materials",
     {.meshes = PRIMITIVE("\"attributes\": {\"POSITION\": 0}, \"material\": 1")}},
    {"no such mode",
     "mesh 0 'quad': primitive 0: mode: 7 is none of 0 1 2 3 4 5 6",
     {.meshes = PRIMITIVE("\"attributes\": {\"POSITION\": 0}, \"mode\": 7")}},
    {"negative index",
     "mesh 0 'quad': primitive 0: indices: -1, but there are 2 accessors",
     {.meshes = PRIMITIVE("\"attributes\": {\"POSITION\": 0}, \"indices\": -1")}},
    {"half a triangle",
     "mesh 0 'quad': primitive 0: 4 indices make no whole triangles",
     {.meshes = PRIMITIVE("\"attributes\": {\"POSITION\": 0}")}},
    {"index out of range",
     "mesh 0 'quad': primitive 0: index 17 is outside its 4 vertices",
     {.accessors = INDICES("\"bufferView\": 0, \"byteOffset\": 64," INDEX_TYPE),
      .extra = wild_index,
      .extra_size = sizeof wild_index}},
    {"indices of floats",
     "primitive 0: indices: accessor 1 does not hold unsigned numbers",
     {.accessors = INDICES("\"bufferView\": 0, \"componentType\": 5126, \"count\": 6, \"type\":"
                           " \"SCALAR\"")}},
    {"indices without a view",
     "accessor[1] invalid bufferView",
     {.accessors = INDICES(INDEX_TYPE)}},
    {"position not finite",
     "primitive 0: the position of vertex 1 is not finite",
     {.accessors = POSITIONS("\"bufferView\": 0, \"byteOffset\": 64," VECTORS),
      .extra = nan_position,
      .extra_size = sizeof nan_position}},
    {"normals too few",
     "primitive 0: NORMAL: 3 elements, not 4",
     {.accessors = "[{\"bufferView\": 0," VECTORS
                   "}, {\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\":"
                   " \"VEC3\"}]",
      .meshes = PRIMITIVE("\"mode\": 5, \"attributes\": {\"POSITION\": 0, \"NORMAL\": 1}")}},
    {"no triangles", "there is no triangle", {.nodes = "[{}]"}},

    {"node matrix of 15",
     "node 0 'one': matrix: not an array of 16 numbers",
     {.nodes = NODE("\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]")}},
    {"matrix with words",
     "node 0 'one': matrix: not an array of 16 numbers",
     {.nodes = NODE("\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,\"NaN\"]")}},
    {"matrix too large",
     "node 0 'one': matrix: 1e+300 is too large",
     {.nodes = NODE("\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 1e300,0,0,1]")}},
    {"infinite scale",
     "number overflow parsing '1e999'",
     {.nodes = NODE("\"scale\": [1e999,1,1]")}},
    {"NaN", "syntax error while parsing value", {.nodes = NODE("\"scale\": [NaN,1,1]")}},
    {"matrix not affine",
     "node 0 'one': matrix: its last row is not 0 0 0 1",
     {.nodes = NODE("\"matrix\": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]")}},
    {"zero rotation",
     "node 0 'one': rotation: a quaternion of length 0",
     {.nodes = NODE("\"rotation\": [0,0,0,0]")}},
    {"far away",
     "mesh 0 'quad': a vertex lies 1e+30 m from the world's origin",
     {.nodes = NODE("\"translation\": [1e30,0,0]")}},
    {"its own child", "node 0 'one': it is its own ancestor", {.nodes = NODE("\"children\": [0]")}},
    {"loop",
     "node 1: it is its own ancestor",
     {.nodes = "[{\"mesh\": 0}, {\"children\": [2]}, {\"children\": [1]}]"}},
    {"two parents",
     "node 2 'c': it has two parents, nodes 0 and 1",
     {.nodes = "[{\"children\": [2]}, {\"children\": [2]}, {\"name\": \"c\", \"mesh\": 0}]"}},
    {"child twice",
     "node 1: it has two parents, nodes 0 and 0",
     {.nodes = "[{\"children\": [1, 1]}, {\"mesh\": 0}]"}},
    {"instances of two counts",
     "node 0 'one': instances: ROTATION: 6 elements, not 4",
     {.accessors =
          "[{\"bufferView\": 0," VECTORS "}, {\"bufferView\": 0, \"byteOffset\": 48," INDEX_TYPE
          "}, {\"bufferView\": 0, \"componentType\": 5126, \"count\": 6,"
          " \"type\": \"VEC4\"}]",
      .nodes = NODE("\"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\":"
                    " {\"TRANSLATION\": 0, \"ROTATION\": 2}}}")}},
    {"instances without number",
     "of memory are wanted",
     {.accessors =
          "[{\"bufferView\": 0," VECTORS "}, {\"bufferView\": 0, \"byteOffset\": 48," INDEX_TYPE
          "}, {\"componentType\": 5126, \"count\": 100000000,"
          " \"type\": \"VEC3\"}]",
      .nodes = NODE("\"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\":"
                    " {\"TRANSLATION\": 2}}}")}},
    {"no such place",
     "node 0 'one': extensions: EXT_mesh_gpu_instancing: attributes: SCALE: 9, but there are 2",
     {.nodes = NODE("\"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\":"
                    " {\"SCALE\": 9}}}")}},
    {"no such child",
     "node 0 'one': children: 5, but there are 1 nodes",
     {.nodes = NODE("\"children\": [5]")}},
    {"no such mesh", "node 0: mesh: 1, but there are 1 meshes", {.nodes = "[{\"mesh\": 1}]"}},
    {"no such camera",
     "node 0 'one': camera: 0, but there are 0 cameras",
     {.nodes = NODE("\"camera\": 0")}},
    {"no such light",
     "node 0 'one': extensions: KHR_lights_punctual: light: 0, but there are 0",
     {.nodes = NODE("\"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}")}},
    {"no such scene",
     "scene: 2, but there are 1 scenes",
     {.more = "\"scenes\": [{\"nodes\": [0]}], \"scene\": 2,"}},
    {"no such root",
     "scene 0: nodes: 1, but there are 1 nodes",
     {.more = "\"scenes\": [{\"nodes\": [1]}],"}},
    {"child as a root",
     "scene 0: node 1 has a parent or is listed twice",
     {.nodes = "[{\"children\": [1]}, {\"mesh\": 0}]", .more = "\"scenes\": [{\"nodes\": [1]}],"}},

    {"light type",
     "extensions: KHR_lights_punctual: light 0: type: \"laser\" is none of",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"laser\"}]}},"}},
    {"negative light",
     "light 0 'sun': intensity: it is negative or too large",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"name\": \"sun\","
              " \"type\": \"directional\", \"intensity\": -1}]}},"}},
    {"cone inside out",
     "light 0: a cone from 0.5 to 0.25 radians",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"spot\","
              " \"spot\": {\"innerConeAngle\": 0.5, \"outerConeAngle\": 0.25}}]}},"}},
    {"radius less than none",
     "light 0 'bulb': extras: radius: it is no number from 0 to 5e+08",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"name\": \"bulb\","
              " \"type\": \"point\", \"extras\": {\"radius\": -1}}]}},"}},
    {"radius in words",
     "light 0: extras: radius: it is no number from 0 to 5e+08",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"spot\","
              " \"spot\": {}, \"extras\": {\"radius\": \"wide\"}}]}},"}},
    {"size with one side",
     "light 0: extras: size: these are no two lengths",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"spot\","
              " \"spot\": {}, \"extras\": {\"size\": [1]}}]}},"}},
    {"sun all around",
     "light 0: extras: angle: it is no number from 0 to 3.14159",
     {.more = "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\":"
              " \"directional\", \"extras\": {\"angle\": 7}}]}},"}},
    {"area light type",
     "extensions: EXT_lights_area: area light 0: type: \"sphere\" is none of",
     {.more = "\"extensions\": {\"EXT_lights_area\": {\"lights\": [{\"type\": \"sphere\"}]}},"}},
    {"area light without area",
     "area light 0 'panel': size: 0 by 0 m",
     {.more = "\"extensions\": {\"EXT_lights_area\": {\"lights\": [{\"name\": \"panel\","
              " \"type\": \"rect\", \"size\": 0}]}},"}},
    {"negative area light",
     "area light 0: intensity: it is negative or too large",
     {.more = "\"extensions\": {\"EXT_lights_area\": {\"lights\": [{\"type\": \"disk\","
              " \"intensity\": -5}]}},"}},
    {"no such area light",
     "node 0 'one': extensions: EXT_lights_area: light: 0, but there are 0",
     {.nodes = NODE("\"extensions\": {\"EXT_lights_area\": {\"light\": 0}}")}},
    {"field of view",
     "camera 0: yfov: 3.5 radians",
     {.more = "\"cameras\": [{\"type\": \"perspective\", \"perspective\": {\"yfov\": 3.5,"
              " \"znear\": 1}}],"}},
    {"camera without parameters",
     "camera 0: it has no 'orthographic'",
     {.more = "\"cameras\": [{\"type\": \"orthographic\"}],"}},

    {"base colour of three",
     "material 0: pbrMetallicRoughness: baseColorFactor: not an array of 4",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 1, 1]}}]"}},
    {"more than metal",
     "material 0: metallicFactor: 1.5 is not from 0 to 1",
     {.materials = "[{\"pbrMetallicRoughness\": {\"metallicFactor\": 1.5}}]"}},
    {"roughness that is no number",
     "material 0: pbrMetallicRoughness: roughnessFactor: \"high\" is not a number",
     {.materials = "[{\"pbrMetallicRoughness\": {\"roughnessFactor\": \"high\"}}]"}},
    {"emission that takes light away",
     "material 0 'hole': emissiveFactor: it is negative or too large",
     {.materials = "[{\"name\": \"hole\", \"emissiveFactor\": [0, -1, 0]}]"}},
    {"emission without bound",
     "material 0: emissiveFactor: it is negative or too large",
     {.materials = "[{\"emissiveFactor\": [1, 1, 1], \"extensions\":"
                   " {\"KHR_materials_emissive_strength\": {\"emissiveStrength\": 1e39}}}]"}},
    {"no such texture",
     "baseColorTexture: index: 0, but there are 0 textures",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]"}},
    {"alpha mode",
     "material 0 'leaf': alphaMode: \"HOLES\" is none of OPAQUE MASK BLEND",
     {.materials = "[{\"name\": \"leaf\", \"alphaMode\": \"HOLES\"}]"}},
    {"missing picture",
     "material 0: image 0 'lion': cannot open build",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]",
      .more = "\"images\": [{\"uri\": \"lion.png\", \"name\": \"lion\"}], \"textures\":"
              " [{\"source\": 0}],"}},
    {"picture outside",
     "material 0: image 0: '../lion.png' is not a path inside",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]",
      .more = "\"images\": [{\"uri\": \"../lion.png\"}], \"textures\": [{\"source\": 0}],"}},
    {"picture of another kind",
     "material 0: image 0: not a picture of a known format",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]",
      .more = "\"images\": [{\"bufferView\": 0, \"mimeType\": \"image/png\"}], \"textures\":"
              " [{\"source\": 0}],"}},
    {"picture of nowhere",
     "image 0: bufferView: 8, but there are 1 bufferViews",
     {.more = "\"images\": [{\"bufferView\": 8}],"}},
    {"texture without picture",
     "material 0: texture 0: it has no source",
     {.materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]",
      .more = "\"textures\": [{}],"}},
};

/* The message is one line, names the file, and says what is expected. */
static void check_refused(const char *what, const char *path, bool loaded, const char *message) {
    assert_false(loaded);
    printf("    %-28s %s\n", what, error_get());
    if (!strstr(error_get(), path) || strchr(error_get(), '\n') || !strstr(error_get(), message))
        fail_msg("%s: expected '%s' and '%s'", what, path, message);
}

static void test_hostile_files(void **state) {
    (void)state;
    write_bytes(scratch("../secret.bin"), "secret", 6);
    unlink(scratch("link.bin"));
    assert_int_equal(symlink("../secret.bin", scratch("link.bin")), 0);
    mkdir(scratch("folder"), 0777);
    for (size_t i = 0; i < sizeof hostile / sizeof *hostile; i++) {
        struct scene scene;
        struct geometry geometry;
        const char *path = write_parts("hostile.glb", &hostile[i].parts);
        bool opened = scene_open(&scene, &geometry, path, NULL);
        check_refused(hostile[i].name, path, opened, hostile[i].message);
        assert_null(scene.path);
        assert_null(geometry.position);
    }
}

/* A few bytes that claim to be a huge picture. */
static void test_huge_picture(void **state) {
    (void)state;
    /* PNG: signature, IHDR of 900,000 x 900,000 RGB, an empty IDAT. */
    static const unsigned char png[] = {
        0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x0D, 0xBB, 0xA0, 0x00, 0x0D, 0xBB, 0xA0, 0x08, 0x02, 0x00, 0x00,
        0x00, 0x5F, 0xDF, 0x06, 0xD8, 0x00, 0x00, 0x00, 0x08, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9C, 0x03, 0x00, 0x00, 0x00, 0x00, 0x01, 0x48, 0x06, 0x89, 0xD2};
    struct scene scene;
    bool loaded = load_parts(
        &scene, "huge.glb",
        &(struct gltf_parts){
            .views = "[{\"buffer\": 0, \"byteLength\": 320}, {\"buffer\": 0, \"byteOffset\": 64,"
                     " \"byteLength\": 256}]",
            .materials = "[{\"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}}]",
            .more = "\"images\": [{\"bufferView\": 1}], \"textures\": [{\"source\": 0}],",
            .extra = png,
            .extra_size = sizeof png});
    check_refused("huge picture", scratch("huge.glb"), loaded,
                  "material 0: image 0: picture: too large: 900000x900000");
}

static unsigned char glb[32768];

static void check_bytes_refused(const char *what, size_t size, const char *message) {
    const char *path = scratch("container.glb");
    write_bytes(path, glb, size);
    struct scene scene;
    check_refused(what, path, scene_load(&scene, path), message);
}

static void set_word(size_t at, uint32_t word) {
    memcpy(glb + at, &word, sizeof word);
}

static void test_containers(void **state) {
    (void)state;
    const struct gltf_parts quad = {0};
    size_t size = parts_glb(&quad, glb, sizeof glb);
    size_t json_size = size - 28 - PARTS_BIN;
    check_bytes_refused("empty", 0, "the file is empty");
    check_bytes_refused("magic alone", 4, "truncated: 4 bytes are no GLB file");
    check_bytes_refused("header alone", 12, "truncated: 12 bytes are no GLB file");
    check_bytes_refused("half the JSON", 100, "truncated: the header says");
    check_bytes_refused("half the BIN", size - 100, "truncated: the header says");
    check_bytes_refused("bytes behind", size + 4, "wrong length: the header says");
    set_word(4, 1);
    check_bytes_refused("version 1", size, "GLB version 1, not 2");
    parts_glb(&quad, glb, sizeof glb);
    set_word(12, 0xFFFFFFFC);
    check_bytes_refused("endless chunk", size, "chunk 0: 4294967292 bytes, but only");
    parts_glb(&quad, glb, sizeof glb);
    set_word(16, 0x004E4942);
    check_bytes_refused("BIN first", size, "chunk 0: type 0x004E4942 is not JSON");
    parts_glb(&quad, glb, sizeof glb);
    set_word(20 + json_size + 4, 0x4E4F534A);
    check_bytes_refused("JSON twice", size, "chunk 1: type 0x4E4F534A is not BIN");
    parts_glb(&quad, glb, sizeof glb);
    set_word(20 + json_size, PARTS_BIN + 4);
    check_bytes_refused("BIN 4 bytes long", size, "chunk 1: 324 bytes, but only 320 are left");
    parts_glb(&quad, glb, sizeof glb);
    set_word(20 + json_size, PARTS_BIN - 2);
    check_bytes_refused("uneven chunk", size, "chunk 1: 318 bytes are not a multiple of 4");
    parts_glb(&quad, glb, sizeof glb);
    set_word(8, (uint32_t)(20 + json_size));
    check_bytes_refused("no BIN", 20 + json_size, "buffer 0: it has no uri, and there is no BIN");
}

static void test_texts(void **state) {
    (void)state;
    static const struct {
        const char *text, *message;
    } texts[] = {
        {"hello", "syntax error"},
        {"[]", "the JSON is not an object"},
        {"{\"asset\": ", "unexpected end"},
        {"{}", "it has no 'asset'"},
        {"{\"asset\": {\"version\": \"2.0\xFF\"}}", "ill-formed UTF-8"},
    };
    const char *path = scratch("text.gltf");
    struct scene scene;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        write_bytes(path, texts[i].text, strlen(texts[i].text));
        check_refused("text", path, scene_load(&scene, path), texts[i].message);
    }
    /* Brackets that would overflow the stack of a recursive reader. */
    enum { DEPTH = 200000 };
    char *deep = mem_alloc(DEPTH + 64, 1);
    size_t size = (size_t)sprintf(deep, "{\"asset\": {\"version\": \"2.0\"}, \"extras\": ");
    memset(deep + size, '[', DEPTH);
    write_bytes(path, deep, size + DEPTH);
    check_refused("deep", path, scene_load(&scene, path), "the JSON is nested too deep");
    free(deep);
    check_refused("folder", scratch("folder"), scene_load(&scene, scratch("folder")), "not a file");
    check_refused("nothing", scratch("none.glb"), scene_load(&scene, scratch("none.glb")),
                  "No such");
}

/* xorshift64 [Marsaglia 2003]. */
static uint32_t next_random(uint64_t *x) {
    *x ^= *x << 13;
    *x ^= *x >> 7;
    *x ^= *x << 17;
    return (uint32_t)(*x >> 32);
}

/* Flips, overwrites or inserts digits in a good file: whatever comes out, loading it must end. */
static void test_mutations(void **state) {
    (void)state;
    const struct gltf_parts parts = {
        .accessors = "[{\"bufferView\": 0," VECTORS "}, {\"bufferView\": 0, \"byteOffset\":"
                     " 48," INDEX_TYPE "}, {\"bufferView\": 0, \"componentType\": 5121, \"count\":"
                     " 4, \"type\": \"VEC3\", \"sparse\": {\"count\": 2, \"indices\":"
                     " {\"bufferView\": 0, \"byteOffset\": 48, \"componentType\": 5123},"
                     " \"values\": {\"bufferView\": 0, \"byteOffset\": 60}}}]",
        .meshes = PRIMITIVE("\"attributes\": {\"POSITION\": 0, \"NORMAL\": 2}, \"indices\": 1,"
                            " \"material\": 0, \"mode\": 5"),
        .nodes = "[{\"mesh\": 0, \"children\": [1, 2]}, {\"camera\": 0, \"scale\": [1, 2, 3]},"
                 " {\"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}}]",
        .more = "\"cameras\": [{\"type\": \"perspective\", \"perspective\": {\"yfov\": 1,"
                " \"znear\": 1}}], \"extensions\": {\"KHR_lights_punctual\": {\"lights\":"
                " [{\"type\": \"spot\", \"spot\": {}}]}}, \"scenes\": [{\"nodes\": [0]}],"};
    size_t size = parts_glb(&parts, glb, sizeof glb);
    static unsigned char good[sizeof glb];
    memcpy(good, glb, size);
    const char *path = scratch("mutated.glb");
    uint64_t random = 20240229;
    int loaded = 0, count = 0;
    for (clock_t start = clock(); count < 4000 && clock() - start < 2 * CLOCKS_PER_SEC; count++) {
        memcpy(glb, good, size);
        for (uint32_t k = next_random(&random) % 4 + 1; k > 0; k--) {
            size_t at = next_random(&random) % size;
            uint32_t r = next_random(&random);
            glb[at] = r & 1   ? (unsigned char)('0' + (r >> 8) % 10)
                      : r & 2 ? (unsigned char)(glb[at] ^ 1u << (r >> 8) % 8)
                              : (unsigned char)(r >> 8);
        }
        write_bytes(path, glb, size);
        struct scene scene;
        struct geometry geometry;
        if (!scene_load(&scene, path)) {
            assert_non_null(strstr(error_get(), path));
            continue;
        }
        loaded++;
        if (geometry_init(&geometry, &scene, 0)) {
            for (uint32_t i = 0; i < geometry.index_count; i++)
                assert_true(geometry.indices[i] < geometry.vertex_count);
            geometry_free(&geometry);
        }
        scene_free(&scene);
    }
    printf("    %d of %d mutated files loaded\n", loaded, count);
    assert_true(loaded > 0 && loaded < count);
}

int main(void) {
    log_set_level(LOG_QUIET);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hostile_files), cmocka_unit_test(test_huge_picture),
        cmocka_unit_test(test_containers),    cmocka_unit_test(test_texts),
        cmocka_unit_test(test_mutations),
    };
    return cmocka_run_group_tests_name("gltf refusals", tests, NULL, NULL);
}
