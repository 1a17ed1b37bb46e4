#include "renderer/airlight.h"

#include "shared/medium.h"

/* Texels along each side of a light's map, for up to so many views: the blur is wider than the
 * steps of its edges. */
enum { MAP_SIZE = 1024, FULL_VIEWS = 8 };

static int map_size(const struct light_layout *lights) {
    const int faces_of_view = 4; /* which are half as large */
    int views = lights->views[LIGHT_MAP_SINGLE] + lights->views[LIGHT_MAP_FACE] / faces_of_view;
    return light_map_share(MAP_SIZE, views, FULL_VIEWS);
}

static bool init_medium(struct airlight *airlight, const struct airlight_part_desc *desc) {
    return desc->steps == 0 ||
           (shadow_map_pass_init(&airlight->maps, &(struct shadow_map_desc){map_size(&desc->lights),
                                                                            desc->lights}) &&
            airlight_pass_init(&airlight->pass,
                               &(struct airlight_desc){desc->width, desc->height, desc->steps,
                                                       desc->slides, desc->panes != NULL}));
}

static bool init_panes(struct airlight *airlight, const struct airlight_part_desc *desc) {
    return !desc->panes ||
           show_panes_pass_init(&airlight->panes,
                                &(struct show_panes_desc){.width = desc->width,
                                                          .height = desc->height,
                                                          .scatters = desc->steps > 0,
                                                          .slides = desc->slides,
                                                          .sky = desc->sky,
                                                          .irradiance = desc->irradiance,
                                                          .reflects = desc->reflects,
                                                          .specular = desc->specular,
                                                          .casters = desc->panes});
}

bool airlight_init(struct airlight *airlight, const struct airlight_part_desc *desc) {
    *airlight = (struct airlight){0};
    if (buffer_init(&airlight->medium, "medium", sizeof(struct medium_params), NULL) &&
        init_medium(airlight, desc) && init_panes(airlight, desc))
        return true;
    airlight_free(airlight);
    return false;
}

bool airlight_resize(struct airlight *airlight, int width, int height) {
    const struct airlight_desc before = airlight->pass.desc;
    if (airlight->pass.in_scatter.id && !airlight_pass_resize(&airlight->pass, width, height))
        return false;
    if (!airlight->panes.program || show_panes_pass_resize(&airlight->panes, width, height))
        return true;
    if (airlight->pass.in_scatter.id)
        airlight_pass_resize(&airlight->pass, before.width, before.height);
    return false;
}

void airlight_free(struct airlight *airlight) {
    buffer_free(&airlight->medium);
    shadow_map_pass_free(&airlight->maps);
    airlight_pass_free(&airlight->pass);
    show_panes_pass_free(&airlight->panes);
}

void airlight_set_medium(const struct airlight *airlight, const struct medium *medium,
                         const struct geometry *geometry) {
    struct medium_params params = {.radius = geometry->radius, .g = medium->g};
    for (int c = 0; c < 3; c++) {
        params.center[c] = geometry->center[c];
        params.scattering[c] = medium->scattering[c];
        params.extinction[c] = medium->scattering[c] + medium->absorption[c];
        params.mean_extinction += params.extinction[c] / 3;
    }
    if (airlight->medium.id)
        buffer_write(&airlight->medium, 0, sizeof params, &params);
}
