/* Picture files written and checked, and textures decoded. No exception leaves it. */
#include "base/file/image_bridge.hpp"

extern "C" {
#include "base/file/output_file.h"
#include "base/file/webp.h"
}

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

using namespace OIIO;
using namespace bridge;

namespace {

/* What is written and read here; of the other formats that OpenImageIO knows, some lose what does
 * not fit on the disk without a word. */
struct format {
    const char *extension, *name;
    bool is_float;
    bool has_alpha;  /* not of WebP, whose encoder divides colours by alpha, whatever it is told */
    std::string end; /* the last bytes of a whole file, where the decoder does not miss them */
};

const format formats[] = {
    {"exr", "openexr", true, true, ""},
    {"tif", "tiff", true, true, ""},
    {"tiff", "tiff", true, true, ""},
    {"pfm", "pnm", true, false, ""},
    {"hdr", "hdr", true, false, ""},
    {"png", "png", false, true, "IEND\xAE\x42\x60\x82"},
    {"jpg", "jpeg", false, false, ""},
    {"jpeg", "jpeg", false, false, ""},
    {"webp", "webp", false, false, ""},
    {"bmp", "bmp", false, false, ""},
    {"tga", "targa", false, true, std::string("TRUEVISION-XFILE.", 18)},
    {"gif", "gif", false, false, ";"},
    {"jp2", "jpeg2000", false, false, ""},
    {"ppm", "pnm", false, false, ""},
    {"dpx", "dpx", false, false, ""},
};

/* NULL: there is none. */
const format *find_extension(const std::string &extension) {
    for (const format &f : formats)
        if (Strutil::iequals(extension, f.extension))
            return &f;
    return NULL;
}

std::string known_extensions() {
    std::string known;
    for (const format &f : formats)
        known += std::string(" .") + f.extension;
    return known;
}

/* Of names that do not tell theirs. */
const format *format_of_others;

/* NULL after an error. */
const format *find_format(const char *path) {
    std::string extension = Filesystem::extension(path, false);
    const format *known = find_extension(extension);
    if (known || format_of_others)
        return known ? known : format_of_others;
    fail(path, output_file_is_stdout(path) ? "standard output needs --format, such as png or exr"
               : extension.empty()         ? "no extension, so no picture format (try .exr or .png)"
                                           : "unknown picture format '." + extension +
                                         "' (known:" + known_extensions() + ")");
    return NULL;
}

/* Decodes all pixels and drops them. "" or the reason why that fails. */
std::string try_decode(ImageInput *in, const ImageSpec &spec) {
    std::vector<char> pixels(spec.image_bytes(true));
    bool good = in->read_image(0, 0, 0, spec.nchannels, TypeDesc::UNKNOWN, pixels.data());
    /* A cut JPEG is good, but for what is said of it. */
    std::string reason = in->geterror();
    return reason.empty() && !good ? "cannot be decoded" : reason;
}

bool ends_well(const char *path, const format &format) {
    std::string end(format.end.size(), ' ');
    uint64_t size = Filesystem::file_size(path);
    return end.empty() || (size > end.size() &&
                           Filesystem::read_bytes(path, &end[0], end.size(), size - end.size()) &&
                           end == format.end);
}

/* The file is made in memory, for some encoders end the program, or say nothing, when a file does
 * not take their bytes; and decoded again before it is written. */
bool write_pixels(const char *path, const char *format, const ImageSpec &spec, TypeDesc type,
                  const void *pixels) {
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
    return output_file_write(path, bytes.data(), bytes.size());
}

/* Portable float map, which OpenImageIO reads but does not write: a line each of kind, size and
 * byte order (negative: little endian), then rows of RGB from the bottom up. */
bool write_pfm(const char *path, int width, int height, const std::vector<float> &rgb) {
    std::string head = Strutil::sprintf("PF\n%d %d\n-1.0\n", width, height);
    std::vector<char> bytes(head.begin(), head.end());
    size_t row = size_t(width) * 3;
    for (int y = height - 1; y >= 0; y--) {
        const char *from = reinterpret_cast<const char *>(&rgb[y * row]);
        bytes.insert(bytes.end(), from, from + row * sizeof rgb[0]);
    }
    return output_file_write(path, bytes.data(), bytes.size());
}

/* Formats of floats that have no more than red, green and blue. */
bool is_plain(const format *format) {
    return strcmp(format->extension, "pfm") == 0 || strcmp(format->extension, "hdr") == 0;
}

bool write_plain(const struct image *image, const char *path, const format *format) {
    int channels[3];
    if (!image_find_layer(image, "", channels))
        return error_prefix("%s", path);
    size_t count = size_t(image->width) * image->height;
    std::vector<float> rgb(count * 3);
    for (size_t i = 0; i < rgb.size(); i++)
        rgb[i] = image->pixels[i / 3 * image->channel_count + channels[i % 3]];
    if (strcmp(format->extension, "pfm") == 0)
        return write_pfm(path, image->width, image->height, rgb);
    ImageSpec spec(image->width, image->height, 3, TypeDesc::FLOAT);
    return write_pixels(path, format->name, spec, TypeDesc::FLOAT, rgb.data());
}

bool is_colour(const std::string &name) {
    std::string last = name.substr(name.find_last_of('.') + 1);
    return last == "R" || last == "G" || last == "B" || last == "A";
}

/* Light is brighter now and then than a half can tell, which would be infinite. */
bool fits_half(const struct image *image, int channel) {
    const float max_half = 65504;
    size_t count = size_t(image->width) * image->height, step = image->channel_count;
    for (size_t i = 0; i < count; i++)
        if (std::fabs(image->pixels[i * step + channel]) > max_half)
            return false;
    return true;
}

bool is_half(const struct image *image) {
    for (int i = 0; i < image->channel_count; i++)
        if (is_colour(image->names[i]) && !fits_half(image, i))
            return false;
    return !image->passes;
}

} // namespace

extern "C" bool image_is_whole(const char *path) try {
    const format *format = find_format(path);
    if (!format)
        return false;
    if (file_is_stream(path) || !ends_well(path, *format))
        return fail(path, "ends too soon");
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

extern "C" bool image_size(const char *path, int size[2]) try {
    auto in = ImageInput::open(path);
    if (!in)
        return fail(path, geterror());
    size[0] = in->spec().width;
    size[1] = in->spec().height;
    return true;
} catch (const std::exception &error) {
    return fail(path, error.what());
}

static void add_attributes(ImageSpec &spec, const struct image *image) {
    for (int i = 0; i < image->attribute_count; i++) {
        const struct image_attribute &attribute = image->attributes[i];
        if (attribute.kind == IMAGE_TEXT)
            spec.attribute(attribute.name, attribute.text);
        else if (attribute.kind == IMAGE_NUMBER)
            spec.attribute(attribute.name, attribute.numbers[0]);
        else if (attribute.kind == IMAGE_CHROMATICITIES)
            spec.attribute(attribute.name, TypeDesc(TypeDesc::FLOAT, 8), attribute.numbers);
        else
            spec.attribute(attribute.name, TypeMatrix, attribute.numbers);
    }
}

extern "C" bool image_write(const struct image *image, const char *path) try {
    const format *format = find_format(path);
    if (!format)
        return false;
    if (is_plain(format))
        return write_plain(image, path, format);
    ImageSpec spec(image->width, image->height, image->channel_count, TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (int i = 0; i < image->channel_count; i++)
        spec.channelnames.push_back(image->names[i]);
    spec.attribute("DateTime", ""); /* else it is now, and no two files are alike */
    if (strcmp(format->name, "openexr") == 0) {
        spec.attribute("compression", "zip");
        bool half = is_half(image);
        for (const std::string &name : spec.channelnames)
            spec.channelformats.push_back(half && is_colour(name) ? TypeDesc::HALF
                                                                  : TypeDesc::FLOAT);
        add_attributes(spec, image);
        if (image->passes) {
            spec.attribute(passes_attribute, image->passes);
            spec.attribute(weight_attribute, float(image->weight));
        }
    }
    spec.alpha_channel = image_find_channel(image, "A");
    spec.z_channel = image_find_channel(image, "Z");
    return write_pixels(path, format->name, spec, TypeDesc::FLOAT, image->pixels);
} catch (const std::exception &error) {
    return fail(path, error.what());
}

/* Opaque pictures have no alpha channel, which would only surprise. */
static bool write_bitmap(const struct bitmap *bitmap, const char *path, int channels) {
    const format *format = find_format(path);
    if (!format)
        return false;
    ImageSpec spec(bitmap->width, bitmap->height, channels, TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    std::vector<unsigned char> pixels(size_t(bitmap->width) * bitmap->height * channels);
    for (size_t i = 0; i < pixels.size() / channels; i++)
        memcpy(&pixels[i * channels], &bitmap->rgba[i * 4], channels);
    return write_pixels(path, format->name, spec, TypeDesc::UINT8, pixels.data());
}

extern "C" bool bitmap_write(const struct bitmap *bitmap, const char *path) try {
    return write_bitmap(bitmap, path, 3);
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool bitmap_write_alpha(const struct bitmap *bitmap, const char *path) try {
    return image_format_has_alpha(path) && write_bitmap(bitmap, path, 4);
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool image_format_is_float(const char *path, bool *is_float) try {
    const format *format = find_format(path);
    if (!format)
        return false;
    *is_float = format->is_float;
    return true;
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool image_format_has_alpha(const char *path) try {
    const format *format = find_format(path);
    return format &&
           (format->has_alpha ||
            fail(path, std::string(format->extension) +
                           " is written without alpha, which png, tga, tif and exr have"));
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool image_name_holds_layers(const char *path) try {
    const format *format = find_format(path);
    return format && (strcmp(format->extension, "exr") == 0 ||
                      fail(path, "only EXR files (.exr) hold all layers"));
} catch (const std::exception &error) {
    return fail(path, error.what());
}

extern "C" bool image_name_tells_format(const char *path) try {
    return find_extension(Filesystem::extension(path, false)) != nullptr;
} catch (const std::exception &) {
    return false;
}

extern "C" bool image_set_format_of_others(const char *extension) try {
    format_of_others = find_extension(extension);
    return format_of_others || error_set("format: '%s' is not one of those known:%s", extension,
                                         known_extensions().c_str());
} catch (const std::exception &error) {
    return error_set("%s", error.what());
}

/* A picture in memory: the format is told by its content; the name only has to have no known
 * extension. */
static std::unique_ptr<ImageInput> open_texture(Filesystem::IOMemReader &reader, ImageSpec &spec) {
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

extern "C" bool bitmap_measure(const void *bytes, size_t size, uint64_t *memory) try {
    Filesystem::IOMemReader reader(const_cast<void *>(bytes), size);
    ImageSpec spec;
    if (!open_texture(reader, spec))
        return false;
    *memory = spec.image_pixels() * 28 / 3; /* RGBA8, and RGBA8 with MIP maps */
    return true;
} catch (const std::exception &error) {
    return error_set("%s", error.what());
}

/* Puts colours as stored in place of those times alpha, which OpenImageIO's WebP gives always. */
static bool restore_webp(std::vector<unsigned char> &rgba, const void *bytes, size_t size) {
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

extern "C" bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size) try {
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
