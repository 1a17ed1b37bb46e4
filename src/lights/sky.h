/* The lights of a sky, as shaders have them (shared/sky.h). */
#ifndef LIGHTS_SKY_H
#define LIGHTS_SKY_H

#include "lights/environment_fit.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Of two groups that become one the first keeps its number; the last group takes that of the second. */
struct sky_join {
    int to, from;
};

struct environment_lights {
    struct environment_light items[ENVIRONMENT_LIGHTS_MAX];
    int count;
    struct sky_join joins
        [ENVIRONMENT_LIGHTS_MAX]; /* count - 1, in turn; each moves the least power the least far */
};

/* As environment_fit fits them; sky NULL: none. */
void environment_lights_fit(struct environment_lights *lights, const struct environment *sky,
                            enum sky_fit fit, int count);

/* Finds the joins, which groups need. */
void environment_lights_find_joins(struct environment_lights *lights);

/* How many of the first are suns: narrow, and a good share of all light. At most SKY_SUNS_MAX. */
enum { SKY_SUNS_MAX = 4 };
int environment_lights_suns(const struct environment_lights *lights);

/* Some of them that stand together: each light's group, from 0. */
struct sky_groups {
    int of[ENVIRONMENT_LIGHTS_MAX];
    int count;
    float weights[ENVIRONMENT_LIGHTS_MAX]; /* of each light: its chance is its power times that */
    struct sky_door {
        float position[3], radius; /* 0: anywhere */
    } doors[ENVIRONMENT_LIGHTS_MAX];
};

/* At most `count`, by the first joins. Weights are 1. */
void environment_lights_group(struct sky_groups *groups, const struct environment_lights *lights,
                              int count);

/* At most `count`, from all lights as one group: joins are undone where most weighted power moves farthest. So other
 * weights change few groups. */
void environment_lights_group_by_weights(struct sky_groups *groups,
                                         const struct environment_lights *lights,
                                         const float weights[], int count);

bool sky_groups_same(const struct sky_groups *a, const struct sky_groups *b);

/* What a light gives a surface that faces it, the mean of RGB, W/m2. */
float environment_light_power(const struct environment_light *light);

/* As the sky is turned. */
void sky_block_of(struct sky_block *block, const struct environment_lights *lights,
                  const struct environment *sky);

/* A directional light in the weighted middle of a group. With even weights it gives a surface that faces it as much as all
 * lights of the group; else lights count by their weights. Or one from a place of the group, two numbers in [0, 1): it gives
 * as much as all on average, whatever the weights. */
struct emitter sky_group_emitter(const struct environment_lights *lights,
                                 const struct sky_groups *groups, int group,
                                 const struct environment *sky);
struct emitter sky_group_piece(const struct environment_lights *lights,
                               const struct sky_groups *groups, int group,
                               const struct environment *sky, const float place[2]);

#endif
