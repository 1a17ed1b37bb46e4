/* EXR by the C library of OpenEXR: the files that this program writes, and others of that kind. */
#include "base/file/small/small.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <openexr.h>

#include <math.h>
#include <string.h>
#include <strings.h>

/* The initialisers of OpenEXR 3.4 leave fields out. */
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

/* Attributes of an EXR that is a mean of passes. */
static const char passes_attribute[] = "manylight:passes", weight_attribute[] = "manylight:weight";

/* That of OpenEXR's C++ library. The C library's default takes longer, for slightly
 * smaller files. */
static const int zip_level = 4;

/* Called under a lock of the file's, so that nothing can be asked of it. */
static void on_error(exr_const_context_t file, exr_result_t code, const char *message) {
    (void)file, (void)code;
    error_set("%s", message);
}

/* A library's call that did what it should. Its error is set already. */
static bool good(exr_result_t result) {
    return result == EXR_ERR_SUCCESS;
}

/* --- the file --------------------------------------------------------------------------------- */

struct source {
    exr_context_t file;
    const exr_attr_chlist_t *channels;
    exr_attr_box2i_t window;
    int width, height;
    int *order;         /* channels of the file in the order of their names here */
    const char **names; /* in that order */
    int count;
};

/* Layers by name; in a layer colours and alpha come first. */
static int place_of(const char *suffix) {
    static const char *const first[] = {"R", "Red", "G", "Green", "B", "Blue", "A", "Alpha"};
    int count = sizeof first / sizeof *first;
    for (int i = 0; i < count; i++)
        if (strcasecmp(suffix, first[i]) == 0)
            return i;
    return count;
}

static size_t layer_length(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot ? (size_t)(dot - name) + 1 : 0;
}

static int compare_names(const char *a, const char *b) {
    size_t a_length = layer_length(a), b_length = layer_length(b);
    int layers = strncmp(a, b, a_length < b_length ? a_length : b_length);
    if (layers != 0 || a_length != b_length)
        return layers != 0 ? layers : a_length < b_length ? -1 : 1;
    int places = place_of(a + a_length) - place_of(b + b_length);
    return places != 0 ? places : strcmp(a, b);
}

static int compare_entries(const void *a, const void *b) {
    const exr_attr_chlist_entry_t *const *left = a, *const *right = b;
    return compare_names((*left)->name.str, (*right)->name.str);
}

static void order_channels(struct source *source) {
    int count = source->channels->num_channels;
    const exr_attr_chlist_entry_t **sorted = mem_alloc((size_t)count, sizeof *sorted);
    source->order = mem_alloc((size_t)count, sizeof *source->order);
    source->names = mem_alloc((size_t)count, sizeof *source->names);
    source->count = count;
    for (int i = 0; i < count; i++)
        sorted[i] = source->channels->entries + i;
    qsort(sorted, (size_t)count, sizeof *sorted, compare_entries);
    for (int i = 0; i < count; i++) {
        source->order[i] = (int)(sorted[i] - source->channels->entries);
        source->names[i] = sorted[i]->name.str;
    }
    free(sorted);
}

static bool check_channels(const exr_attr_chlist_t *channels) {
    enum { MAX_CHANNELS = 2048 };
    if (channels->num_channels < 1 || channels->num_channels > MAX_CHANNELS)
        return error_set("%d channels, and not 1 to %d", channels->num_channels, MAX_CHANNELS);
    for (int i = 0; i < channels->num_channels; i++) {
        const exr_attr_chlist_entry_t *entry = channels->entries + i;
        if (entry->pixel_type == EXR_PIXEL_UINT && !image_channel_is_id(entry->name.str))
            return error_set("its channels are whole numbers");
        if (entry->x_sampling != 1 || entry->y_sampling != 1)
            return error_set("its channel '%s' has fewer samples than pixels, which this build "
                             "does not read",
                             entry->name.str);
    }
    return true;
}

static bool check_kind(exr_const_context_t file) {
    exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
    exr_compression_t compression = EXR_COMPRESSION_LAST_TYPE;
    int parts = 0;
    if (!good(exr_get_count(file, &parts)) || !good(exr_get_storage(file, 0, &storage)))
        return false;
    if (parts != 1)
        return error_set("%d parts, and this build reads EXR files of one", parts);
    if (storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED)
        return error_set("deep: its pixels have several depths");
    if (storage != EXR_STORAGE_SCANLINE)
        return error_set("an EXR file of tiles, which this build does not read");
    if (!good(exr_get_compression(file, 0, &compression)))
        return false;
    /* The library mixes up the lines of B44 whose channels are floats (3.1.5). */
    return compression < EXR_COMPRESSION_B44 ||
           error_set("compressed by B44 or DWA, which this build does not read");
}

static bool check_windows(struct source *source) {
    exr_attr_box2i_t display;
    const exr_attr_box2i_t *data = &source->window;
    if (!good(exr_get_data_window(source->file, 0, &source->window)) ||
        !good(exr_get_display_window(source->file, 0, &display)))
        return false;
    int64_t width = (int64_t)data->max.x - data->min.x + 1,
            height = (int64_t)data->max.y - data->min.y + 1;
    if (!check_picture_size(width, height))
        return false;
    source->width = (int)width;
    source->height = (int)height;
    return memcmp(&display, data, sizeof display) == 0 ||
           error_set("its data window is not its display window, which this build does not read");
}

static void close_source(struct source *source) {
    mem_free(source->order, source->names);
    exr_finish(&source->file);
}

static int64_t on_read(exr_const_context_t file, void *from, void *to, uint64_t size,
                       uint64_t offset, exr_stream_error_func_ptr_t on_failure) {
    const struct text *bytes = from;
    (void)file, (void)on_failure;
    if (offset >= bytes->length)
        return 0;
    size = size < bytes->length - offset ? size : bytes->length - offset;
    memcpy(to, bytes->data + offset, size);
    return (int64_t)size;
}

static int64_t on_size(exr_const_context_t file, void *from) {
    (void)file;
    return (int64_t)((const struct text *)from)->length;
}

/* Of bytes in memory, unless these are NULL. */
static bool open_source(struct source *source, const char *path, const struct text *bytes) {
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.error_handler_fn = on_error;
    if (bytes) {
        setup.user_data = (void *)(uintptr_t)bytes;
        setup.read_fn = on_read;
        setup.size_fn = on_size;
    }
    *source = (struct source){0};
    error_set("cannot be read");
    if (good(exr_start_read(&source->file, path, &setup)) && check_kind(source->file) &&
        check_windows(source) && good(exr_get_channels(source->file, 0, &source->channels)) &&
        check_channels(source->channels)) {
        order_channels(source);
        return true;
    }
    close_source(source);
    return false;
}

bool exr_read_size(const char *path, int size[2]) {
    struct source source;
    if (!open_source(&source, path, NULL))
        return false;
    size[0] = source.width;
    size[1] = source.height;
    close_source(&source);
    return true;
}

/* --- pixels ----------------------------------------------------------------------------------- */

/* Where the channels of a chunk go: at[i] is the channel of the picture, or -1. */
struct target {
    struct image *image; /* NULL where all are -1 */
    const int *at;
    int y;
};

/* A half's bits as a float of the same value. */
static float float_of(uint16_t half) {
    enum { FRACTION = 1 << 10, INFINITE = 31, BIAS = 15 };
    uint32_t sign = (uint32_t)(half & 0x8000) << 16, fraction = half % FRACTION;
    int exponent = half >> 10 & INFINITE;
    union {
        uint32_t bits;
        float value;
    } result;
    if (exponent == 0)
        return (sign ? -1.f : 1.f) * (float)fraction / (float)(1 << 24);
    result.bits = exponent == INFINITE
                      ? sign | 0x7f800000 | fraction << 13
                      : sign | (uint32_t)(exponent + 127 - BIAS) << 23 | fraction << 13;
    return result.value;
}

static void copy_line(float *to, int step, const uint8_t *from, int width, int type) {
    for (int x = 0; x < width; x++) {
        uint16_t half;
        uint32_t whole;
        if (type == EXR_PIXEL_UINT) {
            memcpy(&whole, from + 4 * x, 4);
            to[(size_t)x * (size_t)step] = (float)whole;
        } else if (type == EXR_PIXEL_HALF) {
            memcpy(&half, from + 2 * x, 2);
            to[(size_t)x * (size_t)step] = float_of(half);
        } else {
            memcpy(to + (size_t)x * (size_t)step, from + 4 * x, 4);
        }
    }
}

/* Lines of all channels, one after another. The library's own routine mixes channels up that are
 * read in another order than the file's. */
static exr_result_t unpack(exr_decode_pipeline_t *decode) {
    const struct target *target = decode->decoding_user_data;
    const uint8_t *from = decode->unpacked_buffer;
    for (int line = 0; line < decode->chunk.height; line++)
        for (int i = 0; i < decode->channel_count; i++) {
            const exr_coding_channel_info_t *channel = decode->channels + i;
            if (target->at[i] >= 0)
                copy_line(image_at(target->image, 0, target->y + line) + target->at[i],
                          target->image->channel_count, from, channel->width, channel->data_type);
            from += (size_t)channel->width * (size_t)channel->bytes_per_element;
        }
    return EXR_ERR_SUCCESS;
}

static bool read_chunk(const struct source *source, struct image *image, const int *at, int y) {
    struct target target = {image, at, y};
    exr_decode_pipeline_t decode = EXR_DECODE_PIPELINE_INITIALIZER;
    exr_chunk_info_t chunk;
    if (!good(exr_read_scanline_chunk_info(source->file, 0, source->window.min.y + y, &chunk)) ||
        !good(exr_decoding_initialize(source->file, 0, &chunk, &decode)))
        return false;
    bool ok = chunk.start_y == source->window.min.y + y && chunk.height <= source->height - y &&
              chunk.width == source->width;
    if (!ok)
        error_set("its lines are not where they should be");
    ok = ok && good(exr_decoding_choose_default_routines(source->file, 0, &decode));
    decode.unpack_and_convert_fn = unpack;
    decode.decoding_user_data = &target;
    ok = ok && good(exr_decoding_run(source->file, 0, &decode));
    exr_decoding_destroy(source->file, &decode);
    return ok;
}

/* Whether a picture made of this one has the attribute, too. */
static bool is_kept(const char *name) {
    static const char *const starts[] = {"manylight:", "cryptomatte/", "worldTo", "software",
                                         "comments"};
    bool kept = false;
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        kept |= strncmp(name, starts[i], strlen(starts[i])) == 0;
    return kept && strcmp(name, passes_attribute) != 0 && strcmp(name, weight_attribute) != 0;
}

static void take_attribute(const exr_attribute_t *from, struct image *image) {
    const char *name = from->name;
    bool kept = is_kept(name);
    switch (from->type) {
    case EXR_ATTR_STRING:
        if (strcmp(name, passes_attribute) == 0 && *from->string->str)
            image->passes = mem_strdup(from->string->str);
        if (kept)
            image_add_text(image, name, from->string->str);
        return;
    case EXR_ATTR_FLOAT:
        if (strcmp(name, weight_attribute) == 0)
            image->weight = from->f;
        if (strcmp(name, "whiteLuminance") == 0)
            image->unit = from->f;
        if (kept)
            image_add_numbers(image, name, IMAGE_NUMBER, &from->f);
        return;
    case EXR_ATTR_M44F:
        if (kept)
            image_add_numbers(image, name, IMAGE_MATRIX, from->m44f->m);
        return;
    default:
        if (from->type == EXR_ATTR_CHROMATICITIES && strcmp(name, "chromaticities") == 0)
            memcpy(image->primaries, from->chromaticities, sizeof image->primaries);
        if (from->type == EXR_ATTR_ENVMAP && strcmp(name, "envmap") == 0)
            image->cube = from->uc == EXR_ENVMAP_CUBE;
    }
}

_Static_assert(sizeof(exr_attr_chromaticities_t) == 8 * sizeof(float), "x and y of four colours");

static void take_attributes(const struct source *source, struct image *image) {
    const exr_attribute_t *attribute;
    int32_t count = 0;
    exr_get_attribute_count(source->file, 0, &count);
    for (int32_t i = 0; i < count; i++)
        if (good(exr_get_attribute_by_index(source->file, 0, EXR_ATTR_LIST_FILE_ORDER, i,
                                            &attribute)))
            take_attribute(attribute, image);
}

static bool read_lines(const struct source *source, struct image *image, const int *at) {
    int step = 0;
    bool ok = good(exr_get_scanlines_per_chunk(source->file, 0, &step)) && step > 0;
    for (int y = 0; ok && y < source->height; y += step)
        ok = read_chunk(source, image, at, y);
    return ok;
}

/* The places of channels that go nowhere, to be freed. */
static int *no_channels(const struct source *source) {
    int *at = mem_alloc((size_t)source->count, sizeof *at);
    for (int i = 0; i < source->count; i++)
        at[i] = -1;
    return at;
}

/* wanted: channels in the order of their names, ascending. */
static bool read_channels(const struct source *source, const int *wanted, int count,
                          struct image *image) {
    uint64_t pixels = (uint64_t)source->width * (uint64_t)source->height;
    uint64_t line = (uint64_t)source->width * (uint64_t)count * sizeof(float);
    if (!mem_check(pixels * (uint64_t)count * sizeof(float)))
        return error_prefix("a picture of %dx%d with %d channels", source->width, source->height,
                            count);
    if (line > INT32_MAX)
        return error_set("too large: lines of %llu bytes", (unsigned long long)line);
    const char **names = mem_alloc((size_t)count, sizeof *names);
    int *at = no_channels(source);
    for (int i = 0; i < count; i++) {
        names[i] = source->names[wanted[i]];
        at[source->order[wanted[i]]] = i;
    }
    image_init_named(image, source->width, source->height, names, count);
    image->display = image->data = (struct image_window){source->window.min.x, source->window.min.y,
                                                         source->width, source->height};
    take_attributes(source, image);
    error_set("cannot be decoded");
    bool ok = read_lines(source, image, at);
    mem_free(names, at);
    return ok;
}

/* All channels without pixels: what layers are found in. */
static struct image list_channels(const struct source *source) {
    struct image all;
    image_init_named(&all, 1, 1, source->names, source->count);
    return all;
}

/* The note of which layer was taken waits until the pixels are read: a file that is not goes to
 * another reader. */
static bool read_layer(const struct source *source, struct image *image, const char *path,
                       const char *layer, int channels[3]) {
    struct image all = list_channels(source);
    int wanted[3];
    bool ok = image_find_layer(&all, layer, channels) &&
              read_channels(source, wanted, sort_channels(channels, wanted), image);
    if (ok)
        tell_layer(&all, path, layer);
    image_free(&all);
    return ok;
}

static bool read_all(const struct source *source, struct image *image) {
    int *wanted = mem_alloc((size_t)source->count, sizeof *wanted);
    for (int i = 0; i < source->count; i++)
        wanted[i] = i;
    bool ok = read_channels(source, wanted, source->count, image);
    free(wanted);
    return ok;
}

bool exr_read(struct image *image, const char *path, const char *layer, int channels[3]) {
    struct source source;
    if (!open_source(&source, path, NULL))
        return false;
    bool ok = layer ? read_layer(&source, image, path, layer, channels) : read_all(&source, image);
    close_source(&source);
    if (!ok)
        image_free(image);
    return ok;
}

bool exr_check(const struct text *bytes, int size[2]) {
    struct source source;
    if (!open_source(&source, "picture", bytes))
        return false;
    int *nowhere = no_channels(&source);
    error_set("cannot be decoded");
    bool ok = read_lines(&source, NULL, nowhere);
    size[0] = source.width;
    size[1] = source.height;
    free(nowhere);
    close_source(&source);
    return ok;
}

/* --- writing ---------------------------------------------------------------------------------- */

static int64_t on_write(exr_const_context_t file, void *target, const void *bytes, uint64_t size,
                        uint64_t offset, exr_stream_error_func_ptr_t on_failure) {
    struct text *text = target;
    (void)file, (void)on_failure;
    size_t end = (size_t)(offset + size);
    while (text->length < offset) /* the library fills a table in later */
        text_append(text, "", 1);
    if (text->length < end)
        text_append(text, (const char *)bytes + (text->length - offset), end - text->length);
    memcpy(text->data + offset, bytes, size);
    return (int64_t)size;
}

static bool is_colour(const char *name) {
    const char *last = name + layer_length(name);
    return strlen(last) == 1 && strchr("RGBA", *last);
}

static bool fits_half(const struct image *image, int channel) {
    const float max_half = 65504;
    size_t count = (size_t)image->width * (size_t)image->height,
           step = (size_t)image->channel_count;
    for (size_t i = 0; i < count; i++)
        if (fabsf(image->pixels[i * step + (size_t)channel]) > max_half)
            return false;
    return true;
}

/* Light is brighter now and then than a half can tell, which would be infinite; means of passes are
 * added up. */
static bool is_half(const struct image *image) {
    for (int i = 0; i < image->channel_count; i++)
        if (is_colour(image->names[i]) && !fits_half(image, i))
            return false;
    return !image->passes;
}

static bool write_attribute(exr_context_t file, const struct image_attribute *attribute) {
    const float *numbers = attribute->numbers;
    exr_attr_chromaticities_t colours;
    exr_attr_m44f_t matrix;
    switch (attribute->kind) {
    case IMAGE_TEXT:
        return good(exr_attr_set_string(file, 0, attribute->name, attribute->text));
    case IMAGE_NUMBER:
        return good(exr_attr_set_float(file, 0, attribute->name, numbers[0]));
    case IMAGE_CHROMATICITIES:
        colours = (exr_attr_chromaticities_t){numbers[0], numbers[1], numbers[2], numbers[3],
                                              numbers[4], numbers[5], numbers[6], numbers[7]};
        return good(exr_attr_set_chromaticities(file, 0, attribute->name, &colours));
    case IMAGE_MATRIX:
        memcpy(matrix.m, numbers, sizeof matrix.m);
        return good(exr_attr_set_m44f(file, 0, attribute->name, &matrix));
    }
    return false;
}

static bool write_header(exr_context_t file, const struct image *image) {
    int part = 0;
    bool half = is_half(image),
         ok = good(exr_set_longname_support(file, 1)) &&
              good(exr_add_part(file, NULL, EXR_STORAGE_SCANLINE, &part)) &&
              good(exr_initialize_required_attr_simple(file, 0, image->width, image->height,
                                                       EXR_COMPRESSION_ZIP));
    for (int i = 0; ok && i < image->channel_count; i++) {
        bool narrow = half && is_colour(image->names[i]);
        exr_pixel_type_t type = image_channel_is_id(image->names[i]) ? EXR_PIXEL_UINT
                                : narrow                             ? EXR_PIXEL_HALF
                                                                     : EXR_PIXEL_FLOAT;
        ok = good(
            exr_add_channel(file, 0, image->names[i], type, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
    }
    for (int i = 0; ok && i < image->attribute_count; i++)
        ok = write_attribute(file, &image->attributes[i]);
    if (ok && image->passes)
        ok = good(exr_attr_set_string(file, 0, passes_attribute, image->passes)) &&
             good(exr_attr_set_float(file, 0, weight_attribute, (float)image->weight));
    return ok && good(exr_write_header(file));
}

static void aim_encoder(exr_encode_pipeline_t *encode, const struct image *image, int y) {
    const int32_t pixel = image->channel_count * (int32_t)sizeof(float);
    for (int i = 0; i < encode->channel_count; i++) {
        exr_coding_channel_info_t *channel = encode->channels + i;
        int at = image_find_channel(image, channel->channel_name);
        channel->encode_from_ptr = (const uint8_t *)(image_at(image, 0, y) + at);
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = sizeof(float);
        channel->user_pixel_stride = pixel;
        channel->user_line_stride = pixel * image->width;
    }
}

/* Chunks that are compressed side by side, and then written in order. */
struct batch {
    exr_context_t file;
    const struct image *image;
    int first, step; /* lines */
    exr_encode_pipeline_t *chunks;
    bool *ok;
};

/* In place of the library's routines, which would write at once and refuse a chunk before
 * its turn. */
static exr_result_t keep(exr_encode_pipeline_t *encode) {
    (void)encode;
    return EXR_ERR_SUCCESS;
}

static void compress_chunk(void *context, size_t i) {
    const struct batch *batch = context;
    exr_encode_pipeline_t *encode = batch->chunks + i;
    exr_chunk_info_t chunk;
    int y = batch->first + (int)i * batch->step;
    *encode = (exr_encode_pipeline_t)EXR_ENCODE_PIPELINE_INITIALIZER;
    batch->ok[i] = good(exr_write_scanline_chunk_info(batch->file, 0, y, &chunk)) &&
                   good(exr_encoding_initialize(batch->file, 0, &chunk, encode));
    if (!batch->ok[i])
        return;
    aim_encoder(encode, batch->image, y);
    batch->ok[i] = good(exr_encoding_choose_default_routines(batch->file, 0, encode));
    encode->yield_until_ready_fn = encode->write_fn = keep;
    batch->ok[i] = batch->ok[i] && good(exr_encoding_run(batch->file, 0, encode));
}

static bool write_batch(struct batch *batch, int count) {
    bool ok = true;
    parallel_for((size_t)count, 0, compress_chunk, batch);
    for (int i = 0; i < count; i++) {
        exr_encode_pipeline_t *encode = batch->chunks + i;
        ok = ok && batch->ok[i] &&
             good(exr_write_scanline_chunk(batch->file, 0, batch->first + i * batch->step,
                                           encode->compressed_buffer, encode->compressed_bytes));
        exr_encoding_destroy(batch->file, encode);
    }
    return ok;
}

static bool write_file(exr_context_t file, const struct image *image) {
    struct batch batch = {.file = file, .image = image};
    int together = parallel_core_count();
    bool ok = write_header(file, image) && good(exr_get_scanlines_per_chunk(file, 0, &batch.step));
    batch.chunks = mem_alloc((size_t)together, sizeof *batch.chunks);
    batch.ok = mem_alloc((size_t)together, sizeof *batch.ok);
    for (; ok && batch.first < image->height; batch.first += together * batch.step) {
        int left = (image->height - batch.first + batch.step - 1) / batch.step;
        ok = write_batch(&batch, left < together ? left : together);
    }
    mem_free(batch.chunks, batch.ok);
    return ok;
}

bool exr_write(struct text *text, const struct image *image) {
    exr_context_t file = NULL;
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    struct image named = *image;
    setup.error_handler_fn = on_error;
    setup.user_data = text;
    setup.write_fn = on_write;
    setup.zip_level = zip_level;
    error_set("cannot be encoded");
    /* The format has no channels without a name. */
    named.names = mem_alloc((size_t)image->channel_count, sizeof *named.names);
    for (int i = 0; i < image->channel_count; i++)
        named.names[i] =
            *image->names[i] ? mem_strdup(image->names[i]) : mem_printf("channel%d", i);
    bool ok = good(exr_start_write(&file, "picture", EXR_WRITE_FILE_DIRECTLY, &setup)) &&
              write_file(file, &named);
    ok = good(exr_finish(&file)) && ok;
    for (int i = 0; i < image->channel_count; i++)
        free(named.names[i]);
    free(named.names);
    return ok;
}
