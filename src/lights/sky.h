/* The lights of a sky, as shaders have them (shared/sky.h). */
#ifndef LIGHTS_SKY_H
#define LIGHTS_SKY_H

#include "lights/environment_fit.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

struct environment_lights {
    struct environment_light items[ENVIRONMENT_LIGHTS_MAX];
    int count;
};

/* As environment_fit fits them; sky NULL: none. */
void environment_lights_fit(struct environment_lights *lights, const struct environment *sky,
                            enum sky_fit fit, int count);

/* How many of the first are suns: narrow, and a good share of all light. At most SKY_SUNS_MAX. */
enum { SKY_SUNS_MAX = 4 };
int environment_lights_suns(const struct environment_lights *lights);

/* Some of them that stand together: each light's group, from 0. */
struct sky_groups {
    int of[ENVIRONMENT_LIGHTS_MAX];
    int count;
};

/* At most so many: lights are joined where that moves the least power the least far. */
void environment_lights_group(struct sky_groups *groups, const struct environment_lights *lights,
                              int count);

/* As the sky is turned. */
void sky_block_of(struct sky_block *block, const struct environment_lights *lights,
                  const struct environment *sky);

/* A directional light in the middle of a group, which gives a surface that faces it as much as all lights
 * of the group; or from a place of it, two numbers in [0, 1), as much as all on average. */
struct emitter sky_group_emitter(const struct environment_lights *lights,
                                 const struct sky_groups *groups, int group,
                                 const struct environment *sky);
struct emitter sky_group_piece(const struct environment_lights *lights,
                               const struct sky_groups *groups, int group,
                               const struct environment *sky, const float place[2]);

#endif
