/* Textures and their pictures. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cstring>

namespace gltf {
namespace {

enum class Outcome {
    Decoded,
    Broken, /* error: why */
    Refused /* the whole scene; error: why */
};

bool is_ktx2(const void *bytes, size_t size) {
    const char mark[] = "\xABKTX 20\xBB";
    return size > strlen(mark) && memcmp(bytes, mark, strlen(mark)) == 0;
}

Outcome decode(Loader &loader, const void *bytes, size_t size, struct bitmap &bitmap) {
    uint64_t memory;
    bool is_known = is_ktx2(bytes, size)
                        ? error_set("KTX2 is not read; convert it to PNG, as by gltf-transform's "
                                    "ktxdecompress")
                        : bitmap_measure(bytes, size, &memory);
    if (!is_known)
        return Outcome::Broken;
    if (memory > loader.picture_memory) {
        error_set("all pictures take more than %.0f GiB", double(most_picture_memory) / (1 << 30));
        return Outcome::Refused;
    }
    loader.picture_memory -= memory;
    if (!mem_check(memory))
        return Outcome::Refused;
    return bitmap_decode(&bitmap, bytes, size) ? Outcome::Decoded : Outcome::Broken;
}

Outcome decode_file(Loader &loader, const std::string &uri, struct bitmap &bitmap) {
    OwnedBytes file;
    enum file_lack lack;
    if (!read_uri(loader, uri, file, lack))
        return lack == FILE_OUTSIDE ? Outcome::Refused : Outcome::Broken;
    Outcome outcome = decode(loader, file.data, file.size, bitmap);
    if (outcome != Outcome::Decoded)
        error_prefix("%s", clean(uri).c_str());
    return outcome;
}

Outcome decode_picture(Loader &loader, const Picture &picture, struct bitmap &bitmap) {
    if (picture.view >= 0)
        return decode(loader, view_bytes(loader.model, picture.view),
                      loader.model.bufferViews[size_t(picture.view)].byteLength, bitmap);
    if (!picture.error.empty()) {
        error_set("%s", picture.error.c_str());
        return Outcome::Broken;
    }
    if (!picture.uri.empty() || picture.bytes.empty())
        return decode_file(loader, picture.uri, bitmap);
    return decode(loader, picture.bytes.data(), picture.bytes.size(), bitmap);
}

const int stand_in_size = 16;

/* What the materials use each texture for. */
const unsigned char used_as_color = 1, used_as_normal = 2;

void find_uses(Loader &loader) {
    auto &uses = loader.texture_uses;
    uses.resize(loader.model.textures.size());
    auto use = [&](int texture, unsigned char as) {
        if (texture >= 0)
            uses[size_t(texture)] |= as;
    };
    for (const tinygltf::Material &material : loader.model.materials) {
        auto old = material.extensions.find("KHR_materials_pbrSpecularGlossiness");
        use(material.pbrMetallicRoughness.baseColorTexture.index, used_as_color);
        use(material.normalTexture.index, used_as_normal);
        if (old != material.extensions.end() && old->second.Has("diffuseTexture"))
            use(old->second.Get("diffuseTexture").Get("index").GetNumberAsInt(), used_as_color);
    }
}

/* A checker of magenta for a base colour, as viewers have it. Others change nothing: normals are
 * straight, surfaces rough and no metal, and nothing shines. */
void make_stand_in(unsigned char uses, struct scene_texture &to) {
    static const unsigned char magenta[4] = {255, 0, 255, 255}, black[4] = {0, 0, 0, 255},
                               straight[4] = {128, 128, 255, 255}, rough[4] = {0, 255, 0, 0},
                               none[4] = {0, 0, 0, 0};
    const int square = 4;
    to.nearest = true;
    to.bitmap.width = to.bitmap.height = stand_in_size;
    to.bitmap.rgba = allocate<unsigned char>(size_t(stand_in_size * stand_in_size * 4));
    for (int i = 0; i < stand_in_size * stand_in_size; i++) {
        bool odd = (i / stand_in_size / square + i % stand_in_size / square) % 2;
        const unsigned char *texel = to.linear ? (uses & used_as_normal ? straight : rough)
                                     : uses & used_as_color ? (odd ? black : magenta)
                                                            : none;
        memcpy(to.bitmap.rgba + i * 4, texel, 4);
    }
}

enum texture_wrap wrap_mode(int gl) {
    return gl == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? TEXTURE_WRAP_CLAMP
           : gl == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TEXTURE_WRAP_MIRROR
                                                         : TEXTURE_WRAP_REPEAT;
}

/* The formats of pictures that extensions bring. The first is read. */
const char *const formats[] = {"EXT_texture_webp", "EXT_texture_avif", "KHR_texture_basisu",
                               "MSFT_texture_dds"};

/* The extension that a texture's only picture is in the format of; nullptr: it needs none. */
const char *find_format(const tinygltf::Texture &texture) {
    for (const char *format : formats) {
        auto found = texture.extensions.find(format);
        if (texture.source < 0 && found != texture.extensions.end() && found->second.Has("source"))
            return format;
    }
    return nullptr;
}

/* Whether the file cannot do without the texture's format, which is not read. */
bool is_needed(const Model &model, const char *format) {
    const auto &names = model.extensionsRequired;
    return format && format != formats[0] &&
           std::find(names.begin(), names.end(), format) != names.end();
}

void limit_size(const Loader &loader, const std::string &object, struct scene_texture &made) {
    const struct bitmap before = made.bitmap;
    if (before.width <= TEXTURE_SIDE_MAX && before.height <= TEXTURE_SIDE_MAX)
        return;
    texture_shrink(&made, TEXTURE_SIDE_MAX);
    log_note("%s: %s: its %dx%d pixels are scaled down to %dx%d", loader.scene->path,
             object.c_str(), before.width, before.height, made.bitmap.width, made.bitmap.height);
}

/* Bytes per texel: the scene's copy, and the GPU's with MIP maps. The most is for half floats of
 * software OpenGL, with some to spare. */
const uint64_t texel_bytes = 10, most_texel_bytes = 16;

struct Texels {
    uint64_t count = 0;
    int side = 0; /* the longest of a texture */
};

Texels texels_of(const struct scene_texture *textures, int count) {
    Texels texels;
    for (int i = 0; i < count; i++) {
        const struct bitmap &bitmap = textures[i].bitmap;
        texels.count += uint64_t(bitmap.width) * uint64_t(bitmap.height);
        texels.side = std::max({texels.side, bitmap.width, bitmap.height});
    }
    return texels;
}

/* Halves the sides of the largest textures until all fit into the memory that is free and that the
 * scene may take. */
bool make_room(Loader &loader, int count) {
    struct scene_texture *textures = loader.scene->textures;
    uint64_t whole = loader.memory + loader.texture_memory;
    uint64_t room = std::min(whole / texel_bytes, mem_free_bytes() / most_texel_bytes);
    Texels texels = texels_of(textures, count);
    if (texels.count > room)
        room /= 2; /* meshes take memory, too */
    while (texels.count > room) {
        if (texels.side <= 1)
            return error_set("%d textures of one texel take too much memory", count);
        loader.texture_side = (texels.side + 1) / 2;
        for (int i = 0; i < count; i++)
            texture_shrink(&textures[i], loader.texture_side);
        texels = texels_of(textures, count);
    }
    loader.texture_memory = texels.count * texel_bytes;
    loader.memory = whole - loader.texture_memory;
    return true;
}

/* The picture, or its stand-in. */
bool load_picture(Loader &loader, int index, int source, struct scene_texture &made) {
    const std::string object =
        label("image", size_t(source), loader.model.images[size_t(source)].name);
    Outcome outcome = decode_picture(loader, loader.pictures[size_t(source)], made.bitmap);
    if (outcome == Outcome::Decoded) {
        limit_size(loader, object, made);
        return true;
    }
    const char *format = find_format(loader.model.textures[size_t(index)]);
    if (outcome == Outcome::Refused)
        return error_prefix("%s", object.c_str());
    if (is_needed(loader.model, format))
        return error_prefix("%s: the required extension '%s'", object.c_str(), format);
    if (!mend(loader,
              "pictures that are missing or broken are replaced, colours by a magenta checker",
              object + ": " + error_get()))
        return false;
    loader.replaced_images.insert(source);
    if (loader.texture_uses.empty())
        find_uses(loader);
    make_stand_in(loader.texture_uses[size_t(index)], made);
    return true;
}

} // namespace

bool load_image(Loader &loader, int image, struct bitmap &bitmap) {
    size_t number = size_t(image);
    return decode_picture(loader, loader.pictures[number], bitmap) == Outcome::Decoded ||
           error_prefix("%s", label("image", number, loader.model.images[number].name).c_str());
}

int texture_source(const tinygltf::Texture &texture) {
    const char *format = find_format(texture);
    return format ? texture.extensions.at(format).Get("source").GetNumberAsInt() : texture.source;
}

void note_texture_sizes(const Loader &loader) {
    if (loader.texture_side > 0)
        log_note("%s: the largest textures are scaled down, some to %d texels a side: all take too "
                 "much memory",
                 loader.scene->path, loader.texture_side);
}

/* A picture used with one sampler is decoded once, or twice where it holds colours here and numbers
 * there. */
bool load_texture(Loader &loader, int index, bool linear, int &out) {
    const Model &model = loader.model;
    const tinygltf::Texture &texture = model.textures[size_t(index)];
    int source = texture_source(texture);
    out = -1;
    if (source < 0)
        return mend(loader, "textures without a picture are left out",
                    "texture " + std::to_string(index));
    auto &keys = loader.texture_keys;
    TextureKey key = {source, texture.sampler, linear};
    auto known = std::find_if(keys.begin(), keys.end(), [&](const TextureKey &other) {
        return other.image == key.image && other.sampler == key.sampler && other.linear == linear;
    });
    out = int(known - keys.begin());
    if (known != keys.end())
        return true;
    struct scene_texture &made = loader.scene->textures[out];
    tinygltf::Sampler sampler;
    if (texture.sampler >= 0)
        sampler = model.samplers[size_t(texture.sampler)];
    made.wrap_u = wrap_mode(sampler.wrapS);
    made.wrap_v = wrap_mode(sampler.wrapT);
    made.linear = linear;
    made.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    if (!load_picture(loader, index, source, made) || !make_room(loader, out + 1))
        return false;
    keys.push_back(key);
    loader.scene->texture_count++;
    return true;
}

} // namespace gltf
