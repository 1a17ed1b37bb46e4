/* Renders the wanted picture and composes what is shown of it. */
#ifndef VIEWER_PICTURE_H
#define VIEWER_PICTURE_H

#include "viewer/state.h"

/* Text of `busy` while shaders are being compiled. */
extern const char busy_compiling[];

/* Writes the size of the picture at rest, pixels. */
void viewer_full_size(const struct viewer *viewer, int *width, int *height);

/* Renders and composes what has changed. Error: the scene cannot be drawn any more. */
bool viewer_update_picture(struct viewer *viewer);

/* Poses the scene at time 0, because casters are made there as in offscreen pictures, and back.
 * viewer_pose_start returns whether the scene was elsewhere, for viewer_pose_back. */
bool viewer_pose_start(struct viewer *viewer);
void viewer_pose_back(struct viewer *viewer, bool away);

/* Shows the picture with the wanted exposure and tone map, without rendering. */
void viewer_retone(struct viewer *viewer);

/* Returns the number of passes of a picture at rest. viewer_is_accumulating: some are missing. */
int viewer_passes(const struct viewer *viewer);
bool viewer_is_accumulating(const struct viewer *viewer);

/* Reads the shaders of the folder of --glsl again. */
void viewer_reload_shaders(struct viewer *viewer);

/* Shows LAYER_BEAUTY, LAYER_DIRECT or LAYER_INDIRECT. */
void viewer_show_layer(struct viewer *viewer, int layer);

/* Shows the next output (step 1) or the previous one (-1). The picture stands before the first. */
void viewer_step_output(struct viewer *viewer, int step);

/* Reads the surface at a place of the picture, 0 to 1, y down. */
void viewer_pick_surface(struct viewer *viewer, float x, float y);

/* Returns the pictures to draw into the window. Needs has_scene and shown.left. */
struct screen_pictures viewer_pictures(const struct viewer *viewer);

#endif
