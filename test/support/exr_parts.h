/* EXR files of one or several parts for tests, byte by byte: lines of floats. */
#ifndef TEST_EXR_PARTS_H
#define TEST_EXR_PARTS_H

#include "support.h"

#include "base/file/output_file.h"

#include <stdio.h>
#include <string.h>

struct exr_part {
    const char *name;     /* where there are several */
    const char *channels; /* "A B G R": in the order of their bytes */
    int data[4];          /* window: x, y, width, height */
    int display[4];
    float base; /* of its values */
};

struct exr_bytes {
    unsigned char data[32768];
    size_t size;
};

/* What a channel holds at a pixel of its windows: exact in floats, and each another. */
static inline float exr_value(const struct exr_part *part, int channel, int x, int y) {
    return part->base + (float)channel / 8 + (float)x / 256 + (float)y / 4096;
}

static inline void exr_put(struct exr_bytes *bytes, const void *from, size_t size) {
    assert_true(bytes->size + size <= sizeof bytes->data);
    memcpy(bytes->data + bytes->size, from, size);
    bytes->size += size;
}

static inline void exr_put_int(struct exr_bytes *bytes, int value) {
    exr_put(bytes, &value, 4);
}

static inline void exr_attribute(struct exr_bytes *bytes, const char *name, const char *type,
                                 const void *value, size_t size) {
    exr_put(bytes, name, strlen(name) + 1);
    exr_put(bytes, type, strlen(type) + 1);
    exr_put_int(bytes, (int)size);
    exr_put(bytes, value, size);
}

/* Appends the channels' list; their number. */
static inline int exr_channels(struct exr_bytes *list, const char *names) {
    int count = 0;
    for (const char *name = names; *name; count++) {
        size_t length = strcspn(name, " ");
        const int rest[4] = {2, 0, 1, 1}; /* float, not linear for sure, a sample for each pixel */
        exr_put(list, name, length);
        exr_put(list, "", 1);
        exr_put(list, rest, sizeof rest);
        name += length + (name[length] == ' ');
    }
    exr_put(list, "", 1);
    return count;
}

static inline void exr_window(struct exr_bytes *bytes, const char *name, const int window[4]) {
    const int corners[4] = {window[0], window[1],
                            (int)((unsigned)window[0] + (unsigned)window[2] - 1),
                            (int)((unsigned)window[1] + (unsigned)window[3] - 1)};
    exr_attribute(bytes, name, "box2i", corners, sizeof corners);
}

static inline int exr_header(struct exr_bytes *bytes, const struct exr_part *part, bool several) {
    static const float one = 1, center[2];
    static const char type[] = "scanlineimage";
    struct exr_bytes list = {.size = 0};
    int count = exr_channels(&list, part->channels);
    exr_attribute(bytes, "channels", "chlist", list.data, list.size);
    exr_attribute(bytes, "compression", "compression", "", 1);
    exr_window(bytes, "dataWindow", part->data);
    exr_window(bytes, "displayWindow", part->display);
    exr_attribute(bytes, "lineOrder", "lineOrder", "", 1);
    exr_attribute(bytes, "pixelAspectRatio", "float", &one, 4);
    exr_attribute(bytes, "screenWindowCenter", "v2f", center, 8);
    exr_attribute(bytes, "screenWindowWidth", "float", &one, 4);
    if (several) {
        exr_attribute(bytes, "name", "string", part->name, strlen(part->name));
        exr_attribute(bytes, "type", "string", type, strlen(type));
        exr_attribute(bytes, "chunkCount", "int", &part->data[3], 4);
    }
    exr_put(bytes, "", 1);
    return count;
}

static inline void exr_line(struct exr_bytes *bytes, const struct exr_part *part, int channels,
                            int y) {
    exr_put_int(bytes, y);
    exr_put_int(bytes, channels * part->data[2] * 4);
    for (int c = 0; c < channels; c++)
        for (int x = 0; x < part->data[2]; x++) {
            float value = exr_value(part, c, part->data[0] + x, y);
            exr_put(bytes, &value, 4);
        }
}

/* The path stays valid as scratch's does. */
static inline const char *exr_write(const char *name, const struct exr_part *parts, int count) {
    static struct exr_bytes bytes;
    int channels[8];
    bytes.size = 0;
    exr_put_int(&bytes, 20000630);
    exr_put_int(&bytes, count > 1 ? 0x1002 : 2);
    for (int p = 0; p < count; p++)
        channels[p] = exr_header(&bytes, &parts[p], count > 1);
    if (count > 1)
        exr_put(&bytes, "", 1);
    uint64_t at = bytes.size;
    for (int p = 0; p < count; p++)
        at += 8 * (uint64_t)parts[p].data[3];
    for (int p = 0; p < count; p++)
        for (int y = 0; y < parts[p].data[3]; y++) {
            exr_put(&bytes, &at, 8);
            at += (count > 1 ? 12 : 8) + (uint64_t)(channels[p] * parts[p].data[2] * 4);
        }
    for (int p = 0; p < count; p++)
        for (int y = 0; y < parts[p].data[3]; y++) {
            if (count > 1)
                exr_put_int(&bytes, p);
            exr_line(&bytes, &parts[p], channels[p], parts[p].data[1] + y);
        }
    const char *path = scratch(name);
    check_ok(path, output_file_write(path, bytes.data, bytes.size));
    return path;
}

#endif
