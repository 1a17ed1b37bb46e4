#define _DEFAULT_SOURCE
#include "fuzz/fuzz.h"

#include "base/file/image_file.h"
#include "metrics/layer.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* OpenImageIO goes by the name first. */
static const char *const formats[] = {"exr", "png", "hdr", "pfm", "jpg", "tif", "webp", "tga"};
enum { FORMAT_COUNT = sizeof formats / sizeof formats[0] };

static void read_texture(const uint8_t *bytes, size_t size) {
    struct bitmap bitmap;
    uint64_t memory;
    if (!bitmap_measure(bytes, size, &memory) || memory > 1 << 26 ||
        !bitmap_decode(&bitmap, bytes, size))
        return;
    bitmap_free(&bitmap);
}

/* One of both ways, for a file that claims 2 GiB takes long each time it is opened. */
static void read_picture(const char *path, bool whole) {
    struct image picture = {0};
    bool was_encoded;
    image_is_whole(path);
    if (whole ? image_read(&picture, path) : layer_read(&picture, path, "", &was_encoded))
        image_free(&picture);
}

void fuzz_picture(const uint8_t *bytes, size_t size) {
    if (size == 0)
        return;
    int format = bytes[0] % (FORMAT_COUNT + 1);
    if (format == FORMAT_COUNT) {
        read_texture(bytes + 1, size - 1);
        return;
    }
    char path[64];
    snprintf(path, sizeof path, "/tmp/manylight-fuzz-%d.%s", (int)getpid(), formats[format]);
    unlink(path);
    if (symlink(fuzz_file(bytes + 1, size - 1), path) != 0)
        abort();
    read_picture(path, size % 2 == 0);
    unlink(path);
}
