/* Files in formats that OpenImageIO alone writes, and the check of a file. No exception
 * leaves it. */
#include "base/file/openimageio/bridge.hpp"

#include <cstring>
#include <memory>
#include <vector>

using namespace OIIO;
using namespace bridge;

namespace {

/* Decodes all pixels and drops them. "" or the reason why that fails. */
std::string try_decode(ImageInput *in, const ImageSpec &spec) {
    std::vector<char> pixels(spec.image_bytes(true));
    bool good = in->read_image(0, 0, 0, spec.nchannels, TypeDesc::UNKNOWN, pixels.data());
    /* A cut JPEG is good, but for what is said of it. */
    std::string reason = in->geterror();
    return reason.empty() && !good ? "cannot be decoded" : reason;
}

/* The file is made in memory, for some encoders end the program, or say nothing, when a file does
 * not take their bytes; and decoded again. */
bool encode_pixels(struct file_bytes *file, const char *path, const char *format,
                   const ImageSpec &spec, TypeDesc type, const void *pixels) {
    std::vector<unsigned char> bytes;
    Filesystem::IOVecOutput writer(bytes);
    auto out = ImageOutput::create(format);
    if (!out)
        return fail(path, geterror());
    bool good =
        out->set_ioproxy(&writer) && out->open(path, spec) && out->write_image(type, pixels);
    std::string reason = out->geterror();
    if (!out->close() || !good || !reason.empty())
        return fail(path, reason.empty() ? "cannot be encoded" : reason);
    Filesystem::IOMemReader reader(bytes.data(), bytes.size());
    ImageSpec written;
    auto in = ImageInput::create(format);
    if (!in || !in->set_ioproxy(&reader) || !in->open(path, written))
        return fail(path, "was not encoded well: " + (in ? in->geterror() : geterror()));
    reason = try_decode(in.get(), written);
    if (!reason.empty() || written.width != spec.width || written.height != spec.height)
        return fail(path, "was not encoded well: " + reason);
    file->size = bytes.size();
    file->data = static_cast<unsigned char *>(mem_alloc(bytes.size(), 1));
    memcpy(file->data, bytes.data(), bytes.size());
    return true;
}

} // namespace

bool bridge::check(const char *path) try {
    auto in = ImageInput::open(path);
    if (!in)
        return fail(path, geterror());
    if (!check_size(in->spec(), path))
        return false;
    std::string reason = try_decode(in.get(), in->spec());
    return reason.empty() || fail(path, reason);
} catch (const std::exception &error) {
    return fail(path, error.what());
}

bool bridge::read_size(const char *path, int size[2]) try {
    auto in = ImageInput::open(path);
    if (!in)
        return fail(path, geterror());
    size[0] = in->spec().width;
    size[1] = in->spec().height;
    return true;
} catch (const std::exception &error) {
    return fail(path, error.what());
}

bool bridge::encode(struct file_bytes *file, const struct image *image, const char *path,
                    const char *format) try {
    ImageSpec spec(image->width, image->height, image->channel_count, TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (int i = 0; i < image->channel_count; i++)
        spec.channelnames.push_back(image->names[i]);
    spec.attribute("DateTime", ""); /* else it is now, and no two files are alike */
    spec.alpha_channel = image_find_channel(image, "A");
    spec.z_channel = image_find_channel(image, "Z");
    return encode_pixels(file, path, format, spec, TypeDesc::FLOAT, image->pixels);
} catch (const std::exception &error) {
    return fail(path, error.what());
}

/* Opaque pictures have no alpha channel, which would only surprise. */
bool bridge::encode_bitmap(struct file_bytes *file, const struct bitmap *bitmap, int channels,
                           const char *path, const char *format) try {
    ImageSpec spec(bitmap->width, bitmap->height, channels, TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    std::vector<unsigned char> pixels(size_t(bitmap->width) * bitmap->height * channels);
    for (size_t i = 0; i < pixels.size() / channels; i++)
        memcpy(&pixels[i * channels], &bitmap->rgba[i * 4], channels);
    return encode_pixels(file, path, format, spec, TypeDesc::UINT8, pixels.data());
} catch (const std::exception &error) {
    return fail(path, error.what());
}
