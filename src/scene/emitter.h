/* An emitter: a light of the scene placed in the world, and its radiometry.
 *
 * KHR_lights_punctual: candela is read as W/sr, lux as W/m2. A spot's cone falls off as
 * clamp((cos a - cos outer) / max(0.001, cos inner - cos outer), 0, 1)^2.
 */
#ifndef SCENE_EMITTER_H
#define SCENE_EMITTER_H

#include "scene/scene.h"

struct emitter {
    enum emitter_type type;
    int number;                 /* of the scene's light nodes, in node order */
    float intensity[3];         /* W/sr on the axis; W/m2 for a directional light */
    float position[3];          /* spot and point */
    float direction[3];         /* unit: where it shines */
    float right[3], up[3];      /* with -direction a right-handed orthonormal frame */
    float cos_inner, cos_outer; /* spot */
};

/* What shines at one time. */
struct emitters {
    struct emitter *items;
    int count;
};

struct emitters emitters_copy(const struct emitters *emitters);
bool emitters_same(const struct emitters *a, const struct emitters *b);

/* Accepts zeroed ones. */
void emitters_free(struct emitters *emitters);

/* Places the light of the scene's n-th light node (in node order). Asserts that there is one. */
void emitter_place(struct emitter *emitter, const struct scene *scene, int n, double time);

/* Turns the light: its frame is made of the direction, which need not be unit. */
void emitter_aim(struct emitter *emitter, const float direction[3]);

/* The n of a light by name or number in text; -1 and an error when there is none such. */
int emitter_find(const struct scene *scene, const char *text);

int emitter_node_count(const struct scene *scene);

/* The spot's falloff in [0, 1] for the cosine of the angle to its axis; 1 for the other types. */
float emitter_cone(const struct emitter *emitter, float cos_angle);

/* Solid angle the light shines into, steradians: 2 pi (1 - cos outer) for a spot, 4 pi for a point,
 * 0 for a directional light. */
double emitter_solid_angle(const struct emitter *emitter);

/* Flux of the light, the mean of RGB, W: of a directional light, through the cross section of a
 * sphere of that radius, metres. */
double emitter_flux(const struct emitter *emitter, float radius);

#endif
