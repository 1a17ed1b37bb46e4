/* The node tree. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace gltf {
namespace {

/* The nodes that the scene lists: the default one or the first. All, where there is no scene. */
std::vector<int> listed_nodes(const Model &model) {
    if (!model.scenes.empty())
        return model.scenes[size_t(std::max(model.defaultScene, 0))].nodes;
    std::vector<int> all(model.nodes.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/* Each node once, parents before children, siblings in the file's order. */
std::vector<int> order_nodes(const Model &model, const std::vector<int> &roots) {
    std::vector<int> order, stack(roots.rbegin(), roots.rend());
    std::vector<bool> is_known(model.nodes.size());
    while (!stack.empty()) {
        int node = stack.back();
        stack.pop_back();
        if (is_known[node])
            continue;
        is_known[node] = true;
        order.push_back(node);
        const std::vector<int> &children = model.nodes[node].children;
        stack.insert(stack.end(), children.rbegin(), children.rend());
    }
    return order;
}

bool mend_place(Loader &loader, int node) {
    return mend(loader,
                "nodes that are listed twice, or as roots below a parent, are drawn once, below it",
                label("node", size_t(node), loader.model.nodes[node].name));
}

/* Each listed node's parent and that of nodes below, or -1. Parents that hang on no listed node
 * count for none: a scene is drawn from its list downwards. */
bool find_parents(Loader &loader, const std::vector<int> &listed, std::vector<int> &parents) {
    const Model &model = loader.model;
    parents.assign(model.nodes.size(), -1);
    for (int i : order_nodes(model, listed))
        for (int child : model.nodes[i].children) {
            if (parents[child] >= 0 && parents[child] != i)
                return error_set("%s: it has two parents, nodes %d and %d",
                                 label("node", child, model.nodes[child].name).c_str(),
                                 std::min(i, parents[child]), std::max(i, parents[child]));
            if (parents[child] == i && !mend_place(loader, child))
                return false;
            parents[child] = i;
        }
    return true;
}

/* The listed nodes that hang on no other. */
bool find_roots(Loader &loader, const std::vector<int> &listed, const std::vector<int> &parents,
                std::vector<int> &roots) {
    const Model &model = loader.model;
    std::vector<bool> has_parent(model.nodes.size()), is_known(model.nodes.size());
    for (const tinygltf::Node &node : model.nodes)
        for (int child : node.children)
            has_parent[child] = true;
    for (int node : listed) {
        bool is_odd = !model.scenes.empty() && (has_parent[node] || is_known[node]);
        if (is_odd && !mend_place(loader, node))
            return false;
        if (parents[node] < 0 && !is_known[node])
            roots.push_back(node);
        is_known[node] = true;
    }
    return true;
}

/* A loop of nodes hangs on no root. */
bool check_loops(const Model &model, const std::vector<int> &listed,
                 const std::vector<int> &order) {
    std::set<int> good(order.begin(), order.end());
    for (int node : order_nodes(model, listed))
        if (good.count(node) == 0)
            return error_set("%s: it is its own ancestor",
                             label("node", node, model.nodes[node].name).c_str());
    return true;
}

bool load_transform(const tinygltf::Node &from, struct node &to) {
    to.has_matrix = !from.matrix.empty();
    to.rotation[3] = to.scale[0] = to.scale[1] = to.scale[2] = 1;
    if (!copy_numbers(from.matrix, to.matrix, "matrix") ||
        !copy_numbers(from.translation, to.translation, "translation") ||
        !copy_numbers(from.rotation, to.rotation, "rotation") ||
        !copy_numbers(from.scale, to.scale, "scale"))
        return false;
    const float *m = to.matrix;
    return !to.has_matrix || (m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1) ||
           error_set("matrix: its last row is not 0 0 0 1");
}

/* The light that an extension puts on the node, or -1. */
int node_light(const tinygltf::Node &node, const char *extension) {
    auto found = node.extensions.find(extension);
    return found == node.extensions.end() ? -1 : found->second.Get("light").GetNumberAsInt();
}

/* KHR_node_visibility */
bool is_hidden(const tinygltf::Node &node) {
    auto found = node.extensions.find("KHR_node_visibility");
    return found != node.extensions.end() && found->second.Has("visible") &&
           !found->second.Get("visible").Get<bool>();
}

std::set<int> nodes_that_clips_show(const Model &model) {
    std::set<int> nodes;
    for (const tinygltf::Animation &clip : model.animations)
        for (const tinygltf::AnimationChannel &channel : clip.channels) {
            int node, end = 0;
            sscanf(pointer_of(channel).c_str(),
                   "/nodes/%d/extensions/KHR_node_visibility/visible%n", &node, &end);
            if (end > 0)
                nodes.insert(node);
        }
    return nodes;
}

/* Of a node with one of each kind, which shine alike, the profile, or else the area light. */
void load_node_light(Loader &loader, const tinygltf::Node &from, struct node &to) {
    int area = node_light(from, "EXT_lights_area");
    to.light = add_profile_light(loader, from);
    if (to.light < 0)
        to.light = area >= 0 ? int(loader.model.lights.size()) + area
                             : node_light(from, "KHR_lights_punctual");
}

bool load_node(Loader &loader, const tinygltf::Node &from, struct node &to) {
    copy_name(to.name, from.name);
    to.mesh = from.mesh;
    to.camera = from.camera;
    to.light = -1;
    if (!to.hidden)
        load_node_light(loader, from, to);
    to.skin = from.skin;
    to.metaballs = -1;
    return load_transform(from, to);
}

/* Weights of the node's own for the morph targets of its mesh. */
bool load_node_weights(Loader &loader, const tinygltf::Node &from, size_t index, struct node &to) {
    int targets = to.mesh >= 0 ? loader.scene->meshes[to.mesh].target_count : 0;
    if (from.weights.empty())
        return true;
    if (targets > 0)
        to.weights = allocate<float>(size_t(targets));
    return copy_weights(loader, from.weights, size_t(targets), label("node", index, from.name),
                        to.weights);
}

bool read_vector(const tinygltf::Value &value, float out[3]) {
    bool good = value.IsArray() && value.ArrayLen() == 3;
    for (int i = 0; good && i < 3; i++) {
        good = value.Get(i).IsNumber();
        out[i] = good ? float(value.Get(i).GetNumberAsDouble()) : 0;
    }
    return good;
}

float read_number(const tinygltf::Value &value) {
    return value.IsNumber() ? float(value.GetNumberAsDouble()) : NAN;
}

/* Our own extras: {"metaballs": {...}} with the fields of struct metaballs. */
bool load_metaballs(const tinygltf::Node &from, struct scene &scene, struct node &to) {
    if (!from.extras.IsObject() || !from.extras.Has("metaballs") || to.mesh < 0 ||
        scene.meshes[to.mesh].primitive_count == 0)
        return true;
    const tinygltf::Value &extras = from.extras.Get("metaballs");
    struct metaballs *balls = &scene.metaballs[to.metaballs = scene.metaballs_count++];
    balls->count = extras.Get("count").GetNumberAsInt();
    balls->reach = read_number(extras.Get("reach"));
    balls->cell = read_number(extras.Get("cell"));
    balls->period = read_number(extras.Get("period"));
    return (read_vector(extras.Get("low"), balls->low) &&
            read_vector(extras.Get("high"), balls->high) && metaballs_are_sound(balls)) ||
           error_set("extras: these are no metaballs");
}

/* As many as are listed, and those of instances. */
bool allocate_nodes(Loader &loader, const std::vector<int> &order) {
    uint64_t instances = 0;
    for (int i : order)
        instances += count_instances(loader.model, loader.model.nodes[i]);
    if (!spend(loader, instances, sizeof(struct node)))
        return error_prefix("%llu instances", (unsigned long long)instances);
    loader.scene->nodes = allocate<struct node>(order.size() + instances);
    loader.scene->metaballs = allocate<struct metaballs>(order.size());
    return true;
}

} // namespace

bool load_nodes(Loader &loader) {
    const Model &model = loader.model;
    struct scene *scene = loader.scene;
    std::vector<int> parents, roots;
    const std::vector<int> listed = listed_nodes(model);
    if (!find_parents(loader, listed, parents) || !find_roots(loader, listed, parents, roots))
        return false;
    std::vector<int> order = order_nodes(model, roots), &place = loader.node_places;
    if (!check_loops(model, listed, order))
        return false;
    place.assign(model.nodes.size(), -1);
    if (!allocate_nodes(loader, order))
        return false;
    const std::set<int> shown = nodes_that_clips_show(model);
    for (int i : order) {
        struct node &node = scene->nodes[scene->node_count];
        bool is_off = is_hidden(model.nodes[i]);
        node.parent = parents[i] >= 0 ? place[parents[i]] : -1;
        node.dark = is_off && shown.count(i);
        node.hidden =
            (is_off && !node.dark) || (node.parent >= 0 && scene->nodes[node.parent].hidden);
        if (!load_node(loader, model.nodes[i], node) ||
            !load_node_weights(loader, model.nodes[i], size_t(i), node) ||
            !load_metaballs(model.nodes[i], *scene, node))
            return error_prefix("%s", label("node", i, model.nodes[i].name).c_str());
        load_node_extras(loader, i, parents[i], node);
        place[i] = scene->node_count++;
        if (!load_instances(loader, model.nodes[i]))
            return error_prefix("%s", label("node", i, model.nodes[i].name).c_str());
    }
    return true;
}

} // namespace gltf
