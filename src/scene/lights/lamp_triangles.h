/* Triangles of emissive surfaces in the world. */
#ifndef SCENE_LIGHTS_LAMP_TRIANGLES_H
#define SCENE_LIGHTS_LAMP_TRIANGLES_H

#include "scene/lights/lamp_parts.h"
#include "scene/scene.h"

#include <stdint.h>

struct lamp_triangles {
    struct lamp_triangle *items;
    int count;
    bool has_detail;             /* a texture varies over some triangle */
    uint32_t looks;              /* texels that may still be sampled finely */
    const float *srgb_to_linear; /* table of texture_decode_table */
};

/* Most texel samples for all surfaces of a scene, at any number of instances. */
enum { LAMP_LOOKS = 1 << 24 };

/* Adds the emitting triangles of a primitive: on both sides if the material has two. Textures are
 * averaged over each triangle. */
void lamp_triangles_add(struct lamp_triangles *triangles, const struct scene *scene,
                        const struct primitive *primitive, const float world[16]);

/* Writes the mean radiance of one triangle of a primitive, W/(sr m2). srgb_to_linear, looks: as in
 * struct lamp_triangles. */
void lamp_triangle_radiance(const struct scene *scene, const struct primitive *primitive,
                            const uint32_t index[3], const float *srgb_to_linear, uint32_t *looks,
                            double radiance[3]);

/* Accepts a zeroed object. */
void lamp_triangles_free(struct lamp_triangles *triangles);

/* Returns the sum of area x (R + G + B), W/sr. */
double lamp_triangles_power(const struct lamp_triangles *triangles);

/* Writes the radiance if it is constant over all triangles, W/(sr m2). False: it varies. */
bool lamp_triangles_color(const struct lamp_triangles *triangles, float radiance[3]);

#endif
