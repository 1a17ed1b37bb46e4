#include "scene/gpu/repeats.h"

#include "base/memory.h"

#include <stdlib.h>

/* A part that uses the indices of its twin. */
struct repeat {
    uint32_t first_index, index_count; /* in the geometry */
    uint32_t missing;                  /* indices of repeats before it */
    uint32_t stored;                   /* where its twin's are stored */
    int32_t base;
};

static int compare_repeats(const void *a, const void *b) {
    uint32_t x = ((const struct repeat *)a)->first_index;
    uint32_t y = ((const struct repeat *)b)->first_index;
    return (x > y) - (x < y);
}

void repeats_init(struct repeats *repeats, const struct geometry *geometry) {
    const struct geometry_part *parts = geometry->parts;
    struct repeat *items = mem_alloc((size_t)geometry->part_count + 1, sizeof *items);
    uint32_t missing = 0;
    *repeats = (struct repeats){.items = items};
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &parts[i], *twin = &parts[part->twin];
        if (twin != part)
            items[repeats->count++] =
                (struct repeat){.first_index = part->first_index,
                                .index_count = part->index_count,
                                .stored = twin->first_index,
                                .base = (int32_t)(part->first_vertex - twin->first_vertex)};
    }
    qsort(items, (size_t)repeats->count, sizeof *items, compare_repeats);
    items[repeats->count].first_index = UINT32_MAX;
    for (int i = 0; i <= repeats->count; i++) {
        items[i].missing = missing;
        missing += items[i].index_count;
    }
    for (int i = 0; i < repeats->count; i++)
        items[i].stored = repeats_next(repeats, items[i].stored, UINT32_MAX).first;
}

void repeats_free(struct repeats *repeats) {
    free(repeats->items);
    *repeats = (struct repeats){0};
}

uint32_t repeats_missing(const struct repeats *repeats) {
    return repeats->items[repeats->count].missing;
}

/* Returns the first repeat that ends behind the index, or the last item. */
static const struct repeat *find(const struct repeats *repeats, uint32_t at) {
    int low = 0, high = repeats->count;
    while (low < high) {
        int middle = (low + high) / 2;
        const struct repeat *repeat = &repeats->items[middle];
        if (repeat->first_index + repeat->index_count <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return &repeats->items[low];
}

struct stored repeats_next(const struct repeats *repeats, uint32_t at, uint32_t end) {
    const struct repeat *repeat = find(repeats, at);
    bool is_in = at >= repeat->first_index;
    uint32_t stop = repeat->first_index + (is_in ? repeat->index_count : 0);
    uint32_t count = (end < stop ? end : stop) - at;
    return is_in ? (struct stored){repeat->stored + at - repeat->first_index, count, repeat->base}
                 : (struct stored){at - repeat->missing, count, 0};
}

void repeats_write(const struct repeats *repeats, const struct geometry *geometry, uint32_t first,
                   uint32_t count, const struct buffer *indices) {
    size_t size = sizeof *geometry->indices;
    struct stored stored;
    for (uint32_t at = first; at < first + count; at += stored.count) {
        stored = repeats_next(repeats, at, first + count);
        if (!stored.base)
            buffer_write(indices, stored.first * size, stored.count * size, geometry->indices + at);
    }
}
