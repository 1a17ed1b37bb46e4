/* Sequences: which frames, and the files they go to. */
#ifndef APPS_FRAMES_H
#define APPS_FRAMES_H

#include <stdbool.h>

struct frames {
    int *numbers; /* in the order given */
    int count;
};

/* Parses "0..249", "1,5,9" or both mixed. Error: names the text and what is allowed. */
bool frames_parse(struct frames *frames, const char *text);
void frames_free(struct frames *frames);

/* Puts the numbers in order, and back into text that frames_parse reads; free() frees. False where one
 * is there twice, which is told. */
bool frames_sort(struct frames *frames, int *twice);
char *frames_text(const struct frames *frames);

/* Whether the name has a place for the frame's number: a run of '#'. */
bool frame_name_is_numbered(const char *name);

/* The name with its last run of '#' replaced by the number, with at least as many digits. free()
 * frees. */
char *frame_name(const char *name, int frame);

#endif
