/* The scene and the material variant of a file to show. */
#ifndef SCENE_CHOICE_H
#define SCENE_CHOICE_H

#include <stdbool.h>

/* The user's choice, each by name or number; NULL or "": the file's default. */
struct scene_choice {
    const char *scene, *variant;
};

/* Names in the file's order. */
struct choice_list {
    char **names;
    int count;
    int shown;      /* -1: none */
    bool is_chosen; /* chosen by the user */
};

/* Selects the item that `text` names. Error: no item has this name; lists the names after
 * `noun`. */
bool choice_set(struct choice_list *list, const char *noun, const char *text);

/* Writes the choice in the form of choice_set; "": the default. */
enum { CHOICE_TEXT_SIZE = 12 };
void choice_to_text(const struct choice_list *list, char text[CHOICE_TEXT_SIZE]);

void choice_free(struct choice_list *list);

#endif
