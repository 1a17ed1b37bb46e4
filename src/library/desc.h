/* Descriptors of callers, which may be of an older or a newer header. */
#ifndef LIBRARY_DESC_H
#define LIBRARY_DESC_H

#include <stdbool.h>
#include <stddef.h>

/* Copies a descriptor, which begins with its size, to one of ours: members that it lacks are 0. NULL: all is 0. Error: its size
 * is none, or it has members that we do not know and that are not 0. */
bool desc_take(void *to, size_t size, const void *from, const char *name);

/* Element i of an array of such descriptors, whose size is that of the first. */
bool desc_take_element(void *to, size_t size, const void *array, size_t i, const char *name);

/* Fills the caller's struct as far as it reaches. Error: its size is none. */
bool desc_give(void *to, const void *from, size_t size, const char *name);

/* Error: names the member, its number and the range, whose ends belong to it. An infinite end allows any finite number. */
bool desc_check(const char *member, double number, double least, double most);

/* The same of several numbers. */
bool desc_check_all(const char *member, const float *numbers, int count, double least, double most);

/* The most that a share of 1 may be: computed ones are rounded. Messages print it as 1. */
#define SHARE_MOST 1.0001

#endif
