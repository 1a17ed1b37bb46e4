/* A picture in a spot, as of a projector or a stained-glass window [Dong 2011 §8.4.2]: it colours the light by direction. The
 * square around the spot's cone shows all of it; seen from the light, its top is the light's up. */
#ifndef SCENE_LIGHTS_SLIDE_H
#define SCENE_LIGHTS_SLIDE_H

struct bitmap;
struct emitter;

struct slide {
    int layer; /* its number in the scene */
    int width, height;
    float (*texels)[4]; /* linear RGB, row 0 at the top */
};

enum { SLIDE_SIZE_MAX = 2048 }; /* a side */

/* The widest cone that has one: half its angle, radians. */
#define SLIDE_CONE_MAX 1.4F

/* Takes the colours of an sRGB picture. */
void slide_init(struct slide *slide, int layer, const struct bitmap *bitmap);
void slide_free(struct slide *slide);

/* What passes of light in a unit direction, RGB in [0, 1]; 1 where the emitter has no slide. Linear between texels. */
void emitter_slide(const struct emitter *emitter, const float direction[3], float rgb[3]);

/* Of the slide's half side over the distance along the axis, one over it: the cotangent of the cone's half angle. */
float emitter_slide_scale(const struct emitter *emitter);

#endif
