/* Steps through words separated by spaces or commas.
 *
 *     for (struct word word = {.at = text}; word_next(&word);)
 *         printf("%.*s", word.length, word.at);
 */
#ifndef BASE_WORDS_H
#define BASE_WORDS_H

#include <stdbool.h>

/* Starts as the text, with length 0. */
struct word {
    const char *at;
    int length;
};

/* Steps to the next word. Returns false after the last. */
bool word_next(struct word *word);

/* True if the word equals the text. */
bool word_is(const struct word *word, const char *text);

#endif
