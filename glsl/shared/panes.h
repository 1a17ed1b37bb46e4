/* What a pane's triangle has in the tree of panes. */
#ifndef SHARED_PANES_H
#define SHARED_PANES_H

#define PANE_COLOR_BITS 10
#define PANE_COLOR_MOST 1023
#define PANE_BOTH 0x40000000 /* beside the colour: backs reflect as fronts do */

#endif
