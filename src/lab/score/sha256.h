/* SHA-256 of bytes [FIPS 180-4 §6.2], to check that a file is the listed one. */
#ifndef LAB_SCORE_SHA256_H
#define LAB_SCORE_SHA256_H

#include <stdbool.h>
#include <stddef.h>

enum { SHA256_DIGITS = 64 };

/* Writes lower-case hexadecimal digits and a terminating zero. */
void sha256(const void *bytes, size_t size, char digits[SHA256_DIGITS + 1]);

/* Hashes a whole file. Error: it cannot be read. */
bool sha256_of_file(const char *path, char digits[SHA256_DIGITS + 1]);

#endif
