#include "scene/gltf/accessor.h"

#include "base/error.h"

#include <assert.h>
#include <math.h>
#include <string.h>

size_t component_size(int component_type) {
    switch (component_type) {
    case COMPONENT_BYTE:
    case COMPONENT_UBYTE:
        return 1;
    case COMPONENT_SHORT:
    case COMPONENT_USHORT:
        return 2;
    case COMPONENT_UINT:
    case COMPONENT_FLOAT:
        return 4;
    default:
        return 0;
    }
}

/* glTF is little-endian, as every machine we build for. */
static uint32_t read_unsigned(const unsigned char *bytes, int type) {
    uint32_t value = 0;
    memcpy(&value, bytes, component_size(type));
    return value;
}

/* glTF 2.0, 3.6.2.2: signed integers map to max(c / 127, -1), so that zero is exact. */
static float read_float(const unsigned char *bytes, int type, bool normalized) {
    uint32_t bits = read_unsigned(bytes, type);
    switch (type) {
    case COMPONENT_BYTE:
        return normalized ? fmaxf((float)(int8_t)bits / 127, -1) : (float)(int8_t)bits;
    case COMPONENT_UBYTE:
        return normalized ? (float)bits / 255 : (float)bits;
    case COMPONENT_SHORT:
        return normalized ? fmaxf((float)(int16_t)bits / 32767, -1) : (float)(int16_t)bits;
    case COMPONENT_USHORT:
        return normalized ? (float)bits / 65535 : (float)bits;
    case COMPONENT_UINT:
        return normalized ? (float)(bits / 4294967295.) : (float)bits;
    default: {
        float value;
        memcpy(&value, &bits, sizeof value);
        return value;
    }
    }
}

/* The index of the i-th replaced element. */
static bool sparse_target(const struct accessor *accessor, size_t i, size_t *target) {
    int type = accessor->sparse_index_type;
    *target = read_unsigned(accessor->sparse_indices + i * component_size(type), type);
    if (*target < accessor->count)
        return true;
    return error_set("sparse index %zu is outside its %zu elements", *target, accessor->count);
}

static void read_element(const struct accessor *accessor, const unsigned char *bytes, int width,
                         float *out) {
    size_t size = component_size(accessor->component_type);
    for (int c = 0; c < width && c < accessor->components; c++)
        out[c] = bytes ? read_float(bytes + (size_t)c * size, accessor->component_type,
                                    accessor->normalized)
                       : 0;
}

bool accessor_read_floats(const struct accessor *accessor, int width, float *out) {
    for (size_t i = 0; i < accessor->count; i++)
        read_element(accessor, accessor->bytes ? accessor->bytes + i * accessor->stride : NULL,
                     width, out + i * (size_t)width);
    size_t packed = component_size(accessor->component_type) * (size_t)accessor->components;
    for (size_t i = 0, target; i < accessor->sparse_count; i++) {
        if (!sparse_target(accessor, i, &target))
            return false;
        read_element(accessor, accessor->sparse_values + i * packed, width,
                     out + target * (size_t)width);
    }
    return true;
}

bool accessor_read_indices(const struct accessor *accessor, uint32_t *out) {
    assert(accessor->components == 1);
    int type = accessor->component_type;
    for (size_t i = 0; i < accessor->count; i++)
        out[i] = accessor->bytes ? read_unsigned(accessor->bytes + i * accessor->stride, type) : 0;
    for (size_t i = 0, target; i < accessor->sparse_count; i++) {
        if (!sparse_target(accessor, i, &target))
            return false;
        out[target] = read_unsigned(accessor->sparse_values + i * component_size(type), type);
    }
    return true;
}
