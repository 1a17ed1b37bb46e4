/* From files to tinygltf's model. */
#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf_model.hpp"

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

bool read_for_tinygltf(std::vector<unsigned char> *bytes, std::string *error,
                       const std::string &name, void *loader) {
    struct file_bytes file;
    if (!file_read_named(&file, static_cast<Loader *>(loader)->folder.c_str(), name.c_str())) {
        *error = error_get();
        return false;
    }
    bytes->assign(file.data, file.data + file.size);
    free(file.data);
    return true;
}

/* Keeps pictures as they are: only base colours are decoded, and later. */
bool keep_image(tinygltf::Image *image, const int, std::string *, std::string *, int, int,
                const unsigned char *bytes, int size, void *) {
    if (image->bufferView < 0)
        image->image.assign(bytes, bytes + size);
    return true;
}

bool parse_bytes(Loader &loader, const struct file_bytes &bytes) {
    if (bytes.size == 0)
        return error_set("the file is empty");
    if (glb_is(&bytes) && !glb_check(&bytes))
        return false;
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_image, nullptr);
    parser.SetFsCallbacks({any_file_exists, same_path, read_for_tinygltf, nullptr, &loader});
    std::string error, warning;
    unsigned size = unsigned(bytes.size);
    bool good = glb_is(&bytes)
                    ? parser.LoadBinaryFromMemory(&loader.model, &error, &warning, bytes.data, size)
                    : parser.LoadASCIIFromString(&loader.model, &error, &warning,
                                                 reinterpret_cast<char *>(bytes.data), size, "");
    return (good && error.empty()) || error_set("%s", error.substr(0, error.find('\n')).c_str());
}

} // namespace

bool parse(Loader &loader, const char *path) {
    struct file_bytes bytes;
    if (!file_read(&bytes, path))
        return false;
    bool good = parse_bytes(loader, bytes);
    free(bytes.data);
    return good || error_prefix("%s", path);
}

std::string decode_uri(const std::string &uri) {
    return tinygltf::dlib::urldecode(uri);
}

} // namespace gltf
