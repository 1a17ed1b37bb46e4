/* The clips of a scene that play.
 *
 * By default all compatible clips play, so that a file with one clip for each object, as Blender
 * writes it, moves as a whole. Clips that move one target are alternatives, like walk and run of a
 * character: the first plays. Chosen clips all play, and the last one that moves a target wins. */
#ifndef SCENE_CLIPS_H
#define SCENE_CLIPS_H

#include "scene/scene.h"

/* Size of the text of clips_to_text. */
enum { CLIPS_TEXT_SIZE = 256 };

/* Plays the default clips. */
void clips_play_default(struct scene *scene);

/* Logs the clips that do not play by default, if any. */
void clips_note_left_out(const struct scene *scene);

/* Plays the clips of a list, names or numbers separated by commas; "all" or "": the default. Error:
 * no clip has this name; lists the clips. */
bool clips_select(struct scene *scene, const char *text);

bool clip_plays(const struct scene *scene, int n);

/* Returns the number of clips that play by default. */
int clips_default_count(const struct scene *scene);

/* Writes the choice in the form of clips_select; "": the default. It truncates long lists. */
void clips_to_text(const struct scene *scene, char text[CLIPS_TEXT_SIZE]);

#endif
