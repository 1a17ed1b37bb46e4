/* Parses the frames of a sequence and the names of their files. */
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

/* Sorts the numbers. Returns false, with the number in *twice, if one is there twice.
 * frames_text writes a text that frames_parse reads; the caller frees it. */
bool frames_sort(struct frames *frames, int *twice);
char *frames_text(const struct frames *frames);

/* Returns false if the name has a character of placeholders but no known placeholder:
 * "p.{frame}.png" would receive every frame of a farm. */
bool frame_name_is_plain(const char *name);

/* Returns true if the name has a placeholder of the frame's number: ####, @@@@, %04d, %d, $F4 or
 * $F. The last one counts. */
bool frame_name_is_numbered(const char *name);

/* Sets the error that the placeholder is not allowed, with the reason. Returns false. */
bool frame_name_refuse(const char *name, const char *reason);

/* Returns the name with the number, padded to the placeholder's digits. The caller frees it. */
char *frame_name(const char *name, int frame);

struct frame_rate {
    double fps;
    char text[40]; /* for ffmpeg */
};

/* Parses "25", "24000/1001", or 23.976, 29.97 and 59.94, which are rates of NTSC. Error: names the
 * text and what is allowed. */
bool frame_rate_parse(struct frame_rate *rate, const char *text);

#endif
