/* Compares the picture with a reference: from a file, or traced of this view. */
#ifndef VIEWER_COMPARING_H
#define VIEWER_COMPARING_H

#include "viewer/state.h"

/* Loads a reference from a file. Error: also shown. */
bool viewer_load_reference(struct viewer *viewer, const char *path);

/* viewer_compare_reference compares with the present reference, at its size. viewer_fill_window
 * makes the picture as large as the window again and keeps the reference and its table. */
void viewer_compare_reference(struct viewer *viewer);
void viewer_fill_window(struct viewer *viewer);

/* Notes the view of a new reference: the view of its first comparison. Call it after each frame. */
void viewer_note_reference_view(struct viewer *viewer);

/* viewer_has_reference_size: the picture has the reference's size. viewer_reference_fits: the
 * picture has the view that the reference was first compared with. */
bool viewer_has_reference_size(const struct viewer *viewer);
bool viewer_reference_fits(const struct viewer *viewer);

#endif
