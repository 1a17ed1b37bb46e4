/* Sequences: which frames, and the files they go to. */
#ifndef APPS_FRAMES_H
#define APPS_FRAMES_H

#include <stdbool.h>

struct frames {
    int *numbers; /* in the order given */
    int count;
};

/* Parses "0..249", "0..100x5", "1,5,9" or all mixed. Error: names the text and what is allowed. */
bool frames_parse(struct frames *frames, const char *text);
void frames_free(struct frames *frames);

/* Puts the numbers in order, and back into text that frames_parse reads; free() frees. False where
 * one is there twice, which is told. */
bool frames_sort(struct frames *frames, int *twice);
char *frames_text(const struct frames *frames);

/* False if the file's name has a character of placeholders and none that is known: "p.{frame}.png"
 * would get every frame of a farm. */
bool frame_name_is_plain(const char *name);

/* Whether a part of the name stands for a frame's number: ####, @@@@, %04d, %d, $F4 or $F. The last
 * one counts. */
bool frame_name_is_numbered(const char *name);

/* Sets the error that the part is not to be there, and why; false. */
bool frame_name_refuse(const char *name, const char *reason);

/* The name with the number in that place, with at least as many digits. free() frees. */
char *frame_name(const char *name, int frame);

struct frame_rate {
    double fps;
    char text[40]; /* as ffmpeg reads it: "24000/1001" */
};

/* Parses "25", "24000/1001", or 23.976, 29.97 and 59.94, which are rates of NTSC. Error: names the
 * text and what is allowed. */
bool frame_rate_parse(struct frame_rate *rate, const char *text);

#endif
