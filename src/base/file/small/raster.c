#include "base/file/small/small.h"

#include "base/error.h"
#include "base/memory.h"

bool check_picture_size(int64_t width, int64_t height) {
    const int64_t max_pixels = (int64_t)1 << 28;
    if (width < 1 || height < 1)
        return error_set("not a two-dimensional picture");
    return (width <= max_pixels && height <= max_pixels / width) ||
           error_set("too large: %lldx%lld", (long long)width, (long long)height);
}

void raster_free(struct raster *raster) {
    mem_free(raster->wide, raster->narrow);
    *raster = (struct raster){0};
}

size_t raster_count(const struct raster *raster) {
    return (size_t)raster->width * (size_t)raster->height * (size_t)raster->channels;
}

/* Room also for the copy that the caller makes: four channels of 8 bits. */
bool raster_alloc(struct raster *raster) {
    size_t count = raster_count(raster), size = raster->is_wide ? sizeof(uint16_t) : 1;
    size_t copy = count / (size_t)raster->channels * 4;
    if (!mem_check(count * size + copy))
        return error_prefix("a picture of %dx%d", raster->width, raster->height);
    if (raster->is_wide)
        raster->wide = mem_alloc(count, size);
    else
        raster->narrow = mem_alloc(count, size);
    return true;
}

unsigned char raster_byte(const struct raster *raster, size_t sample) {
    enum { WIDE_MAX = 65535, BYTE_MAX = 255 };
    if (!raster->is_wide)
        return raster->narrow[sample];
    return (unsigned char)((raster->wide[sample] * (uint32_t)BYTE_MAX + WIDE_MAX / 2) / WIDE_MAX);
}
