/* The triangles of emissive surfaces, in the world. */
#ifndef SCENE_LIGHTS_LAMP_TRIANGLES_H
#define SCENE_LIGHTS_LAMP_TRIANGLES_H

#include "scene/lights/lamp_parts.h"
#include "scene/scene.h"

#include <stdint.h>

struct lamp_triangles {
    struct lamp_triangle *items;
    int count;
    bool has_detail;             /* a texture's, over one of them */
    uint32_t looks;              /* how many texels may still be looked at closely */
    const float *srgb_to_linear; /* texture_decode_table's */
};

/* Looks for all surfaces of a scene, however often each is there. */
enum { LAMP_LOOKS = 1 << 24 };

/* Adds those of a primitive that shine: of both sides, where the material has two. What textures say is
 * averaged over each. */
void lamp_triangles_add(struct lamp_triangles *triangles, const struct scene *scene,
                        const struct primitive *primitive, const float world[16]);

/* Accepts zeroed ones. */
void lamp_triangles_free(struct lamp_triangles *triangles);

/* Area x the sum of RGB, W/sr. */
double lamp_triangles_power(const struct lamp_triangles *triangles);

/* The radiance that all of them have all over, W/(sr m2); false where there is none. */
bool lamp_triangles_color(const struct lamp_triangles *triangles, float radiance[3]);

#endif
