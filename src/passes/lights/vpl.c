#include "passes/lights/vpl.h"

#include "base/deal.h"
#include "base/halton.h"
#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "lights/light_samples.h"
#include "passes/frame.h"
#include "passes/sampled_lights.h"
#include "passes/vpls.h"
#include "shared/vpl.h"
#include "shared/vpl_share.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Vertex of a VPL: ATTRIBUTE_VPL_POINT. */
struct vpl_point {
    float halton[2];
    float light; /* index of the light; by importance: number in [0, 1) that chooses it */
};

static bool init_programs(struct vpl_pass *pass) {
    int count = pass->desc.count < VPL_PARTNERS_MAX ? pass->desc.count : VPL_PARTNERS_MAX;
    char *defines = mem_printf("PARTNERS %d", count);
    char *vpl_defines =
        mem_printf("%s%s%s%s%s%s", light_defines(pass->desc.medium, pass->desc.slides),
                   pass->desc.of_paths ? "LATER;" : "", pass->desc.sky_rays ? "SKY_RAYS;" : "",
                   pass->desc.sampled ? "HAS_SAMPLED;" : "", pass->desc.lobes ? "VPL_LOBES;" : "",
                   pass->desc.by_importance ? "BY_IMPORTANCE;" : "");
    const struct program_desc vpl = {.vertex = "passes/lights/vpl.vert", .defines = vpl_defines};
    bool ok = program_init(&pass->program, &vpl) &&
              program_init(&pass->sums_program,
                           &(struct program_desc){.vertex = "passes/lights/vpl_sums.vert",
                                                  .fragment = "passes/lights/point.frag",
                                                  .defines = defines});
    mem_free(defines, vpl_defines);
    return ok;
}

bool vpl_pass_init(struct vpl_pass *pass, const struct vpl_desc *desc) {
    *pass = (struct vpl_pass){.desc = *desc};
    size_t size = (size_t)desc->count * sizeof *pass->points;
    pass->points = mem_alloc((size_t)desc->count, sizeof *pass->points);
    if (!init_programs(pass) || !buffer_init(&pass->samples, "Halton points", size, NULL) ||
        !buffer_init(&pass->shares, "shares of VPLs", sizeof(struct vpl_share_block), NULL)) {
        vpl_pass_free(pass);
        return false;
    }
    gl.CreateVertexArrays(1, &pass->vertices);
    vertex_array_attribute(
        pass->vertices, ATTRIBUTE_VPL_POINT,
        &(struct vertex_attribute){&pass->samples, 3, GL_FLOAT, sizeof *pass->points, 0});
    return true;
}

void vpl_pass_free(struct vpl_pass *pass) {
    programs_free(&pass->program, &pass->sums_program);
    vertex_array_free(&pass->vertices);
    buffers_free(&pass->samples, &pass->shares);
    free(pass->points);
    *pass = (struct vpl_pass){0};
}

/* Returns a shift by later Halton bases. Each seed and each light after the first gets a new point
 * set that is as even. */
static double shift(int seed, int light, int axis) {
    double by_seed = seed ? radical_inverse(axis ? 7 : 5, (uint32_t)seed) : 0;
    return by_seed + radical_inverse(axis ? 13 : 11, (uint32_t)light);
}

static void deal_points(struct vpl_pass *pass, int frame_pass) {
    int count = pass->desc.count;
    struct dealt *dealt = mem_alloc((size_t)count, sizeof *dealt);
    deal(pass->fluxes, pass->light_count, dealt, count, pass->counts);
    for (int i = 0; i < count; i++) {
        int light = dealt[i].taker;
        uint32_t first = (uint32_t)frame_pass * (uint32_t)pass->counts[light];
        uint32_t number = first + (uint32_t)dealt[i].number;
        pass->points[i].light = (float)light;
        for (int axis = 0; axis < 2; axis++) {
            double point = radical_inverse(axis ? 3 : 2, number);
            pass->points[i].halton[axis] =
                (float)fmod(point + shift(pass->desc.seed, light, axis), 1);
        }
    }
    free(dealt);
}

/* Makes points of three dimensions. The third chooses the light by importance, on the GPU. */
static void spread_points(struct vpl_pass *pass, int frame_pass) {
    /* Directions of paths have the numbers between. */
    const uint32_t bases[] = {2, 3, pass->desc.of_paths ? 73 : 5};
    int count = pass->desc.count;
    uint32_t first = (uint32_t)frame_pass * (uint32_t)count;
    for (int i = 0; i < count; i++) {
        double numbers[3];
        for (int axis = 0; axis < 3; axis++)
            numbers[axis] = fmod(radical_inverse(bases[axis], first + (uint32_t)i) +
                                     (axis < 2 ? shift(pass->desc.seed, 0, axis) : 0),
                                 1);
        pass->points[i] =
            (struct vpl_point){{(float)numbers[0], (float)numbers[1]}, (float)numbers[2]};
    }
}

/* Makes the points again only if fluxes or the pass changed: in most clips they stay. */
static void follow_fluxes(struct vpl_pass *pass, const struct frame *frame) {
    const struct emitters *emitters = frame->emitters;
    double fluxes[LIGHTS_MAX] = {0};
    for (int i = 0; i < emitters->count; i++)
        fluxes[i] = emitter_flux(&emitters->items[i], frame->geometry->radius);
    if (pass->light_count == emitters->count && pass->dealt_pass == frame->pass &&
        memcmp(fluxes, pass->fluxes, sizeof fluxes) == 0)
        return;
    pass->light_count = emitters->count;
    pass->dealt_pass = frame->pass;
    memcpy(pass->fluxes, fluxes, sizeof fluxes);
    deal_points(pass, frame->pass);
    if (pass->desc.by_importance)
        spread_points(pass, frame->pass);
    buffer_write(&pass->samples, 0, (size_t)pass->desc.count * sizeof *pass->points, pass->points);
}

/* Returns the radius of the near field: `asked`, in spacings of the VPLs of a group, but at most 45
 * degrees in the light's view, where few VPLs are far apart. */
static float near_reach(const struct light *light, float measure, float asked) {
    float widest = measure / (float)VPL_COSINE_MIN;
    const float reach_of_many = 2; /* few rays find it (passes/gather/near_sampled.h) */
    if (light->type == LIGHT_TYPE_MANY)
        return fminf(asked, reach_of_many);
    return light->type == LIGHT_TYPE_DIRECTIONAL ? asked : fminf(asked, 1 / sqrtf(widest));
}

static void write_shares(const struct vpl_pass *pass, const struct frame *frame) {
    struct vpl_share_block shares = {0};
    for (int g = 0; g < frame->layout.groups; g++) {
        int first = frame->groups[g].first, end = first + frame->groups[g].count, together = 0;
        for (int i = first; i < end; i++)
            together += pass->counts[i];
        for (int i = first; i < end; i++) {
            const struct light *light = &frame->light_block->sources[i];
            if (pass->counts[i] == 0)
                continue;
            float measure = light->measure / (float)pass->counts[i];
            float asked = pass->desc.reach * sqrtf((float)pass->counts[i] / (float)together);
            shares.of[i] =
                (struct vpl_share){.measure = measure, .reach = near_reach(light, measure, asked)};
        }
    }
    buffer_write(&pass->shares, 0, sizeof shares, &shares);
}

void vpl_pass_sum_up(const struct vpl_pass *pass, const struct vpl_buffer *vpls) {
    static const float none[4] = {0};
    framebuffer_clear_color(vpls->sums_framebuffer, TARGET_RESULT, none);
    pass_set_state(&(struct pass_state){
        .name = "vpls",
        .program = pass->sums_program,
        .framebuffer = vpls->sums_framebuffer,
        .vertex_array = vpls->vertices,
        .width = 1,
        .height = 1,
        .blend = PASS_BLEND_ADD,
        .blocks = {{BLOCK_VPLS, &vpls->buffer, 0, VPLS_PER_BLOCK * sizeof(struct vpl)}},
    });
    pass_draw(GL_POINTS, vpls->count, 1);
}

void vpl_pass_share_out(struct vpl_pass *pass, const struct frame *frame) {
    follow_fluxes(pass, frame);
    write_shares(pass, frame);
}

void vpl_pass_render(const struct vpl_pass *pass, const struct frame *frame,
                     const struct gbuffer rsm[LIGHT_MAP_KINDS],
                     const struct importance_map *importance, const struct light_rays *rays,
                     const struct vpl_buffer *vpls) {
    struct pass_state state = {
        .name = "vpls",
        .program = pass->program,
        .vertex_array = pass->vertices,
        .blocks = {{BLOCK_LIGHTS, frame->lights}, {BLOCK_VPL_SHARES, &pass->shares}},
    };
    if (pass->desc.by_importance)
        importance_map_add(&state, importance);
    if (pass->desc.by_importance || pass->desc.sampled)
        light_rays_add(&state, rays);
    sampled_lights_add(frame->sampled, &state);
    frame_add_light(frame, &state);
    rsm_add(&state, rsm);
    if (pass->desc.lobes)
        pass_add_texture(&state, UNIT_LOBE_ALBEDOS, frame->scene->lobe_albedos.id);
    pass_begin(frame->timers, &state);
    pass_feedback(vpls->buffer.id, 0, pass->desc.count);
    vpl_pass_sum_up(pass, vpls);
    pass_end(frame->timers);
}
