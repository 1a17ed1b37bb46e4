/* Draws what lies beside, over and below the picture: the panel, whose sections lie in panel_*.c,
 * text over the picture, and the bar of an animation. Handles keys and mouse. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include "viewer/state.h"
#include "viewer/window/ui.h"

void panel_draw(struct viewer *viewer);
void panel_draw_scene(struct viewer *viewer);
void panel_draw_technique(struct viewer *viewer);
void panel_draw_reference(struct viewer *viewer);
void panel_draw_compare(struct viewer *viewer);
void panel_draw_light(struct viewer *viewer);
void panel_draw_camera(struct viewer *viewer);

/* Draws the curves of a light that has a profile. */
void panel_draw_profile(const struct emitter *light);

/* Handles keys and mouse. The table of keys is also the help page. */
void controls_update(struct viewer *viewer, double seconds);
void controls_draw_help(void);

/* Draws the values of the pixel under the mouse: linear radiance of both pictures, and their
 * difference. */
void inspector_draw(struct viewer *viewer);

/* Returns the width of the times at the window's left edge, with margins, pixels. */
float overlay_width(const struct viewer *viewer);

/* Draws text over the picture: times, counts, memory, messages. */
void overlay_draw(struct viewer *viewer);

/* Returns the height of the animation's bar below the pictures, pixels. 0: there is no bar. */
float timeline_height(const struct viewer *viewer);

/* Draws the bar: time in seconds and frames, and buttons. */
void timeline_draw(struct viewer *viewer);

/* Pauses and steps by a number of frames. */
void timeline_step(struct viewer *viewer, int frames);

#endif
