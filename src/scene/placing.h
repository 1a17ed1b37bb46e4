/* Which camera and which lights, as text: names or numbers of those in the scene, and what is to be
 * different from them.
 *
 *     "0"   "Camera.001"   "eye=1,2,3 forward=0,0,-1"
 *     "Lamp,2"   "Lamp position=0,2,0 intensity=5,5,5; 2"   "0; +area position=0,2,0 size=1,1"
 *
 * Cameras have eye, forward, up, right, fov (radians, vertical) and extent (orthographic: half the
 * height); lights have position, direction, up, right, intensity, size (struct emitter's: "0.2,0"
 * makes points spheres and spots disks of that diameter), cone (a spot's: cosines of the half angles
 * to where it is bright, and to where it is dark) and type (spot, point, directional, area). Without right the frame is made of the
 * direction and of up; with it all are taken as they are, so that a text that was written here gives
 * the very same camera again. A camera's three are then at right angles to each other.
 *
 * Commas part the names of lights, semicolons lights with changes from others. A light whose name
 * has either, or "=", goes by its number in lists and with changes; alone the whole text may be its
 * name, as a camera's may. Changes without a name are of all lights. "emitters" stands for all
 * area lights, "sky" for the environment, which has no changes, where there are any. "+area" and the
 * other types add a light that the file does not have (emitter_new).
 */
#ifndef SCENE_PLACING_H
#define SCENE_PLACING_H

#include "scene/camera.h"
#include "scene/lights/emitter.h"

enum { PLACING_TEXT_SIZE = 512 };

/* text NULL: the scene's first. n, unless NULL: which of the scene's it is, or is made from. Error:
 * no such one, or a word that is not understood. */
bool camera_from_text(struct camera *camera, const struct scene *scene, const char *text,
                      double time, int *n);

/* text NULL: all of the scene's, in any case in its order, then those that were added. Takes the place of what emitters has,
 * zeroed or not. Error: as above; emitters stay as they are. */
bool emitters_from_text(struct emitters *emitters, const struct scene *scene, const char *text,
                        double time);

/* Whether the text names the lights that shine, by lights that the scene has or that are added: no further light
 * of the scene would shine. False for NULL and for changes of all lights. */
bool emitters_text_is_complete(const struct scene *scene, const char *text);

/* The number alone where the camera is just the scene's n-th. */
void camera_to_text(const struct camera *camera, const struct scene *scene, int n, double time,
                    char text[PLACING_TEXT_SIZE]);

/* Numbers alone where the lights are just the scene's. free() frees. */
char *emitters_to_text(const struct emitters *emitters, const struct scene *scene, double time);

#endif
