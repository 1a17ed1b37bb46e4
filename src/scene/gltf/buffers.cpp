/* The bytes that a file's JSON names: buffers in the file, beside it or in data URIs, and pictures.
 *
 * All are taken out of the JSON, so that tinygltf reads no file and copies nothing. */
#include "scene/gltf/json.hpp"

extern "C" {
#include "scene/gltf/data_uri.h"
}

#include <algorithm>

namespace gltf {

namespace {

std::string unescape(std::string uri) {
    uri.resize(uri_unescape(&uri[0]));
    return uri;
}

} // namespace

bool read_uri(Loader &loader, const std::string &uri, struct file_bytes &bytes,
              enum file_lack &lack) {
    char *path = nullptr;
    std::string name = unescape(uri);
    bool good = file_read_named(&bytes, loader.folder.c_str(), name.c_str(), &path, &lack);
    if (!good && lack == FILE_MISSING && name != uri) {
        std::string reason = error_get();
        good = file_read_named(&bytes, loader.folder.c_str(), uri.c_str(), &path, &lack) ||
               error_set("%s", reason.c_str());
    }
    /* A file that many objects name lets the scene have more once. */
    if (good && loader.files.insert(path).second)
        allow_memory(loader, bytes.size);
    free(path);
    return good;
}

void remember_uri(Loader &loader, const std::string &uri) {
    for (const std::string &name : {unescape(uri), uri}) {
        enum file_lack lack;
        char *path = file_find_named(loader.folder.c_str(), name.c_str(), &lack);
        if (path)
            loader.files.insert(path);
        free(path);
    }
}

namespace {

/* What tells where a view is packed, or nullptr. */
const json *find_packed(const json &view) {
    auto extensions = view.find("extensions");
    for (const char *name : meshopt_names)
        if (extensions != view.end() && extensions->contains(name))
            return &(*extensions)[name];
    return nullptr;
}

/* Whether bytes of a buffer are read, and whether views of it are packed elsewhere. */
struct Use {
    bool is_used = false, is_fallback = false;
};

std::vector<Use> find_uses(const json &root) {
    std::vector<Use> uses(list_size(root, "/buffers"));
    for (size_t i = 0; i < list_size(root, "/bufferViews"); i++) {
        const json &view = root["bufferViews"][i];
        const json *packed = find_packed(view);
        Use &use = uses[view["buffer"].get<size_t>()];
        use.is_fallback |= packed != nullptr;
        use.is_used |= !packed;
        if (packed)
            uses[(*packed)["buffer"].get<size_t>()].is_used = true;
    }
    return uses;
}

bool take_uri(Loader &loader, const std::string &uri, std::vector<unsigned char> &to) {
    OwnedBytes bytes;
    enum file_lack lack;
    if (data_uri_is(uri.c_str()) ? !data_uri_decode(&bytes, uri.c_str())
                                 : !read_uri(loader, uri, bytes, lack))
        return false;
    if (!spend(loader, bytes.size, 1))
        return false;
    to.assign(bytes.data, bytes.data + bytes.size);
    return true;
}

/* Bytes of the BIN chunk, of a URI, or room for what is unpacked. */
bool take_buffer(Loader &loader, const json &buffer, size_t index, const Use &use, const char *bin,
                 size_t bin_size) {
    std::vector<unsigned char> &to = loader.buffers[index];
    uint64_t length = buffer["byteLength"].get<uint64_t>();
    if (buffer.contains("uri") && (use.is_used || !use.is_fallback)) {
        if (!take_uri(loader, buffer["uri"].get<std::string>(), to))
            return !use.is_used && mend(loader, "buffers that no view needs are not read",
                                        "buffer " + std::to_string(index) + ": " + error_get());
    } else if (index == 0 && bin_size > 0) {
        to.assign(bin, bin + bin_size);
    } else {
        loader.is_absent[index] = true;
        if (!use.is_fallback)
            return true;
        if (!spend(loader, length, 1))
            return false;
        to.resize(length);
    }
    return to.size() >= length ||
           mend(loader, "buffers that have fewer bytes than they say are read as far as they are",
                "buffer " + std::to_string(index) + ": " + std::to_string(to.size()) +
                    " bytes, not " + std::to_string(length));
}

bool check_stride(Loader &loader, size_t index, size_t stride) {
    std::string object = "buffer view " + std::to_string(index);
    if (stride == 0)
        return mend(loader, "byteStride 0 is read as packed", object);
    return (stride >= 4 && stride <= 252 && stride % 4 == 0) ||
           mend(loader, "a byteStride that is no multiple of 4 from 4 to 252 is taken as it is",
                object + ": " + std::to_string(stride));
}

bool take_view(Loader &loader, json &view, size_t index, const json &buffers) {
    size_t buffer = view["buffer"], offset = view.value("byteOffset", size_t(0));
    size_t size = view["byteLength"], available = loader.buffers[buffer].size();
    if (loader.is_absent[buffer] && !find_packed(view))
        return error_set("its buffer %zu has no uri, and there is no BIN chunk for it", buffer);
    if (offset > available || size > available - offset)
        return error_set("%zu bytes at %zu are outside buffer %zu of %zu bytes", size, offset,
                         buffer, available);
    if (offset + size > buffers[buffer]["byteLength"].get<uint64_t>() &&
        !mend(loader, "buffer views beyond byteLength, where there are bytes, are read",
              "buffer view " + std::to_string(index)))
        return false;
    loader.strides.push_back(0);
    if (!view.contains("byteStride"))
        return true;
    size_t stride = view["byteStride"];
    view.erase("byteStride");
    loader.strides.back() = stride;
    return check_stride(loader, index, stride);
}

} // namespace

bool take_buffers(Loader &loader, json &root, const char *bin, size_t bin_size) {
    json buffers = root.value("buffers", json::array());
    std::vector<Use> uses = find_uses(root);
    loader.buffers.resize(buffers.size());
    loader.is_absent.resize(buffers.size());
    root.erase("buffers");
    for (size_t i = 0; i < buffers.size(); i++) {
        if (!take_buffer(loader, buffers[i], i, uses[i], bin, bin_size))
            return error_prefix("buffer %zu", i);
        buffers[i].erase("uri");
    }
    for (size_t i = 0; i < list_size(root, "/bufferViews"); i++)
        if (!take_view(loader, root["bufferViews"][i], i, buffers))
            return error_prefix("buffer view %zu", i);
    return true;
}

bool take_pictures(Loader &loader, json &root) {
    for (size_t i = 0; i < list_size(root, "/images"); i++) {
        json &image = root["images"][i];
        Picture picture;
        std::string uri = image.value("uri", std::string());
        if (image.contains("bufferView"))
            picture.view = image["bufferView"].get<int>();
        else if (!data_uri_is(uri.c_str()))
            picture.uri = uri;
        else if (!take_uri(loader, uri, picture.bytes))
            picture.error = error_get();
        loader.pictures.push_back(std::move(picture));
        json stub = {{"uri", "taken"}};
        if (image.contains("name"))
            stub["name"] = image["name"];
        image = std::move(stub);
    }
    return true;
}

} // namespace gltf
