#include "passes/lights/cluster.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/cluster.h"
#include "shared/maps.h"

#include <cglm/util.h>
#include <stdio.h>
#include <string.h>

enum { VAL_ROWS = 3 }; /* of sums: position, normal, flux */

static bool init_row(struct texture *texture, const char *label, int count) {
    return texture_init(
        texture, &(struct texture_desc){.label = label, .format = GL_RGBA32F, .width = count});
}

static bool init_vals(struct cluster_pass *pass) {
    const struct texture_desc sums = {.label = "sums of VALs",
                                      .format = GL_RGBA32F,
                                      .width = pass->desc.val_count,
                                      .height = VAL_ROWS};
    return init_row(&pass->vals.position, "VALs", pass->desc.val_count) &&
           init_row(&pass->vals.normal, "VALs", pass->desc.val_count) &&
           init_row(&pass->vals.flux, "VALs", pass->desc.val_count) &&
           texture_init(&pass->sums, &sums);
}

static bool init_programs(struct cluster_pass *pass) {
    char defines[64];
    snprintf(defines, sizeof defines, "METRIC %d;SEEDED %d;WEIGHTED %d", pass->desc.metric,
             pass->desc.seeds != NULL, pass->desc.weights != NULL);
    struct {
        GLuint *program;
        struct program_desc desc;
    } rows[] = {
        {&pass->means_program, {.compute = "passes/lights/cluster_means.comp"}},
        {&pass->map_program, {.vertex = "passes/lights/cluster_map.vert"}},
        /* Of views: */
        {&pass->extent_program,
         {.vertex = "passes/lights/cluster_extent.vert", .fragment = "passes/lights/point.frag"}},
        {&pass->views_program, {.vertex = "passes/lights/cluster_views.vert"}},
    };
    size_t count = sizeof rows / sizeof *rows;
    for (size_t i = 0; i < (pass->desc.has_views ? count : count - 2); i++) {
        rows[i].desc.defines = defines;
        if (!program_init(rows[i].program, &rows[i].desc))
            return false;
    }
    return true;
}

static bool init_views(struct cluster_pass *pass) {
    pass->views.count = pass->desc.val_count;
    return !pass->desc.has_views ||
           (init_row(&pass->extremes, "VALs", pass->desc.val_count) &&
            framebuffer_init(
                &pass->extremes_framebuffer,
                &(struct framebuffer_desc){.label = "VAL extremes", .colors = {&pass->extremes}}) &&
            buffer_init(&pass->views.buffer, "map views", MAP_VIEWS_MAX * sizeof(struct map_view),
                        NULL));
}

bool cluster_pass_init(struct cluster_pass *pass, const struct cluster_desc *desc) {
    *pass = (struct cluster_pass){.desc = *desc};
    if (init_programs(pass) && init_vals(pass) && init_views(pass) &&
        vpl_buffer_init(&pass->vpls, "VPLs", desc->vpl_count) &&
        buffer_init(&pass->params, "cluster parameters", sizeof(struct cluster_params), NULL))
        return true;
    cluster_pass_free(pass);
    return false;
}

void cluster_pass_free(struct cluster_pass *pass) {
    GLuint *programs[] = {&pass->means_program, &pass->map_program, &pass->extent_program,
                          &pass->views_program};
    for (size_t i = 0; i < sizeof programs / sizeof *programs; i++)
        program_free(programs[i]);
    textures_free(&pass->vals.position, &pass->vals.normal, &pass->vals.flux, &pass->sums);
    framebuffer_free(&pass->extremes_framebuffer);
    texture_free(&pass->extremes);
    vpl_buffer_free(&pass->vpls);
    buffers_free(&pass->views.buffer, &pass->params);
    *pass = (struct cluster_pass){0};
}

/* What a dispatch of k-means does: iterations, or a part of one. */
struct steps {
    bool seeds;
    int iterations, first_vpl;
};

static void write_params(const struct cluster_pass *pass, const struct frame *frame,
                         const struct steps *steps) {
    const struct cluster_desc *desc = &pass->desc;
    bool squares = desc->metric == CLUSTER_METRIC_SQUARES;
    struct cluster_params params = {
        .weight_position = desc->weight_position,
        .weight_normal = squares ? desc->weight_normal : desc->weight_normal / (float)GLM_PI,
        .weight_flux = desc->weight_flux,
        .val_count = desc->val_count,
        .vpl_count = desc->vpl_count,
        .near_clip = desc->near_clip,
        .reseed = desc->start == CLUSTER_START_RESEED,
        .seeds = steps->seeds,
        .iterations = steps->iterations,
        .first_vpl = steps->first_vpl,
    };
    memcpy(params.bounds_min, frame->geometry->bounds_min, sizeof frame->geometry->bounds_min);
    memcpy(params.bounds_max, frame->geometry->bounds_max, sizeof frame->geometry->bounds_max);
    buffer_write(&pass->params, 0, sizeof params, &params);
}

/* Of VALs and VPLs, a pixel a VAL. */
static struct pass_state state_of(const struct cluster_pass *pass, GLuint program) {
    return (struct pass_state){
        .name = "clustering",
        .program = program,
        .width = pass->desc.val_count,
        .height = 1,
        .textures = {{UNIT_VPLS, pass->vpl_texels},
                     {UNIT_VAL_POSITION, pass->vals.position.id},
                     {UNIT_VAL_NORMAL, pass->vals.normal.id},
                     {UNIT_VAL_FLUX, pass->vals.flux.id},
                     {UNIT_VPL_SUMS, pass->vpl_sums}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    };
}

static void take_steps(const struct cluster_pass *pass, const struct frame *frame,
                       const struct steps *steps) {
    const struct cluster_desc *desc = &pass->desc;
    struct pass_state state = {
        .name = "clustering",
        .program = pass->means_program,
        .textures = {{UNIT_VPLS, pass->vpl_texels}, {UNIT_VPL_SUMS, pass->vpl_sums}},
        .blocks = {{BLOCK_PASS, &pass->params}},
        .images = {{IMAGE_VAL_POSITION, &pass->vals.position, 0, GL_READ_WRITE},
                   {IMAGE_VAL_NORMAL, &pass->vals.normal, 0, GL_READ_WRITE},
                   {IMAGE_VAL_FLUX, &pass->vals.flux, 0, GL_READ_WRITE},
                   {IMAGE_VAL_SUMS, &pass->sums, 0, GL_READ_WRITE}},
        .barriers = GL_SHADER_IMAGE_ACCESS_BARRIER_BIT,
    };
    if (desc->seeds)
        pass_add_texture(&state, UNIT_SEEDS, desc->seeds->id);
    if (desc->weights) {
        pass_add_texture(&state, UNIT_VPL_VALUES, desc->weights->values.id);
        pass_add_texture(&state, UNIT_VPL_VALUE_SUM, desc->weights->sum.id);
    }
    write_params(pass, frame, steps);
    pass_set_state(&state);
    pass_dispatch(1, 1, 1);
}

/* So many iterations of k-means, from the seeds or from the means of before: as many in a dispatch
 * as it may take. */
static void iterate(const struct cluster_pass *pass, const struct frame *frame, bool seeds,
                    int iterations) {
    const int vpls = pass->desc.vpl_count, groups = (vpls + CLUSTER_GROUP - 1) / CLUSTER_GROUP;
    const int most = CLUSTER_GROUPS_MAX(pass->desc.val_count);
    const int whole = groups < most ? most / groups : 1;
    struct steps steps = {.seeds = seeds};
    for (int done = 0; done == 0 || done < iterations; done += whole) {
        steps.iterations = whole < iterations - done ? whole : iterations - done;
        for (int first = 0; first < vpls; first += most * CLUSTER_GROUP) {
            steps.first_vpl = first;
            take_steps(pass, frame, &steps);
            steps.seeds = false;
        }
    }
    /* Passes fetch the VALs; inspect/ copies them. */
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

const struct val_targets *cluster_pass_centers(const struct cluster_pass *pass) {
    return &pass->vals;
}

void cluster_pass_map(const struct cluster_pass *pass, const struct vpl_buffer *vpls,
                      const struct vpl_buffer *to) {
    struct pass_state state = state_of(pass, pass->map_program);
    state.vertex_array = vpls->vertices;
    pass_set_state(&state);
    pass_feedback(to->buffer.id, 0, vpls->count);
    vpl_buffer_take_sums(to, vpls);
}

/* k-means. */
static void find_centers(struct cluster_pass *pass, const struct frame *frame,
                         const struct vpl_buffer *vpls) {
    bool seeds = pass->desc.start == CLUSTER_START_SEEDS || !pass->started;
    int before_map = pass->desc.iterations - (pass->desc.means_of_map ? 1 : 0);
    pass->vpl_texels = vpls->buffer.texels;
    pass->vpl_sums = vpls->sums.id;
    pass->started = true;
    iterate(pass, frame, seeds, before_map);
    cluster_pass_map(pass, vpls, &pass->vpls);
    if (pass->desc.means_of_map)
        iterate(pass, frame, false, 1);
}

static void find_extents(const struct cluster_pass *pass) {
    static const float none[4] = {-1e30f, -1e30f, -1e30f, -1e30f};
    struct pass_state state = state_of(pass, pass->extent_program);
    state.framebuffer = pass->extremes_framebuffer;
    state.vertex_array = pass->vpls.vertices;
    state.blend = PASS_BLEND_MAX;
    framebuffer_clear_color(pass->extremes_framebuffer, TARGET_RESULT, none);
    pass_set_state(&state);
    pass_draw(GL_POINTS, pass->vpls.count, 1);
}

static void write_views(struct cluster_pass *pass) {
    pass->vpl_texels = pass->vpls.buffer.texels;
    struct pass_state state = state_of(pass, pass->views_program);
    pass_add_texture(&state, UNIT_VAL_EXTREMES, pass->extremes.id);
    pass_set_state(&state);
    pass_feedback(pass->views.buffer.id, 0, pass->desc.val_count);
}

void cluster_pass_render(struct cluster_pass *pass, const struct frame *frame,
                         const struct vpl_buffer *vpls) {
    timer_begin(frame->timers, "clustering");
    find_centers(pass, frame, vpls);
    if (pass->desc.has_views) {
        find_extents(pass);
        write_views(pass);
    }
    timer_end(frame->timers);
}
