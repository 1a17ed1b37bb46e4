/* A slide colours a light by direction: in a spot, as of a projector or a stained-glass window
 * [Dong 2011 §8.4.2], or the profile of a point.
 *
 * In a spot it fills the square around the cone; its top is the light's up. Columns of a profile
 * divide a turn about the axis, from the light's right to its up. Rows divide half a turn away from
 * the axis. The first texels are at 0, the last at the whole. */
#ifndef SCENE_LIGHTS_SLIDE_H
#define SCENE_LIGHTS_SLIDE_H

#include <stdbool.h>

struct bitmap;
struct emitter;
struct profile;

struct slide {
    int layer; /* number in the scene */
    int width, height;
    float (*texels)[4]; /* linear RGB, row 0 at the top; of a profile over its mean intensity */
    bool is_profile;
};

enum { SLIDE_SIZE_MAX = 2048 }; /* texels a side */

/* Widest cone with a slide: half its angle, radians. */
#define SLIDE_CONE_MAX 1.4F

/* Copies the colours of an sRGB picture. */
void slide_init(struct slide *slide, int layer, const struct bitmap *bitmap);

/* Copies a profile; returns its mean intensity over all directions, W/sr. */
float slide_init_profile(struct slide *slide, int layer, const struct profile *profile);

/* Returns the texels of a profile. */
int slide_profile_size(const struct profile *profile);

void slide_free(struct slide *slide);

/* True if its slide colours the light: of a spot, or a profile of a point without a size. */
bool emitter_has_slide(const struct emitter *emitter);

/* Writes the factor of intensity in a unit direction, RGB, interpolated bilinearly. 1 without a
 * slide. */
void emitter_slide(const struct emitter *emitter, const float direction[3], float rgb[3]);

/* Writes the intensity of a light without a cone, W/sr. away: from the axis; turn: about it, from
 * the light's right to its up; radians. */
void emitter_intensity(const struct emitter *emitter, float away, float turn, float rgb[3]);

/* Returns the cotangent of the cone's half angle, axial distance over the slide's half side; 0 of a
 * profile. */
float emitter_slide_scale(const struct emitter *emitter);

#endif
