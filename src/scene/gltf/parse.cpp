/* From files to tinygltf's model. */
#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf/model.hpp"

#include <cstdlib>
#include <cstring>

namespace gltf {
namespace {

/* tinygltf's way to files: it asks whether one exists and then reads it. */
bool any_file_exists(const std::string &, void *) {
    return true;
}

std::string same_path(const std::string &path, void *) {
    return path;
}

/* Room for what is to be unpacked. */
bool make_absent(Loader &loader, const std::string &name, std::vector<unsigned char> *bytes) {
    uint64_t size = strtoull(name.c_str() + strlen(absent_prefix), nullptr, 10);
    if (!spend(loader, size, 1)) {
        error_prefix("buffer %zu", loader.model.buffers.size());
        loader.file_error = error_get();
        return false;
    }
    bytes->resize(size);
    return true;
}

bool read_for_tinygltf(std::vector<unsigned char> *bytes, std::string *, const std::string &name,
                       void *user) {
    Loader *loader = static_cast<Loader *>(user);
    bool absent = name.compare(0, strlen(absent_prefix), absent_prefix) == 0;
    loader->is_absent.resize(loader->model.buffers.size() + 1);
    loader->is_absent.back() = absent;
    if (absent)
        return make_absent(*loader, name, bytes);
    OwnedBytes file;
    if (!file_read_named(&file, loader->folder.c_str(), name.c_str())) {
        error_prefix("buffer %zu", loader->model.buffers.size());
        loader->file_error = error_get();
        return false;
    }
    bytes->assign(file.data, file.data + file.size);
    allow_memory(*loader, file.size);
    return true;
}

/* Keeps pictures as they are: only base colours are decoded, and later. */
bool keep_image(tinygltf::Image *image, const int, std::string *, std::string *, int, int,
                const unsigned char *bytes, int size, void *) {
    if (image->bufferView < 0)
        image->image.assign(bytes, bytes + size);
    return true;
}

/* tinygltf's message in one line, unless a file is to blame. */
bool refuse(const Loader &loader, const std::string &message) {
    if (!loader.file_error.empty())
        return error_set("%s", loader.file_error.c_str());
    return error_set("%.200s", message.substr(0, message.find('\n')).c_str());
}

/* The same file with another JSON. */
void change_json(OwnedBytes &bytes, const struct glb_chunks &chunks, bool binary,
                 std::string &json) {
    const size_t header = 20;
    json.resize((json.size() + 3) / 4 * 4, ' ');
    size_t tail = binary ? bytes.size - header - chunks.json_size : 0;
    size_t head = binary ? header : 0, size = head + json.size() + tail;
    auto *made = static_cast<unsigned char *>(mem_alloc(size, 1));
    memcpy(made, bytes.data, head);
    memcpy(made + head, json.data(), json.size());
    memcpy(made + head + json.size(), bytes.data + bytes.size - tail, tail);
    const uint32_t sizes[2] = {uint32_t(size), uint32_t(json.size())};
    if (binary)
        memcpy(made + 8, sizes, sizeof sizes);
    free(bytes.data);
    bytes.data = made;
    bytes.size = size;
}

/* A file of another kind rarely begins like that; a zero follows its last byte. */
bool may_be_json(const char *text) {
    const char mark[] = "\xEF\xBB\xBF";
    text += strncmp(text, mark, 3) == 0 ? 3 : 0;
    text += strspn(text, " \t\r\n");
    return *text == '{' || *text == '[';
}

/* Their names were for tinygltf alone. */
bool finish_absent(Loader &loader) {
    loader.is_absent.resize(loader.model.buffers.size());
    for (size_t i = 0; i < loader.is_absent.size(); i++)
        if (loader.is_absent[i])
            loader.model.buffers[i].uri.clear();
    return unpack_views(loader) && unpack_primitives(loader);
}

} // namespace

bool parse(Loader &loader, const char *path) {
    OwnedBytes bytes;
    if (!piped_file_read(&bytes, path))
        return false;
    if (bytes.size == 0)
        return error_set("%s: the file is empty", path);
    /* Of a limit, a part is left to what is done with the scene. */
    loader.memory = mem_is_limited() ? mem_free_bytes() / 4 * 3 : least_memory;
    allow_memory(loader, bytes.size);
    struct glb_chunks chunks = {reinterpret_cast<char *>(bytes.data), bytes.size, 0};
    bool binary = glb_is(&bytes);
    if (!binary && !may_be_json(chunks.json))
        return error_set("%s: not a scene: neither glTF nor GLB", path);
    std::string changed;
    if ((binary && !glb_check(&bytes, &chunks)) ||
        !check_schema(chunks.json, chunks.json_size, chunks.bin_size, changed))
        return error_prefix("%s", path);
    if (!changed.empty())
        change_json(bytes, chunks, binary, changed);
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_image, nullptr);
    parser.SetFsCallbacks({any_file_exists, same_path, read_for_tinygltf, nullptr, &loader});
    std::string error, warning;
    unsigned size = unsigned(bytes.size);
    const char *text = reinterpret_cast<char *>(bytes.data);
    bool good = binary
                    ? parser.LoadBinaryFromMemory(&loader.model, &error, &warning, bytes.data, size)
                    : parser.LoadASCIIFromString(&loader.model, &error, &warning, text, size, "");
    if (!good)
        return refuse(loader, error) || error_prefix("%s", path);
    return finish_absent(loader) || error_prefix("%s", path);
}

std::string decode_uri(const std::string &uri) {
    return tinygltf::dlib::urldecode(uri);
}

} // namespace gltf
