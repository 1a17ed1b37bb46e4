/* The picture beside a reference: from a file, or traced of this view. */
#ifndef VIEWER_COMPARING_H
#define VIEWER_COMPARING_H

#include "viewer/state.h"

/* Error: shown, too. */
bool viewer_load_reference(struct viewer *viewer, const char *path);

/* Compares with the reference there is, in its size; or makes the picture as large as the window
 * again: the reference and its chart stay, for viewer_compare_reference. */
void viewer_compare_reference(struct viewer *viewer);
void viewer_fill_window(struct viewer *viewer);

/* After each frame: a new reference is taken to be of the view that it is first measured against */
void viewer_note_reference_view(struct viewer *viewer);

/* Whether the picture has the reference's size; and whether it is of what the reference is of: the
 * view that it was first compared with. */
bool viewer_has_reference_size(const struct viewer *viewer);
bool viewer_reference_fits(const struct viewer *viewer);

#endif
