/* Which of a scene's clips play.
 *
 * By default all that go together: a file with a clip for each object, as Blender writes it, moves as a whole. Clips that
 * move the same thing are alternatives, as walk and run of a character are: the first of them plays. Clips that are chosen
 * all play, and the last that moves a thing moves it.
 */
#ifndef SCENE_CLIPS_H
#define SCENE_CLIPS_H

#include "scene/scene.h"

/* Room for clips_to_text. */
enum { CLIPS_TEXT_SIZE = 256 };

/* Lets those play that go together. */
void clips_play_default(struct scene *scene);

/* Notes which clips are left out by default, if any. */
void clips_note_left_out(const struct scene *scene);

/* Lets the clips of a list play, names or numbers and commas between; "all" or "" = the default. Error: lists the
 * clips when there is none such. */
bool clips_select(struct scene *scene, const char *text);

bool clip_plays(const struct scene *scene, int n);

/* How many of the clips play by default. */
int clips_default_count(const struct scene *scene);

/* The choice as clips_select reads it; "" = the default. Of long lists the beginning. */
void clips_to_text(const struct scene *scene, char text[CLIPS_TEXT_SIZE]);

#endif
