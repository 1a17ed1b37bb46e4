/* Textures, decoded in memory. No exception leaves it. */
#include "base/file/openimageio/bridge.hpp"

extern "C" {
#include "base/file/webp.h"
}

#include <cstring>
#include <memory>
#include <vector>

using namespace OIIO;
using namespace bridge;

namespace {

/* A picture in memory: the format is told by its content; the name only has to have no known
 * extension. */
std::unique_ptr<ImageInput> open_texture(Filesystem::IOMemReader &reader, ImageSpec &spec) {
    for (const char *format : {"png", "jpeg", "webp", "bmp", "tga"}) {
        std::unique_ptr<ImageInput> in = ImageInput::create(format);
        if (in && in->set_ioproxy(&reader)) {
            reader.seek(0);
            if (in->open("texture", spec, as_stored()))
                return check_size(spec, "picture") ? std::move(in) : nullptr;
            in->geterror();
        }
    }
    error_set("not a picture of a known format");
    return nullptr;
}

/* Puts colours as stored in place of those times alpha, which OpenImageIO's WebP gives always. */
bool restore_webp(std::vector<unsigned char> &rgba, const void *bytes, size_t size) {
    const unsigned char *begin = static_cast<const unsigned char *>(bytes);
    std::vector<unsigned char> copy(begin, begin + size);
    if (!mem_check(rgba.size()))
        return error_prefix("a picture");
    if (!webp_hide_alpha(copy.data(), size))
        return fail("picture", "its alpha cannot be told from its colours");
    Filesystem::IOMemReader reader(copy.data(), size);
    ImageSpec spec;
    std::unique_ptr<ImageInput> in = open_texture(reader, spec);
    if (!in)
        return false;
    std::vector<unsigned char> rgb(spec.image_pixels() * 3);
    if (spec.image_pixels() * 4 != rgba.size() ||
        !in->read_image(0, 0, 0, 3, TypeDesc::UINT8, rgb.data()))
        return fail("picture", in->geterror());
    for (size_t i = 0; i < rgb.size(); i++)
        rgba[i / 3 * 4 + i % 3] = rgb[i];
    return true;
}

} // namespace

bool bridge::measure_texture(const void *bytes, size_t size, uint64_t *memory) try {
    Filesystem::IOMemReader reader(const_cast<void *>(bytes), size);
    ImageSpec spec;
    if (!open_texture(reader, spec))
        return false;
    *memory = spec.image_pixels() * 28 / 3; /* RGBA8, and RGBA8 with MIP maps */
    return true;
} catch (const std::exception &error) {
    return error_set("%s", error.what());
}

bool bridge::decode_texture(struct bitmap *bitmap, const void *bytes, size_t size) try {
    *bitmap = {};
    Filesystem::IOMemReader reader(const_cast<void *>(bytes), size);
    ImageSpec spec;
    std::unique_ptr<ImageInput> in = open_texture(reader, spec);
    if (!in)
        return false;
    if (!mem_check(spec.image_pixels() * (spec.nchannels + 4)))
        return error_prefix("a picture of %dx%d", spec.width, spec.height);
    std::vector<unsigned char> source(spec.image_pixels() * spec.nchannels);
    if (!in->read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT8, source.data()))
        return fail("picture", in->geterror());
    if (strcmp(in->format_name(), "webp") == 0 && spec.nchannels == 4 &&
        !restore_webp(source, bytes, size))
        return false;
    bitmap->width = spec.width;
    bitmap->height = spec.height;
    bitmap->rgba = static_cast<unsigned char *>(mem_alloc(spec.image_pixels(), 4));
    const int n = spec.nchannels;
    for (size_t i = 0; i < spec.image_pixels(); i++) {
        const unsigned char *from = &source[i * n];
        unsigned char *to = &bitmap->rgba[i * 4];
        for (int c = 0; c < 3; c++)
            to[c] = from[n >= 3 ? c : 0];
        to[3] = n == 4 ? from[3] : n == 2 ? from[1] : 255;
    }
    return true;
} catch (const std::exception &error) {
    bitmap_free(bitmap);
    return error_set("%s", error.what());
}
