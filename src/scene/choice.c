#include "scene/choice.h"

#include "base/error.h"
#include "base/names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int find(const struct choice_list *list, const char *text) {
    char *end;
    long number = strtol(text, &end, 10);
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->names[i], text) == 0)
            return i;
    return !*end && number >= 0 && number < list->count ? (int)number : -1;
}

static void list_names(const struct choice_list *list, struct names *names) {
    for (int i = 0; i < list->count; i++) {
        char name[256];
        snprintf(name, sizeof name, "%d%s%s", i, *list->names[i] ? "=" : "", list->names[i]);
        names_add(names, " ", name);
    }
}

bool choice_set(struct choice_list *list, const char *noun, const char *text) {
    struct names names = {0};
    if (!text || !*text)
        return true;
    list->shown = find(list, text);
    list->is_chosen = list->shown >= 0;
    list_names(list, &names);
    return list->is_chosen ||
           error_set("no %s '%s' (there is: %s)", noun, text, list->count ? names.text : "none");
}

void choice_to_text(const struct choice_list *list, char text[CHOICE_TEXT_SIZE]) {
    *text = '\0';
    if (list->is_chosen)
        snprintf(text, CHOICE_TEXT_SIZE, "%d", list->shown);
}

void choice_free(struct choice_list *list) {
    for (int i = 0; i < list->count; i++)
        free(list->names[i]);
    free(list->names);
}
