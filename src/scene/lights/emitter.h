/* An emitter: a light of the scene placed in the world, and its radiometry.
 *
 * KHR_lights_punctual: candela is read as W/sr, lux as W/m2. A spot's cone falls off as
 * clamp((cos a - cos outer) / max(0.001, cos inner - cos outer), 0, 1)^2. An area light has the same
 * radiance in all directions on its front, so that its intensity falls off as the cosine.
 *
 * A light with a size is many without, spread evenly over its shape (emitter_piece): from far away
 * all are as one in the middle. A sphere's and a rectangle's pieces are those of area lights and of
 * spots; the sun's come from a cap of directions.
 */
#ifndef SCENE_LIGHTS_EMITTER_H
#define SCENE_LIGHTS_EMITTER_H

#include "scene/lights/slide.h"
#include "scene/scene.h"

struct emitter {
    enum emitter_type type;
    int number;                 /* of the scene's light nodes, in node order; -1 = it was added */
    float intensity[3];         /* W/sr on the axis; W/m2 for a directional light */
    float size[2];              /* along right and up, m; without the second the diameter of a disk,
                                   of a point's sphere, or the angle across a directional light, rad */
    float position[3];          /* spot and point */
    float direction[3];         /* unit: where it shines */
    float right[3], up[3];      /* with -direction a right-handed orthonormal frame */
    float cos_inner, cos_outer; /* spot */
    float range;               /* where its light ends, m, as of KHR_lights_punctual; 0 = nowhere */
    int lamp, stands_in;       /* as struct scene_light has them */
    const struct slide *slide; /* of a spot, the scene's; NULL = none */
};

enum emitter_shape {
    EMITTER_IS_POINT, /* a light without a size */
    EMITTER_IS_RECTANGLE,
    EMITTER_IS_DISK,
    EMITTER_IS_SPHERE,
    EMITTER_IS_CAP, /* of directions */
};

/* In the order of enum emitter_type, NULL at the end. */
extern const char *const emitter_type_names[];

/* What shines at one time. */
struct emitters {
    struct emitter *items;
    int count;
    const struct environment *sky; /* the scene's, where it shines; else NULL */
};

struct emitters emitters_copy(const struct emitters *emitters);
bool emitters_same(const struct emitters *a, const struct emitters *b);

/* Accepts zeroed ones. */
void emitters_free(struct emitters *emitters);

/* A light that no file has: in the origin, downwards, 1 W/sr (1 W/m2), without a size; a spot's cone
 * reaches to 45 degrees, as glTF has it. */
struct emitter emitter_new(enum emitter_type type);

/* Places the light of the scene's n-th light node (in node order). Asserts that there is one. */
void emitter_place(struct emitter *emitter, const struct scene *scene, int n, double time);

/* All lights of the scene, and its sky: the nodes are walked once. */
struct emitters emitters_place(const struct scene *scene, double time);

/* Turns the light: its frame is made of the direction, which need not be unit. */
void emitter_aim(struct emitter *emitter, const float direction[3]);

/* The n of a light by name or number in text; -1 and an error when there is none such. */
int emitter_find(const struct scene *scene, const char *text);

int emitter_node_count(const struct scene *scene);

enum emitter_shape emitter_shape(const struct emitter *emitter);

/* Area of the shape, m2; of a cap solid angle, sr; 0 of a point. */
double emitter_extent(const struct emitter *emitter);

/* The light without a size that shines from one place of the shape as the whole one does: places are
 * two numbers in [0, 1), even in the shape's area, and what pieces give is on average what the light
 * gives. A point's is itself. */
struct emitter emitter_piece(const struct emitter *emitter, const float place[2]);

/* The place, as emitter_piece has it, that a ray of that unit direction comes to, and how far from its
 * origin, m, infinite for a directional light; false where it misses, or comes to its back. The side of a sphere
 * that the ray comes to first. */
bool emitter_meet(const struct emitter *emitter, const float origin[3], const float direction[3],
                  float place[2], float *distance);

/* The falloff in [0, 1] for the cosine of the angle to the axis: a spot's cone, an area light's
 * cosine; 1 for the other types. */
float emitter_cone(const struct emitter *emitter, float cos_angle);

/* What is left at so many metres from it of the light that would come to there, in [0, 1]: 1 - (distance / range)^4, as
 * KHR_lights_punctual recommends; 1 without a range. */
float emitter_in_range(const struct emitter *emitter, float distance);

/* Solid angle the light shines into, steradians: 2 pi (1 - cos outer) for a spot, 4 pi for a point,
 * 2 pi for an area light, 0 for a directional light. */
double emitter_solid_angle(const struct emitter *emitter);

/* Flux of the light, the mean of RGB, W, however far it comes: of a directional light, through the cross section of a
 * sphere of that radius, metres. */
double emitter_flux(const struct emitter *emitter, float radius);

#endif
