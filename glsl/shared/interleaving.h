/* An interleaving pattern [Segovia et al. 2006]: the pixels of one place in blocks of n x n are drawn
 * together, as a tile. */
#ifndef SHARED_INTERLEAVING_H
#define SHARED_INTERLEAVING_H

#include "shared/types.h"

struct interleaving {
    ivec2 tile; /* size, pixels */
    int n;      /* 1: a plain picture */
    int unused;
};
STD140_SIZE(interleaving, 16)

/* Lists of what gathers by itself, one a kind and place of the pattern, which has at most 8 x 8: pixels of each
 * level, and edge samples of pixels. */
#define PIXEL_LEVEL_EDGE 0   /* at an edge or a corner: two or three of four neighbours are like */
#define PIXEL_LEVEL_DETAIL 1 /* fewer are */
#define PIXEL_LEVELS 2
#define LIST_EDGE_SAMPLES 2 /* after the levels' */
#define LIST_KINDS 3
#define PIXEL_LISTS_MAX (64 * LIST_KINDS)

/* Of a draw of a tile, RECEIVERS: all pixels of its place in the pattern, those of a list, or all but those. */
#define RECEIVERS_ALL 0
#define RECEIVERS_ADAPTIVE 1
#define RECEIVERS_OTHERS 2

#endif
