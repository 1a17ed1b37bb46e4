/* Spots with slides as projectors of Mitsuba: a square picture of all their light, the cone's falloff included. Directions
 * of a picture's texels are those of a perspective camera in place of the light. */
#ifndef APPS_EXPORT_SLIDES_H
#define APPS_EXPORT_SLIDES_H

#include "apps/export/target.h"

/* Whether the light is a spot whose slide covers its cone. */
bool export_is_projector(const struct emitter *emitter);

/* Across the picture, degrees. */
double export_projector_angle(const struct emitter *emitter);

/* W/sr that a white texel stands for: the largest channel of the intensity. */
float export_projector_peak(const struct emitter *emitter);

/* To be freed. */
char *export_projector_name(const struct emitter *emitter);

/* Writes the picture: intensity over the peak, times the cube of the cosine to the axis. Tells its size by a note. */
bool export_projector_picture(struct export_target *target, const struct emitter *emitter);

#endif
