#include "library/desc.h"

#include "base/error.h"
#include "library/door.h"

#include <math.h>
#include <string.h>

static bool read_size(size_t *size, const void *from, const char *name) {
    memcpy(size, from, sizeof *size);
    if (*size >= sizeof *size && *size < 1 << 16)
        return true;
    error_set("%s: its size is %zu: set it to the sizeof of the struct", name, *size);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

bool desc_take(void *to, size_t size, const void *from, const char *name) {
    return desc_take_element(to, size, from, 0, name);
}

bool desc_take_element(void *to, size_t size, const void *array, size_t i, const char *name) {
    size_t theirs;
    memset(to, 0, size);
    if (!array)
        return true;
    if (!read_size(&theirs, array, name))
        return false;
    const char *from = (const char *)array + i * theirs;
    for (size_t at = size; at < theirs; at++)
        if (from[at]) {
            error_set("%s: it is of a newer header than this library", name);
            return door_blame(MANYLIGHT_BAD_ARGUMENT);
        }
    memcpy(to, from, theirs < size ? theirs : size);
    return true;
}

bool desc_give(void *to, const void *from, size_t size, const char *name) {
    size_t theirs;
    if (!to) {
        error_set("%s: it is NULL", name);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    if (!read_size(&theirs, to, name))
        return false;
    memset((char *)to + sizeof theirs, 0, theirs - sizeof theirs);
    size_t given = theirs < size ? theirs : size;
    memcpy((char *)to + sizeof theirs, (const char *)from + sizeof theirs, given - sizeof theirs);
    return true;
}

bool desc_check(const char *member, double number, double least, double most) {
    if (!isfinite(number))
        return error_set("%s: %g is not finite", member, number);
    if (number >= least && number <= most)
        return true;
    return isinf(most) ? error_set("%s: %g is below %.4g", member, number, least)
                       : error_set("%s: %g is not from %.4g to %.4g", member, number, least, most);
}

bool desc_check_all(const char *member, const float *numbers, int count, double least,
                    double most) {
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = desc_check(member, (double)numbers[i], least, most);
    return ok;
}

bool desc_is_zero(const float *numbers, int count) {
    for (int i = 0; i < count; i++)
        if (numbers[i] != 0)
            return false;
    return true;
}
