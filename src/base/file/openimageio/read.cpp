/* Pictures of files as floats: parts and channels by name, windows in place, the right way up. */
#include "base/file/openimageio/bridge.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

extern "C" {
#include "base/file/webp.h"
}

using namespace OIIO;
using namespace bridge;

namespace {

/* Of an EXR that is a mean of passes. */
const char passes_attribute[] = "manylight:passes", weight_attribute[] = "manylight:weight";

/* Finding layers among more names takes long. */
const int max_channels = 2048;

struct Part {
    int index; /* in the file */
    ImageSpec spec;
    int first; /* of its channels, among those of all parts */
};

struct Source {
    const char *path;
    std::vector<unsigned char> bytes; /* of a WebP with alpha: read from here */
    std::unique_ptr<Filesystem::IOMemReader> reader;
    std::unique_ptr<ImageInput> in;
    bool is_exr;
    std::vector<Part> parts;
    std::vector<std::string> names; /* of all channels */
    int orientation; /* as TIFF counts them: 1 is upright, 5 and more are transposed */
};

/* Neighbouring channels of one part. */
struct Run {
    const Part *part;
    int begin, end; /* in the part */
    int at;         /* in the picture */
};

/* --- the file --------------------------------------------------------------------------------- */

/* OpenImageIO's WebP has no way to leave alpha out of the colours. */
bool reopen_webp(Source &source) {
    struct file_bytes file;
    if (!file_read(&file, source.path))
        return false;
    source.bytes.assign(file.data, file.data + file.size);
    free(file.data);
    if (!webp_hide_alpha(source.bytes.data(), source.bytes.size()))
        return fail(source.path, "its alpha cannot be told from its colours");
    source.reader.reset(new Filesystem::IOMemReader(source.bytes.data(), source.bytes.size()));
    source.in = ImageInput::create("webp");
    ImageSpec spec;
    return source.in->set_ioproxy(source.reader.get()) && source.in->open(source.path, spec)
               ? true
               : fail(source.path, source.in->geterror());
}

std::string name_of(const ImageSpec &spec) {
    return std::string(spec.get_string_attribute("name"));
}

/* The reason why a part is left out, or "". */
std::string reason_against(const ImageSpec &spec, bool is_exr) {
    if (spec.deep)
        return "deep: its pixels have several depths";
    return is_exr && !spec.format.is_floating_point() ? "its channels are whole numbers" : "";
}

bool find_parts(Source &source) {
    const int count = source.in->spec().get_int_attribute("oiio:subimages", 1);
    std::string reason, left_out;
    for (int i = 0; i < (source.is_exr ? count : 1); i++) {
        bool opens = source.in->seek_subimage(i, 0);
        Part part = {i, opens ? source.in->spec() : ImageSpec(), 0};
        std::string against =
            opens ? reason_against(part.spec, source.is_exr) : source.in->geterror();
        if (opens && !check_size(part.spec, source.path))
            return false;
        if (opens && against.empty()) {
            source.parts.push_back(part);
            continue;
        }
        reason = against.substr(0, against.find('\n'));
        left_out += (left_out.empty() ? "" : ", ") +
                    (opens ? name_of(part.spec) : "part " + std::to_string(i));
    }
    if (source.parts.empty())
        return fail(source.path, reason);
    if (!left_out.empty())
        log_note("%s: left out: %s (%s)", source.path, left_out.c_str(), reason.c_str());
    return true;
}

/* PART.CHANNEL, where the file has parts and the channel's name does not begin so already. */
bool name_channels(Source &source) {
    for (Part &part : source.parts) {
        const std::string name = name_of(part.spec), prefix = name + ".";
        bool whole = part.spec.get_int_attribute("oiio:subimages", 1) < 2 || name.empty();
        part.first = int(source.names.size());
        if (part.first + part.spec.nchannels > max_channels)
            return fail(source.path, "more than " + std::to_string(max_channels) + " channels");
        for (int i = 0; i < part.spec.nchannels; i++) {
            std::string channel = part.spec.channel_name(i);
            if (!source.is_exr && part.spec.nchannels == 2) /* TGA calls them R and G */
                channel = i == 0 ? "Y" : "A";
            bool has_it = channel.compare(0, prefix.size(), prefix) == 0;
            source.names.push_back(whole || has_it ? channel : prefix + channel);
        }
    }
    return true;
}

/* Viewers show EXR as it is stored. */
int orientation_of(const ImageSpec &spec, const char *format) {
    int orientation = spec.get_int_attribute("Orientation", 1);
    bool is_known = orientation >= 1 && orientation <= 8 && strcmp(format, "openexr") != 0;
    return is_known ? orientation : 1;
}

/* Looked for in a second handle, for some readers do not find their way back. */
void tell_pages(const Source &source) {
    auto in = source.is_exr ? nullptr : ImageInput::open(source.path);
    if (in && in->seek_subimage(1, 0))
        log_note("%s: holds several pictures; the first is taken", source.path);
    if (in)
        in->geterror();
}

bool open_source(Source &source, const char *path) {
    source.path = path;
    if (!file_can_be_read(path))
        return false;
    const ImageSpec hints = as_stored();
    source.in = ImageInput::open(path, &hints);
    if (!source.in)
        return fail(path, geterror());
    if (strcmp(source.in->format_name(), "webp") == 0 && source.in->spec().nchannels == 4 &&
        !reopen_webp(source))
        return false;
    source.is_exr = strcmp(source.in->format_name(), "openexr") == 0;
    if (!find_parts(source) || !name_channels(source))
        return false;
    source.orientation = orientation_of(source.parts[0].spec, source.in->format_name());
    tell_pages(source);
    return true;
}

/* --- windows ---------------------------------------------------------------------------------- */

image_window data_window(const ImageSpec &spec) {
    return {spec.x, spec.y, spec.width, spec.height};
}

/* Formats that only tell where a picture lies, and not in which, tell of a place on paper. */
image_window display_window(const ImageSpec &spec, bool is_exr) {
    bool has_own = is_exr || spec.full_width != spec.width || spec.full_height != spec.height;
    return has_own ? image_window{spec.full_x, spec.full_y, spec.full_width, spec.full_height}
                   : data_window(spec);
}

bool is_same(const image_window &a, const image_window &b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

/* Where two windows overlap, in pixels of the first; empty where nowhere. */
ROI overlap(const image_window &of, const image_window &other) {
    int64_t x = int64_t(other.x) - of.x, y = int64_t(other.y) - of.y;
    auto within = [](int64_t value, int end) { return int(std::clamp<int64_t>(value, 0, end)); };
    return ROI(within(x, of.width), within(x + other.width, of.width), within(y, of.height),
               within(y + other.height, of.height), 0, 1);
}

bool is_inside(const image_window &data, const image_window &display) {
    ROI shown = overlap(display, data);
    return shown.width() == data.width && shown.height() == data.height;
}

std::string text_of(const image_window &window) {
    return std::to_string(window.width) + "x" + std::to_string(window.height) + " at " +
           std::to_string(window.x) + "," + std::to_string(window.y);
}

void tell_windows(const Source &source, const Part &part, const image_window &display) {
    image_window data = data_window(part.spec);
    if (is_same(data, display))
        return;
    ROI shown = overlap(display, data);
    std::string text = "its data window, " + text_of(data) + ", lies in the display window, " +
                       text_of(display) + "; the rest is black";
    if (shown.width() < 1 || shown.height() < 1)
        text = "black: its data window, " + text_of(data) + ", lies outside the display window, " +
               text_of(display);
    else if (!is_inside(data, display))
        text = "its data window, " + text_of(data) + ", is cut to the display window, " +
               text_of(display);
    log_note("%s: %s", source.path, text.c_str());
}

/* --- pixels ----------------------------------------------------------------------------------- */

/* Those channels, in order, as few runs. */
std::vector<Run> runs_of(const Source &source, const std::vector<int> &channels) {
    std::vector<Run> runs;
    for (size_t i = 0; i < channels.size(); i++) {
        const Part *part = &source.parts[0];
        for (const Part &other : source.parts)
            if (other.first <= channels[i])
                part = &other;
        int channel = channels[i] - part->first;
        if (!runs.empty() && runs.back().part == part && runs.back().end == channel)
            runs.back().end++;
        else
            runs.push_back({part, channel, channel + 1, int(i)});
    }
    return runs;
}

/* Straight into the picture, where that has room for all of it. */
bool read_inside(Source &source, const Run &run, const ROI &shown, struct image *image) {
    const stride_t pixel = stride_t(image->channel_count) * sizeof(float);
    return source.in->read_image(run.part->index, 0, run.begin, run.end, TypeDesc::FLOAT,
                                 image_at(image, shown.xbegin, shown.ybegin) + run.at, pixel,
                                 pixel * image->width);
}

bool read_cut(Source &source, const Run &run, const image_window &data, const ROI &shown,
              struct image *image) {
    const int count = run.end - run.begin;
    std::vector<float> pixels(size_t(data.width) * data.height * count);
    if (!source.in->read_image(run.part->index, 0, run.begin, run.end, TypeDesc::FLOAT,
                               pixels.data()))
        return false;
    const ROI from = overlap(data, image->display);
    for (int y = 0; y < shown.height(); y++)
        for (int x = 0; x < shown.width(); x++) {
            size_t at = size_t(from.ybegin + y) * data.width + from.xbegin + x;
            memcpy(image_at(image, shown.xbegin + x, shown.ybegin + y) + run.at,
                   &pixels[at * count], count * sizeof(float));
        }
    return true;
}

/* A cut JPEG is read, but for what is said of it. */
bool read_run(Source &source, const Run &run, struct image *image) {
    const image_window data = data_window(run.part->spec);
    const ROI shown = overlap(image->display, data);
    if (shown.width() < 1 || shown.height() < 1)
        return true;
    bool good = is_inside(data, image->display) ? read_inside(source, run, shown, image)
                                                : read_cut(source, run, data, shown, image);
    std::string reason = source.in->geterror();
    return (good && reason.empty()) || fail(source.path, reason);
}

/* Turns the picture upright: row 0 of what is stored is its bottom, say. */
void orient(struct image *image, int orientation) {
    if (orientation == 1)
        return;
    struct image upright = *image;
    const bool transposed = orientation >= 5;
    const bool from_right =
        orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool from_below =
        orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    if (transposed)
        std::swap(upright.width, upright.height);
    const size_t pixel = image->channel_count;
    upright.pixels = static_cast<float *>(
        mem_alloc(size_t(image->width) * image->height * pixel, sizeof(float)));
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            int to_x = transposed ? y : x, to_y = transposed ? x : y;
            to_x = from_right ? upright.width - 1 - to_x : to_x;
            to_y = from_below ? upright.height - 1 - to_y : to_y;
            memcpy(image_at(&upright, to_x, to_y), image_at(image, x, y), pixel * sizeof(float));
        }
    free(image->pixels);
    upright.data = upright.display = {0, 0, upright.width, upright.height};
    *image = upright;
}

/* OpenImageIO converts 64 MB of lines at once, or 256 where that is more, from a copy with all
 * channels of the part. */
uint64_t conversion_bytes(const ImageSpec &spec) {
    const uint64_t line = spec.scanline_bytes(true);
    return std::max<uint64_t>(uint64_t(1) << 26, 256 * line) + std::min(spec.height, 256) * line;
}

/* The picture and, where windows are cut or turned, a copy of as much. */
bool check_memory(const Source &source, const std::vector<Run> &runs, const image_window &display) {
    uint64_t bytes = 0, copy = 0, conversion = 0;
    const uint64_t pixels = uint64_t(display.width) * display.height;
    for (const Run &run : runs) {
        conversion = std::max(conversion, conversion_bytes(run.part->spec));
        const uint64_t pixel = (run.end - run.begin) * sizeof(float);
        bytes += pixels * pixel;
        if (!is_inside(data_window(run.part->spec), display))
            copy = std::max<uint64_t>(copy, run.part->spec.image_pixels() * pixel);
    }
    copy = source.orientation == 1 ? copy : std::max(copy, bytes);
    return mem_check(bytes + copy + conversion) ||
           error_prefix("%s: a picture of %dx%d with %d channels", source.path, display.width,
                        display.height, runs.back().at + runs.back().end - runs.back().begin);
}

void take_header(const Source &source, struct image *image) {
    const ImageSpec &spec = source.parts[0].spec;
    image->encoded = !spec.format.is_floating_point();
    const std::string passes = spec.get_string_attribute(passes_attribute);
    image->passes = passes.empty() ? NULL : mem_strdup(passes.c_str());
    image->weight = spec.get_float_attribute(weight_attribute);
    image->unit = spec.get_float_attribute("whiteLuminance");
    image->cube = spec.get_string_attribute("textureformat") == "CubeFace Environment";
    spec.getattribute("chromaticities", TypeDesc(TypeDesc::FLOAT, 8), image->primaries);
    if (source.names.size() == size_t(spec.nchannels))
        return;
    image->parts = static_cast<char **>(mem_alloc(source.parts.size(), sizeof *image->parts));
    for (const Part &part : source.parts)
        image->parts[image->part_count++] = mem_strdup(name_of(part.spec).c_str());
}

/* A file of few pixels asks for no more memory than 8192x8192 pixels take. */
bool check_display(const image_window &display, const ImageSpec &data, const char *path) {
    const uint64_t always = uint64_t(1) << 26, pixels = uint64_t(display.width) * display.height;
    if (!check_size(display.width, display.height, path))
        return false;
    return pixels <= always || pixels <= 16 * data.image_pixels() ||
           fail(path, "too large: a display window of " + text_of(display) +
                          " around a data window of " + text_of(data_window(data)));
}

/* Those channels of the file, ascending. */
bool read_channels(Source &source, const std::vector<int> &channels, struct image *image) {
    const std::vector<Run> runs = runs_of(source, channels);
    const Part &part = *runs[0].part;
    const image_window display = display_window(part.spec, source.is_exr);
    if (!check_display(display, part.spec, source.path))
        return false;
    for (const Run &run : runs)
        if (!is_same(display_window(run.part->spec, source.is_exr), display))
            return fail(source.path, "its parts have different display windows");
    if (!check_memory(source, runs, display))
        return false;
    std::vector<const char *> names;
    for (int channel : channels)
        names.push_back(source.names[channel].c_str());
    image_init_named(image, display.width, display.height, names.data(), int(names.size()));
    image->display = display;
    image->data = data_window(part.spec);
    take_header(source, image);
    for (size_t i = 0; i < runs.size(); i++) {
        if (!read_run(source, runs[i], image))
            return false;
        if (i == 0 || runs[i].part != runs[i - 1].part)
            tell_windows(source, *runs[i].part, display);
    }
    orient(image, source.orientation);
    return true;
}

/* Which channels of the file a layer is, by their names alone. */
bool find_layer(const Source &source, const char *layer, int channels[3]) {
    std::vector<const char *> names;
    for (const std::string &name : source.names)
        names.push_back(name.c_str());
    struct image all;
    image_init_named(&all, 1, 1, names.data(), int(names.size()));
    take_header(source, &all);
    bool ok = image_find_layer(&all, layer, channels) || error_prefix("%s", source.path);
    char *note = ok ? image_layer_note(&all, layer) : NULL;
    if (note)
        log_note("%s: %s", source.path, note);
    free(note);
    image_free(&all);
    return ok;
}

} // namespace

static bool read_all(Source &source, struct image *image) {
    std::vector<int> channels;
    for (size_t i = 0; i < source.names.size(); i++)
        channels.push_back(int(i));
    return read_channels(source, channels, image);
}

static bool read_layer(Source &source, struct image *image, const char *layer, int channels[3]) {
    if (!find_layer(source, layer, channels))
        return false;
    std::vector<int> sorted(channels, channels + 3);
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    for (int c = 0; c < 3; c++)
        channels[c] =
            int(std::lower_bound(sorted.begin(), sorted.end(), channels[c]) - sorted.begin());
    return read_channels(source, sorted, image);
}

bool bridge::read(struct image *image, const char *path, const char *layer, int channels[3]) try {
    *image = {};
    Source source;
    if (open_source(source, path) &&
        (layer ? read_layer(source, image, layer, channels) : read_all(source, image)))
        return true;
    image_free(image);
    return false;
} catch (const std::exception &error) {
    image_free(image);
    return fail(path, error.what());
}
