/* A driver of OpenGL that draws nothing, takes every shader and keeps the sources of all: which
 * shaders there are is then told without a GPU, in no time. */
#ifndef TEST_NULL_DRIVER_H
#define TEST_NULL_DRIVER_H

/* For context_adopt. */
void *null_driver_getproc(const char *name);

/* Each shader goes into a file of its own, FOLDER/NUMBER.vert and so on; the same text again goes
 * nowhere. */
void null_driver_keep(const char *folder);

/* How many files that was. */
int null_driver_count(void);

#endif
