/* Places cameras, lights and animations of the scene. */
#ifndef VIEWER_PLACED_H
#define VIEWER_PLACED_H

#include "viewer/state.h"

/* Places the scene's camera n, or one by its text. Error: an invalid text. */
void viewer_pick_camera(struct viewer *viewer, int n);
bool viewer_place_camera(struct viewer *viewer, const char *text);

/* Sets the lights by a text. Lights that it moves stay there during animations. Error: an
 * invalid text. */
bool viewer_place_lights(struct viewer *viewer, const char *text);

/* viewer_first_desc returns the first desc of a document's renderer, without camera and lights.
 * viewer_init_renderer makes a renderer of the placed scene. */
struct renderer_desc viewer_first_desc(const struct viewer *viewer,
                                       const struct document *document);
bool viewer_init_renderer(struct viewer *viewer, struct renderer *renderer);

/* Takes ownership of a renderer in place of the one before. */
void viewer_take_renderer(struct viewer *viewer, const struct renderer *renderer);

/* Starts the clips of a text (scene/clips.h). */
void viewer_pick_clips(struct viewer *viewer, const char *text);

/* views_free returns the first free one of SESSION_VIEWS, or the last. views_keep stores the
 * camera as view i, views_go returns to it. */
int views_free(const struct viewer *viewer);
void views_keep(struct viewer *viewer, int i);
void views_go(struct viewer *viewer, int i);

#endif
