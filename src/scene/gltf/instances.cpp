/* EXT_mesh_gpu_instancing: a node's mesh at many places, each of which becomes a child of
 * the node. */
#include "scene/gltf/model.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

namespace gltf {
namespace {

/* The accessor of an attribute, or -1. */
int find_attribute(const tinygltf::Node &node, const char *name) {
    auto found = node.extensions.find("EXT_mesh_gpu_instancing");
    if (found == node.extensions.end() || !found->second.Get("attributes").Has(name))
        return -1;
    return found->second.Get("attributes").Get(name).GetNumberAsInt();
}

/* What the attribute says of one place after another; `member` is where it belongs in a node. */
bool load_places(Loader &loader, const tinygltf::Node &from, const char *name, int width,
                 struct node *nodes, size_t member) {
    int index = find_attribute(from, name);
    float *numbers = nullptr;
    size_t count = count_instances(loader.model, from);
    if (index < 0)
        return true;
    bool good = load_elements(loader, index, width, count, &numbers);
    for (size_t i = 0; good && i < count; i++)
        memcpy(reinterpret_cast<char *>(&nodes[i]) + member, numbers + i * size_t(width),
               size_t(width) * sizeof *numbers);
    free(numbers);
    return good || error_prefix("%s", name);
}

/* A quaternion of length 0 becomes that of no turn. */
bool mend_rotation(Loader &loader, float q[4], size_t index) {
    if (std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) > 1e-6)
        return true;
    q[0] = q[1] = q[2] = 0;
    q[3] = 1;
    return mend(loader, "a quaternion of length 0 turns nothing",
                "instance " + std::to_string(index) + ": ROTATION");
}

/* One place, as yet that of its parent. */
void make_place(struct node &place, const struct node &parent, int index, int targets) {
    place = {};
    memcpy(place.name, parent.name, sizeof place.name);
    place.parent = index;
    place.mesh = parent.mesh;
    place.hidden = parent.hidden;
    place.light = place.camera = place.skin = place.metaballs = -1;
    place.rotation[3] = place.scale[0] = place.scale[1] = place.scale[2] = 1;
    if (parent.weights) {
        place.weights = allocate<float>(size_t(targets));
        memcpy(place.weights, parent.weights, size_t(targets) * sizeof *place.weights);
    }
}

} // namespace

size_t count_instances(const Model &model, const tinygltf::Node &node) {
    for (const char *name : {"TRANSLATION", "ROTATION", "SCALE"}) {
        int index = find_attribute(node, name);
        if (index >= 0 && node.mesh >= 0)
            return model.accessors[index].count;
    }
    return 0;
}

bool load_instances(Loader &loader, const tinygltf::Node &from) {
    struct scene *scene = loader.scene;
    size_t count = count_instances(loader.model, from);
    if (count == 0)
        return true;
    int parent = scene->node_count - 1;
    struct node *nodes = &scene->nodes[scene->node_count];
    int targets = scene->meshes[from.mesh].target_count;
    for (size_t i = 0; i < count; i++, scene->node_count++)
        make_place(nodes[i], scene->nodes[parent], parent, targets);
    scene->nodes[parent].mesh = -1;
    if (!load_places(loader, from, "TRANSLATION", 3, nodes, offsetof(struct node, translation)) ||
        !load_places(loader, from, "ROTATION", 4, nodes, offsetof(struct node, rotation)) ||
        !load_places(loader, from, "SCALE", 3, nodes, offsetof(struct node, scale)))
        return error_prefix("instances");
    for (size_t i = 0; i < count; i++)
        if (!mend_rotation(loader, nodes[i].rotation, i))
            return false;
    return true;
}

} // namespace gltf
