/* Renders what is wanted and composes what is shown of it. */
#ifndef VIEWER_PICTURE_H
#define VIEWER_PICTURE_H

#include "viewer/state.h"

/* The sign that shaders are being compiled. */
extern const char busy_compiling[];

/* The size of the picture at rest. */
void viewer_full_size(const struct viewer *viewer, int *width, int *height);

/* Renders and composes what has changed. Error: the scene cannot be drawn any more. */
bool viewer_update_picture(struct viewer *viewer);

/* Casters are those of time 0, as a picture rendered offscreen has them: poses the scene there
 * before casters are made, and back. viewer_pose_start: whether it was elsewhere, for
 * viewer_pose_back. */
bool viewer_pose_start(struct viewer *viewer);
void viewer_pose_back(struct viewer *viewer, bool away);

/* Shows the picture in the exposure and tone map that are wanted: nothing is rendered for that. */
void viewer_retone(struct viewer *viewer);

/* How many passes a picture at rest is the mean of in the end; whether it is not yet. */
int viewer_passes(const struct viewer *viewer);
bool viewer_is_accumulating(const struct viewer *viewer);

/* Reads the shaders again, from the folder of --glsl. */
void viewer_reload_shaders(struct viewer *viewer);

/* Shows LAYER_BEAUTY, LAYER_DIRECT or LAYER_INDIRECT. */
void viewer_show_layer(struct viewer *viewer, int layer);

/* Shows the next output, or the one before; the picture stands before the first. */
void viewer_step_output(struct viewer *viewer, int step);

/* Reads what lies at a place of the picture, 0 to 1, y down. */
void viewer_pick_surface(struct viewer *viewer, float x, float y);

/* What is drawn into the window, where has_scene and left. */
struct screen_pictures viewer_pictures(const struct viewer *viewer);

#endif
