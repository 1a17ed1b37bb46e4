/* Prints --stats. */
#ifndef APPS_STATS_H
#define APPS_STATS_H

#include "renderer/renderer.h"

#include <stdio.h>

/* Prints faces, VPLs and VALs in use (if any), GPU memory by object, and ms per pass of the last
 * frame. */
void stats_print(FILE *out, struct renderer *renderer);

#endif
