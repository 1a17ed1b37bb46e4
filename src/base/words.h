/* Words with spaces or commas between.
 *
 *     for (struct word word = {.at = text}; word_next(&word);)
 *         printf("%.*s", word.length, word.at);
 */
#ifndef BASE_WORDS_H
#define BASE_WORDS_H

#include <stdbool.h>

/* At first the text, with no length. */
struct word {
    const char *at;
    int length;
};

/* False: it was the last one. */
bool word_next(struct word *word);

/* Whether that is the word. */
bool word_is(const struct word *word, const char *text);

#endif
