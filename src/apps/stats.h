/* What --stats prints. */
#ifndef APPS_STATS_H
#define APPS_STATS_H

#include "renderer/renderer.h"

#include <stdio.h>

/* Faces, VPLs and VALs in use where there are any, GPU memory by object, ms per pass of the last
 * frame. */
void stats_print(FILE *out, struct renderer *renderer);

#endif
