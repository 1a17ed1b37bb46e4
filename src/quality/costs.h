/* What frames of the choices between which --max-error and --budget choose cost on this machine, as `manylight tune` has
 * measured it and kept it in the user's cache.
 *
 * Only tune measures. All else reads the table, and goes by the costs that the program comes with where there is none: a
 * render never takes longer for it, and renders of one machine choose alike until its user asks for other figures.
 */
#ifndef QUALITY_COSTS_H
#define QUALITY_COSTS_H

#include "base/text.h"

#include <stdbool.h>

struct cost {
    char *choice; /* as measure_assign has it: "technique=clustered path=draft" */
    double ms;    /* of a frame; above 0 */
};

/* Zeroed: none. */
struct costs {
    struct cost *items;
    int count;
};

void costs_free(struct costs *costs);
void costs_add(struct costs *costs, const char *choice, double ms);

/* 0: there is none; also of NULL. technique NULL: the default. */
double costs_find(const struct costs *costs, const char *technique, const char *settings);

/* The text of a choice; the caller frees it. */
char *costs_choice(const char *technique, const char *settings);

/* All choices that a table must have, none of them twice, with no figures yet. */
void costs_list(struct costs *costs);

/* The file that holds this machine's, whether it exists or not; the caller frees the text. With a context. NULL: an
 * error, there is nowhere to keep things. */
char *costs_path(void);

/* The table of this machine, driver and program, with a context; none where there is no file. A note tells why a file is
 * ignored: it is of others, it is no table, or it lacks a choice. */
void costs_load(struct costs *costs);

/* Error: of the file. */
bool costs_write(const struct costs *costs, const char *path);

#endif
