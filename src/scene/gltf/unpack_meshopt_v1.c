/* Version 1 of meshopt's attribute streams, and the colour filter: KHR_meshopt_compression,
 * appendices A and B. */
#include "scene/gltf/unpack.h"

#include "base/error.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { GROUP = 16, BLOCK_ELEMENTS = 256, BLOCK_BYTES = 8192, LEAST_TAIL = 24 };
enum { CONTROL_ZERO = 2, CONTROL_LITERAL = 3 };
enum { CHANNEL_BYTES, CHANNEL_SHORTS, CHANNEL_XOR };

struct stream {
    const unsigned char *at, *end;
};

/* The next bytes; NULL = there are fewer. */
static const unsigned char *take(struct stream *stream, size_t size) {
    const unsigned char *bytes = stream->at;
    if ((size_t)(stream->end - bytes) < size)
        return NULL;
    stream->at += size;
    return bytes;
}

/* --- deltas ----------------------------------------------------------------------------------- */

/* One bit each from the lowest bit of a byte on; more bits each from the highest on. */
static unsigned bits_at(const unsigned char *bytes, int bits, int i) {
    int in_byte = 8 / bits, place = i % in_byte * bits;
    return bytes[i / in_byte] >> (bits == 1 ? place : 8 - bits - place) & ((1u << bits) - 1);
}

/* A delta that is all ones follows as a byte of its own. */
static bool read_group(struct stream *stream, int bits, unsigned char deltas[GROUP]) {
    const unsigned char *bytes = take(stream, (size_t)bits * GROUP / 8), *own;
    if (!bytes)
        return false;
    for (int i = 0; i < GROUP; i++) {
        deltas[i] = (unsigned char)(bits == 0 ? 0 : bits_at(bytes, bits, i));
        if (bits == 0 || bits == 8 || deltas[i] != (1u << bits) - 1)
            continue;
        if (!(own = take(stream, 1)))
            return false;
        deltas[i] = *own;
    }
    return true;
}

/* The deltas of one byte of all elements. */
static bool read_deltas(struct stream *stream, int control, size_t count, unsigned char *deltas) {
    static const int bits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
    const size_t groups = (count + GROUP - 1) / GROUP;
    const unsigned char *bytes = take(stream, control == CONTROL_LITERAL ? count
                                              : control == CONTROL_ZERO  ? 0
                                                                         : (groups + 3) / 4);
    if (!bytes)
        return false;
    if (control == CONTROL_ZERO)
        memset(deltas, 0, count);
    if (control == CONTROL_LITERAL)
        memcpy(deltas, bytes, count);
    for (size_t g = 0; control < CONTROL_ZERO && g < groups; g++)
        if (!read_group(stream, bits[control][bytes[g / 4] >> g % 4 * 2 & 3], deltas + g * GROUP))
            return false;
    return true;
}

static uint32_t unzigzag(uint32_t v) {
    return v & 1 ? ~(v >> 1) : v >> 1;
}

/* The four bytes of a channel after those before them. */
static uint32_t add_delta(uint32_t before, uint32_t delta, int mode, int turn) {
    uint32_t after = 0;
    int bits = mode == CHANNEL_BYTES ? 8 : 16;
    uint32_t mask = (1u << bits) - 1;
    if (mode == CHANNEL_XOR)
        return before ^ (delta >> turn | delta << (32 - turn) % 32);
    for (int at = 0; at < 32; at += bits)
        after |= (((before >> at) + unzigzag(delta >> at & mask)) & mask) << at;
    return after;
}

/* --- the stream ------------------------------------------------------------------------------- */

/* The last element read, and the mode of each four bytes. */
struct state {
    unsigned char last[BLOCK_ELEMENTS];
    const unsigned char *modes;
};

static void write_channel(struct state *state, size_t c, size_t count, size_t stride,
                          const unsigned char *deltas, size_t room, unsigned char *to) {
    for (size_t i = 0; i < count; i++) {
        uint32_t before, delta = 0;
        memcpy(&before, state->last + c * 4, sizeof before);
        for (size_t k = 0; k < 4; k++)
            delta |= (uint32_t)deltas[(c * 4 + k) * room + i] << 8 * k;
        before = add_delta(before, delta, state->modes[c] & 15, state->modes[c] >> 4);
        memcpy(state->last + c * 4, &before, sizeof before);
        memcpy(to + i * stride + c * 4, &before, sizeof before);
    }
}

static bool read_block(struct stream *stream, struct state *state, size_t count, size_t stride,
                       unsigned char *to) {
    unsigned char deltas[BLOCK_BYTES];
    const size_t room = (count + GROUP - 1) / GROUP * GROUP;
    const unsigned char *controls = take(stream, stride / 4);
    if (!controls)
        return false;
    for (size_t k = 0; k < stride; k++)
        if (!read_deltas(stream, controls[k / 4] >> k % 4 * 2 & 3, count, deltas + k * room))
            return false;
    for (size_t c = 0; c < stride / 4; c++)
        write_channel(state, c, count, stride, deltas, room, to);
    return true;
}

static bool check_modes(const unsigned char *modes, size_t count) {
    for (size_t c = 0; c < count; c++)
        if (modes[c] >> (modes[c] % 16 == CHANNEL_XOR ? 8 : 4) || modes[c] % 16 > CHANNEL_XOR)
            return false;
    return true;
}

bool unpack_meshopt_v1(const struct packed_view *view, unsigned char *to) {
    const size_t stride = view->stride, tail = stride + stride / 4;
    const size_t padded = tail < LEAST_TAIL ? LEAST_TAIL : tail;
    size_t most = BLOCK_BYTES / stride / GROUP * GROUP;
    struct state state;
    if (view->size < 1 + padded)
        return error_set("%zu bytes are no packed elements", view->size);
    const unsigned char *end = view->bytes + view->size;
    memcpy(state.last, end - tail, stride);
    state.modes = end - stride / 4;
    struct stream stream = {view->bytes + 1, end - padded};
    most = most < BLOCK_ELEMENTS ? most : BLOCK_ELEMENTS;
    bool good = check_modes(state.modes, stride / 4);
    for (size_t at = 0; good && at < view->count; at += most) {
        size_t left = view->count - at;
        good = read_block(&stream, &state, left < most ? left : most, stride, to + at * stride);
    }
    return (good && stream.at == stream.end) ||
           error_set("%zu bytes are no %zu packed elements", view->size, view->count);
}

/* --- the filter ------------------------------------------------------------------------------- */

static int component(const unsigned char *bytes, size_t size, size_t c, bool is_signed) {
    int value = size == 1 ? bytes[c] : bytes[2 * c] | bytes[2 * c + 1] << 8;
    int half = 1 << (8 * size - 1);
    return is_signed && value >= half ? value - 2 * half : value;
}

/* Luma, two differences of colour, and alpha below a bit that tells how many bits there are. */
static void decode_color(unsigned char *bytes, size_t size) {
    int y = component(bytes, size, 0, false), alpha = component(bytes, size, 3, false);
    int co = component(bytes, size, 1, true), cg = component(bytes, size, 2, true), scale = 1;
    while (scale < alpha)
        scale = 2 * scale + 1;
    int low = alpha & scale >> 1, most = size == 1 ? 255 : 65535;
    const int rgba[] = {y + co - cg, y + cg, y - co - cg, low << 1 | (low & 1)};
    for (size_t c = 0; c < 4; c++) {
        float value = roundf((float)rgba[c] * ((float)most / (float)scale));
        int number = (int)fminf(fmaxf(value, 0), (float)most);
        bytes[c * size] = (unsigned char)number;
        if (size == 2)
            bytes[2 * c + 1] = (unsigned char)(number >> 8);
    }
}

void unpack_meshopt_color(const struct packed_view *view, unsigned char *to) {
    for (size_t i = 0; i < view->count; i++)
        decode_color(to + i * view->stride, view->stride / 4);
}
