#define _POSIX_C_SOURCE 200809L
#include "scene/cryptomatte.h"

#include "base/json.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RANKS = 6, LAYERS = 3 };

/* Name, first channel, part and attribute names of a layer; the key is the start of its name's
 * hash. */
#define LAYER(part, key)                                                                           \
    {                                                                                              \
        "crypto_" part, "crypto_" part "00.r", part, {                                             \
            "cryptomatte/" key "/name", "cryptomatte/" key "/hash",                                \
                "cryptomatte/" key "/conversion", "cryptomatte/" key "/manifest"                   \
        }                                                                                          \
    }

static const struct {
    const char *name, *first, *part, *keys[4];
} layers[LAYERS] = {LAYER("node", "aaf0e57"), LAYER("mesh", "c402fe7"),
                    LAYER("material", "bda530a")};

/* A layer of the image. */
struct matte {
    uint32_t *ids; /* of triangles */
    float *ranks;  /* of the first pixel */
};

static uint32_t rotate(uint32_t x, int bits) {
    return x << bits | x >> (32 - bits);
}

/* MurmurHash3_x86_32 with seed 0 [Appleby 2011]. */
static uint32_t hash_of(const char *text) {
    const unsigned char *bytes = (const unsigned char *)text;
    size_t length = strlen(text);
    uint32_t hash = 0;
    for (size_t i = 0; i < length; i += 4) {
        uint32_t word = 0;
        for (size_t b = 0; b < 4 && i + b < length; b++)
            word |= (uint32_t)bytes[i + b] << 8 * b;
        hash ^= rotate(word * 0xcc9e2d51U, 15) * 0x1b873593U;
        if (i + 4 <= length)
            hash = rotate(hash, 13) * 5 + 0xe6546b64U;
    }
    hash ^= (uint32_t)length;
    hash = (hash ^ hash >> 16) * 0x85ebca6bU;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35U;
    return hash ^ hash >> 16;
}

uint32_t cryptomatte_id(const char *name) {
    uint32_t hash = hash_of(name), exponent = hash >> 23 & 255;
    return exponent == 0 || exponent == 255 ? hash ^ 1U << 23 : hash;
}

/* Returns the id of each triangle, and tells the ids of all parts in the header. Parts without a
 * name get one by their number. */
static uint32_t *list_ids(const struct surface_view *view, int layer, struct image *image) {
    char *manifest = NULL, id[16], unnamed[32];
    size_t size = 0;
    uint32_t *ids = NULL, *numbers = surface_layer_numbers(view, layer), count = 0;
    struct json json = {.out = open_memstream(&manifest, &size)};
    json_open(&json, NULL, "{");
    for (const char *name; (name = surface_layer_id_name(view->scene, layer, (int)count));) {
        snprintf(unnamed, sizeof unnamed, "%s %u", layers[layer].part, ++count);
        name = *name ? name : unnamed;
        ids = mem_resize(ids, count + 1, sizeof *ids);
        ids[count] = cryptomatte_id(name);
        snprintf(id, sizeof id, "%08x", ids[count]);
        json_text(&json, name, id);
    }
    json_close(&json, "}");
    bool ok = json.out && fclose(json.out) == 0;
    const char *texts[] = {layers[layer].name, "MurmurHash3_32", "uint32_to_float32", manifest};
    for (int i = 0; i < (ok ? 4 : 3); i++)
        image_add_text(image, layers[layer].keys[i], texts[i]);
    for (uint32_t t = 0; t < view->geometry->index_count / 3; t++)
        numbers[t] = ids[numbers[t]];
    mem_free(manifest, ids);
    return numbers;
}

/* ranks: pairs of id and sample count. */
static void add_sample(float *ranks, uint32_t id) {
    for (float *rank = ranks; rank < ranks + 2 * RANKS; rank += 2) {
        if (rank[1] == 0)
            memcpy(rank, &id, sizeof id);
        if (memcmp(rank, &id, sizeof id) == 0) {
            rank[1]++;
            return;
        }
    }
}

/* Sorts by falling coverage. */
static int compare_ranks(const void *a, const void *b) {
    const float *x = a, *y = b;
    return x[1] != y[1] ? (x[1] < y[1] ? 1 : -1) : memcmp(x, y, sizeof *x);
}

bool cryptomatte_fill(const struct surface_view *view, struct image *image) {
    size_t pixels = (size_t)image->width * (size_t)image->height;
    size_t step = (size_t)image->channel_count;
    struct matte mattes[LAYERS];
    int count = 0;
    bool ok = true;
    for (int layer = 0; layer < LAYERS; layer++) {
        int channel = image_find_channel(image, layers[layer].first);
        if (channel >= 0)
            mattes[count++] = (struct matte){list_ids(view, layer, image), image->pixels + channel};
    }
    for (int s = 0; ok && count > 0 && s < view->samples; s++) {
        uint32_t *triangles = view->look(view->user, s);
        ok = triangles;
        for (size_t i = 0; ok && i < pixels; i++)
            for (int m = 0; triangles[i] && m < count; m++)
                add_sample(mattes[m].ranks + i * step, mattes[m].ids[triangles[i] - 1]);
        free(triangles);
    }
    for (int m = 0; m < count; m++) {
        for (float *ranks = mattes[m].ranks, *end = ranks + pixels * step; ranks < end;
             ranks += step) {
            qsort(ranks, RANKS, 2 * sizeof *ranks, compare_ranks);
            for (size_t r = 0; r < RANKS; r++)
                ranks[2 * r + 1] /= (float)view->samples;
        }
        free(mattes[m].ids);
    }
    return ok;
}
