/* Files that tests make byte by byte. */
#ifndef TEST_BYTES_H
#define TEST_BYTES_H

#include "support.h"

struct bytes {
    unsigned char data[32768];
    size_t size;
};

static inline void put(struct bytes *bytes, const void *from, size_t size) {
    assert_true(bytes->size + size <= sizeof bytes->data);
    memcpy(bytes->data + bytes->size, from, size);
    bytes->size += size;
}

#endif
