/* Draws the panel beside the picture. Its sections lie in panel_*.c. */
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

#endif
