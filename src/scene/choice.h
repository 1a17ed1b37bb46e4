/* Which of a file's scenes and material variants are shown. */
#ifndef SCENE_CHOICE_H
#define SCENE_CHOICE_H

#include <stdbool.h>

/* What the user asks for, each by name or number; NULL or "": the file's default. */
struct scene_choice {
    const char *scene, *variant;
};

/* Names in the file's order. */
struct choice_list {
    char **names;
    int count;
    int shown;      /* -1: none */
    bool is_chosen; /* by the user */
};

/* Shows the one that the text asks for. Error: lists the names of that noun when there is none such. */
bool choice_set(struct choice_list *list, const char *noun, const char *text);

/* The choice as choice_set reads it; "" = the default. */
enum { CHOICE_TEXT_SIZE = 12 };
void choice_to_text(const struct choice_list *list, char text[CHOICE_TEXT_SIZE]);

void choice_free(struct choice_list *list);

#endif
