/* A slide in a spot, as of a projector or a stained-glass window [Dong 2011 §8.4.2]: it colours
 * the light by direction. It fills the square around the spot's cone; its top is the light's up. */
#ifndef SCENE_LIGHTS_SLIDE_H
#define SCENE_LIGHTS_SLIDE_H

struct bitmap;
struct emitter;

struct slide {
    int layer; /* number in the scene */
    int width, height;
    float (*texels)[4]; /* linear RGB, row 0 at the top */
};

enum { SLIDE_SIZE_MAX = 2048 }; /* texels a side */

/* Widest cone with a slide: half its angle, radians. */
#define SLIDE_CONE_MAX 1.4F

/* Copies the colours of an sRGB picture. */
void slide_init(struct slide *slide, int layer, const struct bitmap *bitmap);
void slide_free(struct slide *slide);

/* Writes the transmittance in a unit direction, RGB in [0, 1], interpolated bilinearly. 1 without a
 * slide. */
void emitter_slide(const struct emitter *emitter, const float direction[3], float rgb[3]);

/* Returns the cotangent of the cone's half angle: axial distance over the slide's half side. */
float emitter_slide_scale(const struct emitter *emitter);

#endif
