/* The bridge to OpenImageIO. No exception leaves it. */
#include "base/image_file.h"

extern "C" {
#include "base/error.h"
#include "base/memory.h"
}

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

using namespace OIIO;

namespace {

/* Beyond this a file is refused rather than read: 2^28 pixels is 16384 x 16384. */
const imagesize_t max_pixels = imagesize_t(1) << 28;

bool fail(const char *path, const std::string &reason) {
    std::string line = reason.empty() ? "cannot be read" : reason.substr(0, reason.find('\n'));
    return error_set("%s: %s", path, line.c_str());
}

bool check_size(const ImageSpec &spec, const char *path) {
    if (spec.width < 1 || spec.height < 1 || spec.depth != 1 || spec.nchannels < 1)
        return fail(path, "not a two-dimensional picture");
    if (spec.image_pixels() > max_pixels)
        return fail(path,
                    "too large: " + std::to_string(spec.width) + "x" + std::to_string(spec.height));
    return true;
}

/* Writes beside the target and renames, so that the target is whole or untouched. write(file)
 * returns the reason of a failure, or "". */
template <typename Write> bool write_whole(const char *path, Write write) {
    /* The extension must stay last, for it picks the format. */
    const char *slash = strrchr(path, '/');
    std::string folder = slash ? std::string(path, slash + 1) : "";
    std::string beside =
        folder + "." + std::to_string(getpid()) + ".part." + (slash ? slash + 1 : path);
    std::string reason = write(beside);
    if (reason.empty() && rename(beside.c_str(), path) == 0)
        return true;
    if (reason.empty())
        reason = strerror(errno);
    remove(beside.c_str());
    /* The message may name the file beside; the user knows only the target. */
    size_t at = reason.find(beside);
    if (at != std::string::npos)
        reason.replace(at, beside.size(), path);
    return fail(path, reason);
}

bool write_pixels(const char *path, const ImageSpec &spec, TypeDesc type, const void *pixels) {
    return write_whole(path, [&](const std::string &beside) -> std::string {
        auto out = ImageOutput::create(path);
        if (!out)
            return geterror();
        bool good = out->open(beside, spec) && out->write_image(type, pixels);
        std::string reason = good ? "" : out->geterror();
        if (out->close() && good)
            return "";
        return reason.empty() ? "cannot be written" : reason;
    });
}

/* Portable float map, which OpenImageIO reads but does not write: a line each of kind, size and
 * byte order (negative: little endian), then rows of RGB from the bottom up. */
bool write_pfm(const char *path, int width, int height, const std::vector<float> &rgb) {
    return write_whole(path, [&](const std::string &beside) -> std::string {
        FILE *file = fopen(beside.c_str(), "wb");
        if (!file)
            return strerror(errno);
        bool good = fprintf(file, "PF\n%d %d\n-1.0\n", width, height) > 0;
        size_t row = size_t(width) * 3;
        for (int y = height - 1; good && y >= 0; y--)
            good = fwrite(&rgb[y * row], sizeof rgb[0], row, file) == row;
        good = fclose(file) == 0 && good;
        return good ? "" : strerror(errno);
    });
}

/* Formats of floats that have no more than red, green and blue. */
bool is_plain(const std::string &extension) {
    return extension == "pfm" || extension == "hdr";
}

bool write_plain(const struct image *image, const char *path, const std::string &extension) {
    int channels[3];
    if (!image_find_layer(image, "", channels))
        return error_prefix("%s", path);
    size_t count = size_t(image->width) * image->height;
    std::vector<float> rgb(count * 3);
    for (size_t i = 0; i < rgb.size(); i++)
        rgb[i] = image->pixels[i / 3 * image->channel_count + channels[i % 3]];
    if (extension == "pfm")
        return write_pfm(path, image->width, image->height, rgb);
    ImageSpec spec(image->width, image->height, 3, TypeDesc::FLOAT);
    return write_pixels(path, spec, TypeDesc::FLOAT, rgb.data());
}

bool is_colour(const std::string &name) {
    std::string last = name.substr(name.find_last_of('.') + 1);
    return last == "R" || last == "G" || last == "B" || last == "A";
}

} // namespace

extern "C" bool image_read(struct image *image, const char *path) try {
    *image = {};
    auto in = ImageInput::open(path);
    if (!in)
        return fail(path, geterror());
    const ImageSpec spec = in->spec();
    if (!check_size(spec, path))
        return false;
    std::string names;
    for (const std::string &name : spec.channelnames)
        names += (names.empty() ? "" : " ") + name.substr(0, IMAGE_NAME_SIZE - 1);
    image_init(image, spec.width, spec.height, names.c_str());
    image->encoded = !spec.format.is_floating_point();
    if (!in->read_image(0, 0, 0, spec.nchannels, TypeDesc::FLOAT, image->pixels)) {
        image_free(image);
        return fail(path, in->geterror());
    }
    return true;
} catch (const std::exception &error) {
    image_free(image);
    return fail(path, error.what());
}

extern "C" bool image_write(const struct image *image, const char *path) try {
    std::string extension = Filesystem::extension(path, false);
    if (is_plain(extension))
        return write_plain(image, path, extension);
    ImageSpec spec(image->width, image->height, image->channel_count, TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (int i = 0; i < image->channel_count; i++)
        spec.channelnames.push_back(image->names[i]);
    if (extension == "exr") {
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", ""); /* else it is now, and no two files are alike */
        for (const std::string &name : spec.channelnames)
            spec.channelformats.push_back(is_colour(name) ? TypeDesc::HALF : TypeDesc::FLOAT);
    }
    spec.alpha_channel = image_find_channel(image, "A");
    spec.z_channel = image_find_channel(image, "Z");
    return write_pixels(path, spec, TypeDesc::FLOAT, image->pixels);
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool bitmap_write(const struct bitmap *bitmap, const char *path) try {
    std::string extension = Filesystem::extension(path, false);
    /* Our pictures are opaque: an alpha channel would only surprise. */
    ImageSpec spec(bitmap->width, bitmap->height, 3, TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    std::vector<unsigned char> rgb(size_t(bitmap->width) * bitmap->height * 3);
    for (size_t i = 0; i < rgb.size() / 3; i++)
        memcpy(&rgb[i * 3], &bitmap->rgba[i * 4], 3);
    return write_pixels(path, spec, TypeDesc::UINT8, rgb.data());
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool image_format_is_float(const char *path, bool *is_float) try {
    std::string extension = Filesystem::extension(path, false);
    if (extension.empty())
        return fail(path, "no extension, so no picture format (try .exr or .png)");
    if (extension != "pfm" && !ImageOutput::create(path)) {
        geterror(); /* drops OpenImageIO's long advice */
        return fail(path, "unknown picture format '." + extension + "' (try .exr or .png)");
    }
    *is_float =
        is_plain(extension) || extension == "exr" || extension == "tif" || extension == "tiff";
    return true;
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size) try {
    *bitmap = {};
    /* The format is told by its content; the name only has to have no known extension. */
    Filesystem::IOMemReader reader(const_cast<void *>(bytes), size);
    static const char *const formats[] = {"png", "jpeg", "webp", "bmp", "tga"};
    std::unique_ptr<ImageInput> in;
    ImageSpec spec;
    for (const char *format : formats) {
        in = ImageInput::create(format);
        if (in && in->set_ioproxy(&reader)) {
            reader.seek(0);
            if (in->open("texture", spec))
                break;
            in->geterror();
        }
        in.reset();
    }
    if (!in)
        return error_set("not a picture of a known format");
    if (!check_size(spec, "picture"))
        return false;
    std::vector<unsigned char> source(spec.image_pixels() * spec.nchannels);
    if (!in->read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT8, source.data()))
        return fail("picture", in->geterror());
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
