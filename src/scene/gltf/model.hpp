/* What the parts of the bridge to tinygltf share: the only file that names it.
 *
 * Model and Loader live as long as one call of gltf_load. Functions return false with an error set;
 * exceptions (out of memory, bad JSON) pass through and end in gltf_load. */
#ifndef SCENE_GLTF_MODEL_HPP
#define SCENE_GLTF_MODEL_HPP

extern "C" {
#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/piped_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "scene/gltf/accessor.h"
#include "scene/gltf/file.h"
#include "scene/lights/slide.h"
#include "scene/material.h"
#include "scene/mesh/primitive.h"
#include "scene/read_rules.h"
#include "scene/shapes/metaballs.h"
#include "scene/texture.h"
}

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace gltf {

using tinygltf::Model;

/* A mapping: a texture's way from TEXCOORD_n to uv. */
struct UvSource {
    int set = 0, own_set = 0; /* the transform's, and the texture's in case there is no such one */
    double offset[2] = {0, 0}, rotation = 0, scale[2] = {1, 1};
};

/* A texture of the scene: image, sampler, and whether its numbers are linear. */
struct TextureKey {
    int image, sampler;
    bool linear;
};

/* Over all texels: linear RGBA of a picture of colours. */
using TextureMean = std::array<double, 4>;

/* A light profile of EXT_lights_ies: its slide, as in struct scene_light, and mean intensity. */
struct Profile {
    int slide;
    float mean;
};

/* The bytes of a file for as long as they are in scope. */
struct OwnedBytes : file_bytes {
    OwnedBytes() : file_bytes{nullptr, 0} {
    }
    OwnedBytes(const OwnedBytes &) = delete;
    ~OwnedBytes() {
        free(data);
    }
};

/* Of an accessor: numbers of vertices and indices, three for a triangle of a strip, are ints. */
const size_t max_elements = size_t(1) << 27;

/* What a scene may take where `ulimit -d` does not say: a small file can name any number of
 * elements, share them among many users, and hold pictures that are thousands of times smaller
 * packed. */
const uint64_t least_memory = uint64_t(2) << 30;
const uint64_t memory_of_file = 64; /* times its size */

/* All pictures before they are scaled down: 128 of 8192x8192. They are decoded one by one. */
const uint64_t most_picture_memory = uint64_t(80) << 30;

/* What lies farther, metres, no camera sees; a zfar beyond it is none. */
const double camera_depth_most = 1e9;

/* A defect that was mended: the first object that has it, and how many have. */
struct Mended {
    std::string what, first;
    size_t count;
};

/* A picture of the file: in a buffer view, in its data URI, or in the file of that URI. */
struct Picture {
    int view = -1;
    std::string uri;
    std::vector<unsigned char> bytes;
    std::string error; /* why its data URI is none */
};

struct Loader {
    struct scene *scene;
    std::string folder; /* "", ends in a slash, or is file_no_folder */
    Model model;
    std::vector<std::vector<unsigned char>> buffers; /* until the model has them */
    std::vector<Picture> pictures;                   /* one per image */
    std::vector<size_t> strides;                     /* of buffer views; 0 = packed */
    std::set<std::string> files; /* that it names, by their paths without links */
    std::vector<Mended> mended;
    std::vector<std::vector<UvSource>> mappings;      /* of each material */
    std::vector<Profile> profiles;                    /* of EXT_lights_ies */
    std::map<std::string, Profile> files_of_profiles; /* of extras, by name */
    std::map<int, TextureMean> texture_means;         /* of each image that was asked for */
    std::set<int> replaced_images;                    /* whose picture is missing or broken */
    std::vector<TextureKey> texture_keys;             /* one per texture of the scene */
    std::vector<unsigned char> texture_uses; /* one per texture of the file, once one is broken */
    std::vector<int> node_places;            /* each node's index in the scene, or -1 */
    std::vector<bool> is_absent;             /* of each buffer: its views are unpacked here */
    std::vector<std::string> lacks;          /* what the scene is shown without, in words */
    uint64_t memory = 0;                     /* bytes that the scene may still take */
    uint64_t texture_memory = 0;             /* bytes of its textures, no part of `memory` */
    uint64_t picture_memory = most_picture_memory; /* bytes that pictures may still take */
    int texture_side = 0; /* texels, to which larger textures are scaled down; 0: none are */
};

/* One format; the second name has a newer version besides. */
const char *const meshopt_names[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/* packed.cpp: fills absent buffers with what their views have packed, and gives accessors of packed
 * primitives buffers of their own. */
bool unpack_views(Loader &loader);
bool unpack_primitives(Loader &loader);

/* parse.cpp: reads and parses the file and the buffers it names. */
bool parse(Loader &loader, const char *path, const struct file_bytes *given);

/* buffers.cpp: reads the file that a URI names, with or without percent signs. */
bool read_uri(Loader &loader, const std::string &uri, struct file_bytes &bytes,
              enum file_lack &lack);

/* The file of a URI that was not read is the scene's all the same: nothing is written over it. */
void remember_uri(Loader &loader, const std::string &uri);

/* extension.cpp: remembers, once, what the scene is shown without; and says it all in one note. */
bool check_extensions(Loader &loader);
void lack(Loader &loader, const std::string &what);
void tell_lacks(const Loader &loader);

/* How far a number may be off by rounding. */
const double rounding = 1e-5;

/* mended.cpp: remembers that an object has a defect which is mended; under --strict an error
 * instead. Later each defect is told in one note, with the first object and the number
 * of others. */
bool mend(Loader &loader, const std::string &what, const std::string &object);
void tell_mended(const Loader &loader);
const char *const bad_clips = "channels of clips that are not valid are left out";

/* array.cpp: the bytes of a buffer view; and an accessor, whose elements all lie in theirs. */
const unsigned char *view_bytes(const Model &model, int view);
bool resolve_accessor(const Model &model, int index, struct accessor &out);

/* Takes so many bytes of what the scene may have, before they are allocated. Error: how many are
 * wanted, and how many are left. */
bool spend(Loader &loader, uint64_t count, size_t size);

/* Lets it have more, for one more file of so many bytes. */
void allow_memory(Loader &loader, uint64_t file_size);

/* Reads an accessor that holds `count` elements, each of `width` floats, into a new array. Elements
 * may have `least` instead, unless it is 0; the others are 1 then. */
bool load_elements(Loader &loader, int index, int width, size_t count, float **out, int least = 0);

/* deform.cpp: what moves a primitive's vertices, before they are flattened. */
bool load_joints(Loader &loader, const tinygltf::Primitive &from, const std::string &object,
                 struct primitive &to);
bool load_targets(Loader &loader, const tinygltf::Primitive &from, int count, struct primitive &to);

/* texture.cpp: the scene's texture for one of the file's; -1 where that has no picture. A picture
 * that is missing or broken is replaced. */
bool load_texture(Loader &loader, int index, bool linear, int &out);

/* Notes the size that textures were scaled down to, if they were. */
void note_texture_sizes(const Loader &loader);

/* The picture of a texture, or -1. */
int texture_source(const tinygltf::Texture &texture);

/* A picture that nothing can replace. Error: names the image. */
bool load_image(Loader &loader, int image, struct bitmap &bitmap);

/* slide.cpp: the picture that a light's extras name; room for one is there. */
bool load_slide(Loader &loader, const tinygltf::Value &extras, struct scene_light &light);

/* profile.cpp: the profiles of EXT_lights_ies, room for whose slides is there; and that which a
 * light's extras name. */
size_t count_profiles(const Model &model);
bool load_profiles(Loader &loader);
bool load_profile(Loader &loader, const tinygltf::Value &extras, struct scene_light &light);

/* A light of the scene, with a profile, for the node; -1: it has none. */
int add_profile_light(Loader &loader, const tinygltf::Node &node);

/* pointer.cpp: the JSON pointer of what the channel moves; "" = nothing. */
std::string pointer_of(const tinygltf::AnimationChannel &from);

/* Fills in what a channel moves, but for its keys. Target -1: the scene does not show it. Error:
 * there is no such object, or it cannot move. */
bool find_property(const Loader &loader, const std::string &pointer, struct channel &to,
                   bool &is_known);

/* choice.cpp: lists scenes and variants, and makes the chosen scene the model's default. */
bool load_choice(Loader &loader, const struct scene_choice &choice);

/* The material that the primitive has in the chosen variant; -1 = none. */
int material_of(const Loader &loader, const tinygltf::Primitive &primitive);

/* Each fills its part of the scene, in this order. */
bool load_materials(Loader &loader);
bool load_meshes(Loader &loader);
void settle_blending(struct scene &scene); /* of the loaded materials and meshes */
bool load_lights(Loader &loader);

/* light.cpp: sizes and the picture of the node's light from the extras of the node, where the light
 * has none. A note where they are none. */
void load_node_extras(Loader &loader, int index, int parent, struct node &node);
bool load_cameras(Loader &loader);
bool load_nodes(Loader &loader);
bool load_skins(Loader &loader);
bool load_clips(Loader &loader);
bool load_environment(Loader &loader);
bool load_medium(Loader &loader);

/* environment.cpp: the extras with that key, of the scene that is shown or else of the asset;
 * nullptr: there are none. */
const tinygltf::Value *find_extras(const Model &model, const char *key);

/* instances.cpp: how often a node's mesh is there by EXT_mesh_gpu_instancing, 0 = plainly; and the
 * nodes for that, behind the scene's last one, which is the node. */
size_t count_instances(const Model &model, const tinygltf::Node &node);
bool load_instances(Loader &loader, const tinygltf::Node &from);

/* The text for names and messages: cut between UTF-8 characters, and without control characters,
 * which could upset a terminal. */
std::string clean(const std::string &text);
void copy_name(char to[SCENE_NAME_SIZE], const std::string &from);

/* "mesh 3 'name'" */
std::string label(const char *noun, size_t index, const std::string &name);

/* Copies the numbers of a JSON array, which may be too large for floats; an absent one leaves the
 * defaults. */
bool copy_numbers(const std::vector<double> &from, float *to, const char *what);

/* mesh.cpp: weights for so many morph targets: others are ignored, and 0 where there are none. */
bool copy_weights(Loader &loader, const std::vector<double> &from, size_t targets,
                  const std::string &object, float *to);

template <typename T> T *allocate(size_t count) {
    return static_cast<T *>(mem_alloc(count, sizeof(T)));
}

} // namespace gltf

#endif
