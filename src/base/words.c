#include "base/words.h"

#include <string.h>

static const char separators[] = " ,";

bool word_next(struct word *word) {
    word->at += word->length;
    word->at += strspn(word->at, separators);
    word->length = (int)strcspn(word->at, separators);
    return word->length > 0;
}

bool word_is(const struct word *word, const char *text) {
    return strlen(text) == (size_t)word->length && memcmp(word->at, text, strlen(text)) == 0;
}
