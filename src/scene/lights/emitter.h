/* Emitters: lights of the scene placed in the world, and their radiometry.
 *
 * KHR_lights_punctual: candela is read as W/sr, lux as W/m2. A spot falls off as
 * clamp((cos a - cos outer) / max(0.001, cos inner - cos outer), 0, 1)^2. An area light has
 * constant radiance on its front, so its intensity falls off as the cosine.
 *
 * A light with a size equals many points spread uniformly over its shape (emitter_piece). From afar
 * it equals one point at its centre. Points of a sphere are area lights, points of a sun are
 * directions of a cap, other points keep the light's type. */
#ifndef SCENE_LIGHTS_EMITTER_H
#define SCENE_LIGHTS_EMITTER_H

#include "scene/lights/slide.h"
#include "scene/scene.h"

struct emitter {
    enum emitter_type type;
    int number;         /* number of its light node, in node order; -1: added */
    float intensity[3]; /* W/sr on the axis; W/m2 for a directional light */
    /* Along right and up, metres. With the second 0: the diameter of a disk or of a point's sphere,
     * or the angle across a directional light, radians. */
    float size[2];
    float position[3];          /* spot and point */
    float direction[3];         /* unit direction of the axis */
    float right[3], up[3];      /* right-handed orthonormal frame with -direction */
    float cos_inner, cos_outer; /* spot */
    float range; /* greatest distance of its light, metres (KHR_lights_punctual); 0: infinite */
    int lamp, stands_in;       /* as in struct scene_light */
    int moved;                 /* 1: by hand in the viewer, so that clips leave it; else 0 */
    int unused;                /* no padding: emitters are compared and hashed as bytes */
    const struct slide *slide; /* owned by the scene; NULL: none */
};

enum emitter_shape {
    EMITTER_IS_POINT, /* a light without a size */
    EMITTER_IS_RECTANGLE,
    EMITTER_IS_DISK,
    EMITTER_IS_SPHERE,
    EMITTER_IS_CAP, /* cap of directions */
};

/* Names by enum emitter_type, null-terminated. */
extern const char *const emitter_type_names[];

/* Lights that shine at one time. */
struct emitters {
    struct emitter *items;
    int count;
    const struct environment *sky; /* the scene's, if it shines; else NULL */
};

struct emitters emitters_copy(const struct emitters *emitters);
bool emitters_same(const struct emitters *a, const struct emitters *b);

/* Accepts a zeroed object. */
void emitters_free(struct emitters *emitters);

/* Returns a new light: at the origin, downwards, 1 W/sr (1 W/m2), without a size. A spot's cone
 * reaches to 45 degrees, as in glTF. */
struct emitter emitter_new(enum emitter_type type);

/* Places the light of the scene's n-th light node, which must exist. time: seconds. */
void emitter_place(struct emitter *emitter, const struct scene *scene, int n, double time);

/* Returns all lights of the scene and its environment. The caller calls emitters_free. */
struct emitters emitters_place(const struct scene *scene, double time);

/* Rotates the light to `direction`, which need not be unit. */
void emitter_aim(struct emitter *emitter, const float direction[3]);

/* Returns the light node's n by name or number in `text`. Error, -1: unknown light. */
int emitter_find(const struct scene *scene, const char *text);

int emitter_node_count(const struct scene *scene);

enum emitter_shape emitter_shape(const struct emitter *emitter);

/* Returns the area of the shape, m2; the solid angle of a cap, sr; 0 for a point. */
double emitter_extent(const struct emitter *emitter);

/* Returns the point light that represents the whole light from one place of the shape. `place` has
 * two numbers in [0, 1), uniform over the shape's area; the mean over places is the light. A point
 * returns itself. */
struct emitter emitter_piece(const struct emitter *emitter, const float place[2]);

/* Finds the place, as for emitter_piece, where a ray with a unit direction meets the light. On a
 * sphere it is the nearer side. distance: from the origin, metres; infinite for a directional
 * light. False: it misses, or meets the back. */
bool emitter_meet(const struct emitter *emitter, const float origin[3], const float direction[3],
                  float place[2], float *distance);

/* Returns the falloff in [0, 1] by the cosine of the angle to the axis: a spot's cone, an area
 * light's cosine; 1 for other types. */
float emitter_cone(const struct emitter *emitter, float cos_angle);

/* Returns the difference of cosines between a spot's rim and its full light. */
float emitter_falloff_width(const struct emitter *emitter);

/* Returns the attenuation by the light's range in [0, 1]: 1 - (distance / range)^4, as
 * KHR_lights_punctual recommends; 1 without a range. distance: metres. */
float emitter_in_range(const struct emitter *emitter, float distance);

/* Returns the light's solid angle, sr. Spot: 2 pi (1 - cos outer); point: 4 pi; area light: 2 pi;
 * directional light: 0. */
double emitter_solid_angle(const struct emitter *emitter);

/* Returns the light's flux, mean of RGB, W, without its range. A directional light counts through
 * the cross section of a sphere of `radius`, metres. */
double emitter_flux(const struct emitter *emitter, float radius);

#endif
