/* Environment lights for shaders (shared/sky.h), and their groups. */
#ifndef LIGHTS_SKY_H
#define LIGHTS_SKY_H

#include "lights/environment_fit.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Merges group `from` into `to`. The last group moves into index `from`. */
struct sky_join {
    int to, from;
};

struct environment_lights {
    struct environment_light items[ENVIRONMENT_LIGHTS_MAX];
    int count;
    /* count - 1 merges in order; each moves the least power over the least angle. */
    struct sky_join joins[ENVIRONMENT_LIGHTS_MAX];
};

/* Fits the lights by environment_fit. sky NULL: none. */
void environment_lights_fit(struct environment_lights *lights, const struct environment *sky,
                            enum sky_fit fit, int count);

/* Finds the joins, which environment_lights_group needs. */
void environment_lights_find_joins(struct environment_lights *lights);

/* Returns the number of suns, the first lights that are below .01 sr and have 2.5 % of all power;
 * at most SKY_SUNS_MAX. */
enum { SKY_SUNS_MAX = 4 };
int environment_lights_suns(const struct environment_lights *lights);

/* Returns the number of bright lights, the first lights of more than 8 times the mean radiance of
 * all that follow. */
int environment_lights_bright(const struct environment_lights *lights);

/* Groups of neighbouring environment lights. */
struct sky_groups {
    int of[ENVIRONMENT_LIGHTS_MAX]; /* group of each light, from 0 */
    int count;
    /* Weight of each light: sampling is in proportion to power times weight. */
    float weights[ENVIRONMENT_LIGHTS_MAX];
    /* Sphere through which the light of a group enters the picture; radius 0: anywhere. */
    struct sky_door {
        float position[3], radius;
    } doors[ENVIRONMENT_LIGHTS_MAX];
};

/* Makes at most `count` groups by the first joins, with weights 1. */
void environment_lights_group(struct sky_groups *groups, const struct environment_lights *lights,
                              int count);

/* Makes at most `count` groups. Starts from one group and undoes the joins that move most weighted
 * power farthest, so new weights change few groups. */
void environment_lights_group_by_weights(struct sky_groups *groups,
                                         const struct environment_lights *lights,
                                         const float weights[], int count);

bool sky_groups_same(const struct sky_groups *a, const struct sky_groups *b);

/* Returns the irradiance of a surface that faces the light, mean of RGB, W/m2. */
float environment_light_power(const struct environment_light *light);

/* Fills the shader block with the lights at the sky's rotation and strength. */
void sky_block_of(struct sky_block *block, const struct environment_lights *lights,
                  const struct environment *sky);

/* Return a directional light for a group. The first is in its weighted middle. With equal weights
 * it gives a facing surface the irradiance of all lights of the group; else each light counts by
 * its weight. The second is sampled at `place` in [0, 1)^2. Its mean over places is the whole light
 * of the group, for any weights. */
struct emitter sky_group_emitter(const struct environment_lights *lights,
                                 const struct sky_groups *groups, int group,
                                 const struct environment *sky);
struct emitter sky_group_piece(const struct environment_lights *lights,
                               const struct sky_groups *groups, int group,
                               const struct environment *sky, const float place[2]);

#endif
