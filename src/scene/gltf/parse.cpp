/* From files to tinygltf's model. */
#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf/model.hpp"

#include <cstdlib>

namespace gltf {
namespace {

/* tinygltf's way to files: it asks whether one exists and then reads it. */
bool any_file_exists(const std::string &, void *) {
    return true;
}

std::string same_path(const std::string &path, void *) {
    return path;
}

bool read_for_tinygltf(std::vector<unsigned char> *bytes, std::string *, const std::string &name,
                       void *user) {
    Loader *loader = static_cast<Loader *>(user);
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

} // namespace

bool parse(Loader &loader, const char *path) {
    OwnedBytes bytes;
    if (!file_read(&bytes, path))
        return false;
    if (bytes.size == 0)
        return error_set("%s: the file is empty", path);
    /* Of a limit, a part is left to what is done with the scene. */
    loader.memory = mem_is_limited() ? mem_free_bytes() / 4 * 3 : least_memory;
    allow_memory(loader, bytes.size);
    const char *text = reinterpret_cast<char *>(bytes.data);
    struct glb_chunks chunks = {text, bytes.size, 0};
    bool binary = glb_is(&bytes);
    if ((binary && !glb_check(&bytes, &chunks)) ||
        !check_schema(chunks.json, chunks.json_size, chunks.bin_size))
        return error_prefix("%s", path);
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_image, nullptr);
    parser.SetFsCallbacks({any_file_exists, same_path, read_for_tinygltf, nullptr, &loader});
    std::string error, warning;
    unsigned size = unsigned(bytes.size);
    bool good = binary
                    ? parser.LoadBinaryFromMemory(&loader.model, &error, &warning, bytes.data, size)
                    : parser.LoadASCIIFromString(&loader.model, &error, &warning, text, size, "");
    return good || refuse(loader, error) || error_prefix("%s", path);
}

std::string decode_uri(const std::string &uri) {
    return tinygltf::dlib::urldecode(uri);
}

} // namespace gltf
