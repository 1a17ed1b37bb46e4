/* Scenes come and go, cameras and lights are chosen, animations play. */
#ifndef VIEWER_PLACED_H
#define VIEWER_PLACED_H

#include "viewer/state.h"

/* Places the scene's n-th camera, or one by its text. Error: it is not understood. */
void viewer_pick_camera(struct viewer *viewer, int n);
bool viewer_place_camera(struct viewer *viewer, const char *text);

/* Lights by a text. What it moves stays there. Error: it is not understood. */
bool viewer_place_lights(struct viewer *viewer, const char *text);

/* What a renderer of the document begins with, without camera and lights; and one of the scene as
 * it is placed. */
struct renderer_desc viewer_first_desc(const struct viewer *viewer,
                                       const struct document *document);
bool viewer_init_renderer(struct viewer *viewer, struct renderer *renderer);

/* Takes a renderer in place of the one before. */
void viewer_take_renderer(struct viewer *viewer, const struct renderer *renderer);

/* Begins the clips of that text (scene/clips.h). */
void viewer_pick_clips(struct viewer *viewer, const char *text);

/* The first of SESSION_VIEWS that is not taken, or the last. */
int views_free(const struct viewer *viewer);
void views_keep(struct viewer *viewer, int i);
void views_go(struct viewer *viewer, int i);

#endif
