/* SHA-256 of bytes [FIPS 180-4 §6.2], which tells whether a file is the one that somebody lists. */
#ifndef LAB_SCORE_SHA256_H
#define LAB_SCORE_SHA256_H

#include <stdbool.h>
#include <stddef.h>

enum { SHA256_DIGITS = 64 };

/* Lower-case hexadecimal digits, and a zero behind them. */
void sha256(const void *bytes, size_t size, char digits[SHA256_DIGITS + 1]);

/* Of a whole file. Error: it cannot be read. */
bool sha256_of_file(const char *path, char digits[SHA256_DIGITS + 1]);

#endif
