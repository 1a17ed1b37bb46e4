/* EXR files of one or several parts for tests, byte by byte: lines of floats. */
#ifndef TEST_EXR_PARTS_H
#define TEST_EXR_PARTS_H

#include "bytes.h"

#include "base/file/output_file.h"

struct exr_part {
    const char *name;     /* where there are several */
    const char *channels; /* "A B G R": in the order of their bytes */
    int data[4];          /* window: x, y, width, height */
    int display[4];
    float base; /* of its values */
    bool cube;  /* its envmap attribute says so */
};

/* What a channel holds at a pixel of its windows: exact in floats, and each another. */
static inline float exr_value(const struct exr_part *part, int channel, int x, int y) {
    return part->base + (float)channel / 8 + (float)x / 256 + (float)y / 4096;
}

static inline void put_int(struct bytes *bytes, int value) {
    put(bytes, &value, 4);
}

static inline void put_attribute(struct bytes *bytes, const char *name, const char *type,
                                 const void *value, size_t size) {
    put(bytes, name, strlen(name) + 1);
    put(bytes, type, strlen(type) + 1);
    put_int(bytes, (int)size);
    put(bytes, value, size);
}

/* Appends the channels' list; their number. */
static inline int exr_channels(struct bytes *list, const char *names) {
    int count = 0;
    for (const char *name = names; *name; count++) {
        size_t length = strcspn(name, " ");
        const int rest[4] = {2, 0, 1, 1}; /* float, not linear for sure, a sample for each pixel */
        put(list, name, length);
        put(list, "", 1);
        put(list, rest, sizeof rest);
        name += length + (name[length] == ' ');
    }
    put(list, "", 1);
    return count;
}

static inline void exr_window(struct bytes *bytes, const char *name, const int window[4]) {
    const int corners[4] = {window[0], window[1],
                            (int)((unsigned)window[0] + (unsigned)window[2] - 1),
                            (int)((unsigned)window[1] + (unsigned)window[3] - 1)};
    put_attribute(bytes, name, "box2i", corners, sizeof corners);
}

static inline int exr_header(struct bytes *bytes, const struct exr_part *part, bool several) {
    static const float one = 1, center[2];
    static const char type[] = "scanlineimage";
    struct bytes list = {.size = 0};
    int count = exr_channels(&list, part->channels);
    put_attribute(bytes, "channels", "chlist", list.data, list.size);
    put_attribute(bytes, "compression", "compression", "", 1);
    exr_window(bytes, "dataWindow", part->data);
    exr_window(bytes, "displayWindow", part->display);
    if (part->cube)
        put_attribute(bytes, "envmap", "envmap", "\1", 1);
    put_attribute(bytes, "lineOrder", "lineOrder", "", 1);
    put_attribute(bytes, "pixelAspectRatio", "float", &one, 4);
    put_attribute(bytes, "screenWindowCenter", "v2f", center, 8);
    put_attribute(bytes, "screenWindowWidth", "float", &one, 4);
    if (several) {
        put_attribute(bytes, "name", "string", part->name, strlen(part->name));
        put_attribute(bytes, "type", "string", type, strlen(type));
        put_attribute(bytes, "chunkCount", "int", &part->data[3], 4);
    }
    put(bytes, "", 1);
    return count;
}

static inline void exr_line(struct bytes *bytes, const struct exr_part *part, int channels, int y) {
    put_int(bytes, y);
    put_int(bytes, channels * part->data[2] * 4);
    for (int c = 0; c < channels; c++)
        for (int x = 0; x < part->data[2]; x++) {
            float value = exr_value(part, c, part->data[0] + x, y);
            put(bytes, &value, 4);
        }
}

/* The path stays valid as scratch's does. */
static inline const char *exr_write(const char *name, const struct exr_part *parts, int count) {
    static struct bytes bytes;
    int channels[8];
    bytes.size = 0;
    put_int(&bytes, 20000630);
    put_int(&bytes, count > 1 ? 0x1002 : 2);
    for (int p = 0; p < count; p++)
        channels[p] = exr_header(&bytes, &parts[p], count > 1);
    if (count > 1)
        put(&bytes, "", 1);
    uint64_t at = bytes.size;
    for (int p = 0; p < count; p++)
        at += 8 * (uint64_t)parts[p].data[3];
    for (int p = 0; p < count; p++)
        for (int y = 0; y < parts[p].data[3]; y++) {
            put(&bytes, &at, 8);
            at += (count > 1 ? 12 : 8) + (uint64_t)(channels[p] * parts[p].data[2] * 4);
        }
    for (int p = 0; p < count; p++)
        for (int y = 0; y < parts[p].data[3]; y++) {
            if (count > 1)
                put_int(&bytes, p);
            exr_line(&bytes, &parts[p], channels[p], parts[p].data[1] + y);
        }
    const char *path = scratch(name);
    check_ok(path, output_file_write(path, bytes.data, bytes.size));
    return path;
}

#endif
