/* Cameras and lights as text: names or numbers of the scene's, and changes to them.
 *
 *     "0"   "Camera.001"   "eye=1,2,3 forward=0,0,-1"
 *     "Lamp,2"   "Lamp position=0,2,0 intensity=5,5,5; 2"   "0; +area position=0,2,0 size=1,1"
 *
 * Cameras have eye, forward, up, right, fov (vertical, radians), extent (orthographic: half the
 * height), near, far, shift (struct camera); lens (camera_lens_names), skew, distortion (lens.h). A
 * pinhole's words set several of these at once: intrinsics=FX,FY,CX,CY,WIDTH,HEIGHT
 * (camera_set_intrinsics), and opencv= or opengl= with the 16 numbers of a pose (camera_set_pose).
 * Lights have position, direction, up, right, intensity, type (emitter_type_names), size (as in
 * struct emitter) and cone (spot: cosines of inner and outer half angle). Without `right`,
 * direction and up make the frame; with it they are used unchanged, so written text restores a
 * camera exactly. Commas separate names of lights, semicolons lights with changes. Names with
 * either, or with "=", need their number there. Changes without a name apply to all. "emitters":
 * all area lights. "sky": the environment. "+TYPE" adds a light (emitter_new). */
#ifndef SCENE_PLACING_H
#define SCENE_PLACING_H

#include "scene/camera.h"
#include "scene/lights/emitter.h"

enum { PLACING_TEXT_SIZE = 512 };

/* Makes a camera of the text; NULL: the scene's first. It writes the number of the camera it is
 * based on to *n, unless n is NULL. time: seconds. Error: unknown camera or word. */
bool camera_from_text(struct camera *camera, const struct scene *scene, const char *text,
                      double time, int *n);

/* Replaces `emitters` (zeroed or not) by the text's lights: the scene's in its order, then added
 * ones. NULL: all of the scene's. Error: unknown light or word; emitters stay unchanged. */
bool emitters_from_text(struct emitters *emitters, const struct scene *scene, const char *text,
                        double time);

/* True if the text names all lights that shine, so that no other light of the scene does. False for
 * NULL and for changes of all lights. */
bool emitters_text_is_complete(const struct scene *scene, const char *text);

/* Writes the camera as text: the number alone if it equals the scene's n-th. */
void camera_to_text(const struct camera *camera, const struct scene *scene, int n, double time,
                    char text[PLACING_TEXT_SIZE]);

/* Returns the lights as text, numbers alone if they equal the scene's. The caller frees it. */
char *emitters_to_text(const struct emitters *emitters, const struct scene *scene, double time);

#endif
