/* passes/lights/bounce.h to its shaders. */
#ifndef SHARED_BOUNCE_H
#define SHARED_BOUNCE_H

/* Rows of the sums: each adds up a part of the VPLs, so that few points keep many threads at work. */
#define BOUNCE_ROWS 16

/* Each point is picked from so many; they are contiguous. */
#define BOUNCE_CANDIDATES 16

#endif
