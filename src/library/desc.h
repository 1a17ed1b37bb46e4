/* Reads and fills descriptors of callers compiled with an older or newer header. */
#ifndef LIBRARY_DESC_H
#define LIBRARY_DESC_H

#include <stdbool.h>
#include <stddef.h>

/* Copies a caller's descriptor, which begins with its size, into `to` of `size` bytes. Members that
 * it lacks become 0. from NULL: all 0. name: the struct's, for messages. Error: its size is
 * invalid, or it has nonzero members that this library does not know. */
bool desc_take(void *to, size_t size, const void *from, const char *name);

/* Copies element i of an array of descriptors, as desc_take. The first element states the size of
 * all. */
bool desc_take_element(void *to, size_t size, const void *array, size_t i, const char *name);

/* Copies into the caller's struct, as far as its size member reaches. Error: `to` is NULL or its
 * size is invalid. */
bool desc_give(void *to, const void *from, size_t size, const char *name);

/* Checks that a number is finite and in [least, most]; INFINITY sets no bound. Error: names member,
 * number and range. */
bool desc_check(const char *member, double number, double least, double most);

/* Checks each of count numbers. */
bool desc_check_all(const char *member, const float *numbers, int count, double least, double most);

/* True if all numbers are 0, which a caller leaves to the library. */
bool desc_is_zero(const float *numbers, int count);

/* Largest accepted value of a fraction: computed fractions may round above 1. Messages print 1. */
#define SHARE_MOST 1.0001

#endif
