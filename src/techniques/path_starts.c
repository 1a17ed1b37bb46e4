#include "techniques/path_starts.h"

bool path_starts_init(struct path_starts *starts, const struct path_starts_desc *desc) {
    *starts = (struct path_starts){0};
    if (importance_map_pass_init(&starts->importance,
                                 &(struct importance_map_desc){.casters = desc->casters,
                                                               .lights = desc->lights,
                                                               .vpls = desc->count,
                                                               .sky_rays = desc->sky_rays,
                                                               .sampled = desc->sampled,
                                                               .bounces = desc->bounces}) &&
        vpl_pass_init(&starts->places, &(struct vpl_desc){.count = desc->count,
                                                          .seed = desc->seed,
                                                          .reach = 1,
                                                          .by_importance = true,
                                                          .sky_rays = desc->sky_rays,
                                                          .sampled = desc->sampled,
                                                          .of_paths = true,
                                                          .medium = desc->medium,
                                                          .slides = desc->slides}) &&
        vpl_buffer_init(&starts->vpls, "starts of paths", desc->count))
        return true;
    path_starts_free(starts);
    return false;
}

void path_starts_free(struct path_starts *starts) {
    if (starts->importance.density_program)
        importance_map_pass_free(&starts->importance);
    vpl_pass_free(&starts->places);
    vpl_buffer_free(&starts->vpls);
    *starts = (struct path_starts){0};
}

void path_starts_render(struct path_starts *starts, const struct frame *frame,
                        const struct gbuffer rsm[LIGHT_MAP_KINDS], const struct light_rays *rays) {
    vpl_pass_share_out(&starts->places, frame);
    importance_map_pass_render(&starts->importance, frame, rsm, rays, &starts->places.shares);
    vpl_pass_render(&starts->places, frame, rsm, &starts->importance.map, rays, &starts->vpls);
}
