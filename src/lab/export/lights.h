/* The lights of a stage as other renderers know them. */
#ifndef LAB_EXPORT_LIGHTS_H
#define LAB_EXPORT_LIGHTS_H

#include "lab/export/target.h"

/* Whether the light is exported as a light, and not as a mesh that shines. */
bool export_is_light(const struct emitter *emitter);

/* Notes of what neither format has: ranges, sizes of spots and suns. */
void export_note_light(struct export_target *target, const struct emitter *emitter);

/* Whether the light is drawn as a shape with that radiance: area lights and spheres. */
bool export_is_shape(const struct emitter *emitter);
void export_radiance(const struct emitter *emitter, float radiance[3]);

/* The half angles, degrees, between which a spot's light falls off linearly in the angle. The full
 * cone is the light's own; the end of the falloff is chosen so that the spot has its flux. */
struct spot_cone {
    double full, end;
};
struct spot_cone export_cone(const struct emitter *emitter);

/* From a rectangle or a disk of radius 1 in the plane of x and y, whose front is +z, to the light:
 * by rows. */
void export_place(const struct emitter *emitter, float matrix[16]);

#endif
