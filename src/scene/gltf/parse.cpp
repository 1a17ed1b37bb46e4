/* From files to tinygltf's model. */
#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf/json.hpp"

#include <cstdlib>
#include <cstring>

namespace gltf {
namespace {

/* Pictures are taken out of the JSON; only textures that are used are decoded, and later. */
bool keep_image(tinygltf::Image *, const int, std::string *, std::string *, int, int,
                const unsigned char *, int, void *) {
    return true;
}

/* tinygltf wants indices in a buffer view: accessors without get one until it has read them. */
std::vector<int> place_indices(json &root) {
    std::vector<int> placed;
    for (size_t i = 0; i < list_size(root, "/meshes"); i++)
        for (const json &primitive : root["meshes"][i]["primitives"]) {
            if (!primitive.contains("indices"))
                continue;
            int index = primitive["indices"].get<int>();
            if (root["accessors"][size_t(index)].emplace("bufferView", 0).second)
                placed.push_back(index);
        }
    if (!placed.empty() && list_size(root, "/bufferViews") == 0)
        root["bufferViews"] = json::array({{{"buffer", 0}, {"byteLength", 1}}});
    return placed;
}

/* Puts back what was taken out of the JSON. */
void finish_model(Loader &loader, const std::vector<int> &placed) {
    Model &model = loader.model;
    for (int index : placed)
        model.accessors[size_t(index)].bufferView = -1;
    model.bufferViews.resize(loader.strides.size());
    for (size_t i = 0; i < loader.strides.size(); i++)
        model.bufferViews[i].byteStride = loader.strides[i];
    model.buffers.resize(loader.buffers.size());
    for (size_t i = 0; i < loader.buffers.size(); i++)
        model.buffers[i].data = std::move(loader.buffers[i]);
}

/* tinygltf's message in one line. */
bool refuse(const std::string &message) {
    return error_set("%.200s", message.substr(0, message.find('\n')).c_str());
}

bool parse_model(Loader &loader, json &root) {
    std::vector<int> placed = place_indices(root);
    std::string text = root.dump(), error, warning;
    root = nullptr;
    if (text.size() > UINT32_MAX)
        return error_set("its JSON is too long");
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_image, nullptr);
    if (!parser.LoadASCIIFromString(&loader.model, &error, &warning, text.data(),
                                    unsigned(text.size()), ""))
        return refuse(error);
    finish_model(loader, placed);
    return unpack_views(loader) && unpack_primitives(loader);
}

/* Told before parsing, which recurses; the parser's own callback would cost the square of a list's
 * length. */
bool is_nested_deeper(const char *text, size_t size, int most) {
    bool quoted = false;
    int depth = 0;
    for (size_t i = 0; i < size; i++) {
        char c = text[i];
        if (quoted && c == '\\')
            i++;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '[' || c == '{') && ++depth > most)
            return true;
        else if (!quoted && (c == ']' || c == '}'))
            depth--;
    }
    return false;
}

/* The reason without the library's own name in brackets. */
bool parse_json(Loader &loader, const char *text, size_t size, json &root) try {
    if (is_nested_deeper(text, size, 64))
        return error_set("the JSON is nested too deep");
    root = json::parse(text, text + size, nullptr, false);
    if (root.is_discarded()) {
        std::string mended;
        size_t bad = replace_bad_text(std::string(text, size), mended);
        root = json::parse(mended);
        if (bad != std::string::npos && !mend(loader, "text that is not UTF-8 is read as U+FFFD",
                                              "byte " + std::to_string(bad) + " of the JSON"))
            return false;
    }
    return root.is_object() || error_set("the JSON is not an object");
} catch (const json::exception &error) {
    std::string reason = error.what();
    size_t bracket = reason.find("] ");
    for (char &c : reason)
        if ((unsigned char)c < 32 || c == 127)
            c = '?';
    return error_set("the JSON: %.300s", reason.c_str() + (bracket + 1 ? bracket + 2 : 0));
}

/* A scene in text begins with a bracket, or with a comment, which JSON does not have; a zero
 * follows the last byte. */
bool check_kind(const struct file_bytes &bytes) {
    const char *text = reinterpret_cast<const char *>(bytes.data);
    const char mark[] = "\xEF\xBB\xBF";
    if (bytes.size == 0)
        return error_set("the file is empty");
    if (strncmp(text, "\xFF\xFE", 2) == 0 || strncmp(text, "\xFE\xFF", 2) == 0 ||
        (bytes.size > 1 && ((text[0] == '{' && !text[1]) || (!text[0] && text[1] == '{'))))
        return error_set("the text is UTF-16; glTF is UTF-8");
    text += strncmp(text, mark, 3) == 0 ? 3 : 0;
    text += strspn(text, " \t\r\n");
    return (*text && strchr("{[/#", *text)) || error_set("not a scene: neither glTF nor GLB");
}

bool mend_container(Loader &loader, const struct glb_chunks &chunks) {
    return (!*chunks.length || mend(loader, "wrong lengths in a GLB are ignored", chunks.length)) &&
           (chunks.tail == 0 || mend(loader, "bytes after the last chunk of a GLB are ignored",
                                     std::to_string(chunks.tail) + " bytes")) &&
           (!chunks.is_uneven ||
            mend(loader, "chunks of a GLB that are no multiple of 4 are read as they are", "GLB"));
}

bool parse_bytes(Loader &loader, const struct file_bytes &bytes) {
    struct glb_chunks chunks = {};
    chunks.json = reinterpret_cast<const char *>(bytes.data);
    chunks.json_size = bytes.size;
    bool binary = glb_is(&bytes);
    json root;
    if (binary ? !glb_check(&bytes, &chunks) || !mend_container(loader, chunks)
               : !check_kind(bytes))
        return false;
    if (!parse_json(loader, chunks.json, chunks.json_size, root) || !check_asset(loader, root) ||
        !mend_lights(loader, root) || !check_schema(loader, root) || !mend_numbers(loader, root))
        return false;
    if (!take_buffers(loader, root, chunks.bin, chunks.bin_size))
        return chunks.is_cut ? error_prefix("truncated: %s", chunks.length) : false;
    return take_pictures(loader, root) && parse_model(loader, root);
}

/* With the zero that follows the last byte. */
bool copy_bytes(struct file_bytes &to, const struct file_bytes &from, const char *path) {
    if (from.size > UINT32_MAX)
        return error_set("%s: %zu bytes are more than the 4 GiB of a scene", path, from.size);
    if (!mem_check(from.size))
        return error_prefix("%s", path);
    to.data = static_cast<unsigned char *>(mem_alloc(from.size + 1, 1));
    to.size = from.size;
    if (from.size > 0)
        memcpy(to.data, from.data, from.size);
    return true;
}

} // namespace

bool parse(Loader &loader, const char *path, const struct file_bytes *given) {
    OwnedBytes bytes;
    if (!(given ? copy_bytes(bytes, *given, path) : piped_file_read(&bytes, path)))
        return false;
    /* Of a limit, a part is left to what is done with the scene. */
    loader.memory = mem_is_limited() ? mem_free_bytes() / 4 * 3 : least_memory;
    allow_memory(loader, bytes.size);
    return parse_bytes(loader, bytes) || error_prefix("%s", path);
}

} // namespace gltf
