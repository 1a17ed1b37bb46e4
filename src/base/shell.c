#include "base/shell.h"

#include "base/memory.h"
#include "base/text.h"

#include <string.h>

/* A single quote closes, escapes and opens. */
char *shell_quote(const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+=./,:@%";
    struct text quoted = {0};
    if (*word && word[strspn(word, plain)] == '\0')
        return mem_strdup(word);
    text_append(&quoted, "'", 1);
    for (const char *c = word; *c; c++)
        text_append(&quoted, *c == '\'' ? "'\\''" : c, *c == '\'' ? 4 : 1);
    text_append(&quoted, "'", 1);
    return quoted.data;
}
