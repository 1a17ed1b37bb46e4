#include "reference/scene/sky.h"

#include "base/memory.h"

#include <cglm/cglm.h>
#include <math.h>

static const float *texel_at(const struct environment *environment, int x, int y) {
    return environment->texels[(size_t)y * (size_t)environment->width + (size_t)x];
}

static double brightness(const struct environment *environment, int x, int y) {
    const float *texel = texel_at(environment, x, y);
    return (double)environment->strength * ((double)texel[0] + (double)texel[1] + (double)texel[2]);
}

/* Rows first: a number alone has too few bits for all texels of a large panorama. */
bool sky_init(struct sky *sky, const struct environment *environment) {
    int width = environment->width, height = environment->height;
    double *weights = mem_alloc((size_t)width, sizeof *weights);
    double *sums = mem_alloc((size_t)height, sizeof *sums);
    *sky = (struct sky){.environment = environment,
                        .columns = mem_alloc((size_t)height, sizeof *sky->columns)};
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++)
            sums[y] += weights[x] = brightness(environment, x, y);
        if (sums[y] > 0)
            alias_init(&sky->columns[y], weights, width);
        sums[y] *= environment_solid_angle(environment, y);
        sky->power += sums[y];
    }
    if (sky->power > 0)
        alias_init(&sky->rows, sums, height);
    mem_free(weights, sums);
    return sky->power > 0;
}

void sky_free(struct sky *sky) {
    for (int y = 0; sky->columns && y < sky->environment->height; y++)
        alias_free(&sky->columns[y]);
    free(sky->columns);
    alias_free(&sky->rows);
    *sky = (struct sky){0};
}

/* Within a texel, places are even in solid angle. */
struct emitter sky_piece(const struct sky *sky, const float place[2], double *density) {
    const struct environment *environment = sky->environment;
    float across = place[0], down = place[1], to_sky[3];
    int y = alias_pick(&sky->rows, &down), x = alias_pick(&sky->columns[y], &across);
    double step = GLM_PI / environment->height, top = cos(y * step), bottom = cos((y + 1) * step);
    double polar = acos(top + (double)down * (bottom - top));
    struct emitter piece = {.type = EMITTER_DIRECTIONAL};
    environment_direction(environment, x + (double)across, polar / step, to_sky);
    glm_vec3_negate_to(to_sky, piece.direction);
    *density = brightness(environment, x, y) / sky->power;
    for (int c = 0; c < 3; c++)
        piece.intensity[c] =
            (float)((double)(environment->strength * texel_at(environment, x, y)[c]) / *density);
    return piece;
}

double sky_density(const struct sky *sky, const float direction[3]) {
    int x, y;
    environment_texel(sky->environment, direction, &x, &y);
    return brightness(sky->environment, x, y) / sky->power;
}
