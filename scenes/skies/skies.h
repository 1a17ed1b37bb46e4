/* The skies: panoramas in W/(sr m2), beside the scenes that name them. */
#ifndef SCENES_SKIES_H
#define SCENES_SKIES_H

/* Radiance that comes from a unit direction. */
typedef void (*sky_painter)(const float direction[3], float radiance[3]);

/* A blue gradient, brighter at the horizon, and a soft sun, which gives a surface that faces it
 * four times as much as the rest gives the ground. */
void paint_day(const float direction[3], float radiance[3]);

/* Clouds all over, three times as bright overhead as at the horizon [CIE standard overcast sky]. */
void paint_overcast(const float direction[3], float radiance[3]);

#endif
