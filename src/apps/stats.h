/* What --stats prints. */
#ifndef APPS_STATS_H
#define APPS_STATS_H

#include "renderer/renderer.h"

/* Faces, VPLs, VALs in use, GPU memory by object, ms per pass of the last frame, on stdout. */
void stats_print(struct renderer *renderer);

#endif
