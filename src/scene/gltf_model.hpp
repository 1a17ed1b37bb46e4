/* What the parts of the bridge to tinygltf share: the only file that names it.
 *
 * Model and Loader live as long as one call of gltf_load. Functions return false with an error set;
 * exceptions (out of memory, bad JSON) pass through and end in gltf_load.
 */
#ifndef SCENE_GLTF_MODEL_HPP
#define SCENE_GLTF_MODEL_HPP

extern "C" {
#include "base/error.h"
#include "base/image_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "scene/accessor.h"
#include "scene/gltf_file.h"
#include "scene/primitive.h"
#include "scene/scene.h"
}

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <string>
#include <utility>
#include <vector>

namespace gltf {

using tinygltf::Model;

/* The base colour texture's way from TEXCOORD_n to uv. */
struct UvSource {
    int set = 0;
    double offset[2] = {0, 0}, rotation = 0, scale[2] = {1, 1};
};

struct Loader {
    struct scene *scene;
    std::string folder; /* "" or ends in a slash */
    Model model;
    std::vector<UvSource> uv_sources;              /* one per material */
    std::vector<std::pair<int, int>> texture_keys; /* image and sampler of each texture */
};

/* gltf_parse.cpp: reads and parses the file and the buffers it names. */
bool parse(Loader &loader, const char *path);
std::string decode_uri(const std::string &uri);

/* gltf_array.cpp: the bytes of a buffer view, and an accessor whose elements all lie in theirs. */
bool view_bytes(const Model &model, int view, size_t offset, const unsigned char **bytes,
                size_t *size);
bool resolve_accessor(const Model &model, int index, struct accessor &out);

/* Each fills its part of the scene, in this order. */
bool load_materials(Loader &loader);
bool load_meshes(Loader &loader);
bool load_lights(Loader &loader);
bool load_cameras(Loader &loader);
bool load_nodes(Loader &loader);

/* "mesh 3 'name'" */
std::string label(const char *noun, size_t index, const std::string &name);

/* Control characters, which could upset a terminal, are replaced. Cut between UTF-8 characters. */
void copy_name(char to[SCENE_NAME_SIZE], const std::string &from);

/* Copies the numbers of a JSON array; an absent one leaves the defaults. */
bool copy_numbers(const std::vector<double> &from, float *to, size_t count, const char *what);

template <typename T> T *allocate(size_t count) {
    return static_cast<T *>(mem_alloc(count, sizeof(T)));
}

} // namespace gltf

#endif
