#include "passes/lights/cluster.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/cluster.h"
#include "shared/map_view.h"
#include "shared/vpl.h"

#include <cglm/util.h>
#include <stdio.h>
#include <string.h>

static bool init_row(struct texture *texture, const char *label, int count) {
    return texture_init(
        texture, &(struct texture_desc){.label = label, .format = GL_RGBA32F, .width = count});
}

static bool init_targets(struct val_targets *targets, int count) {
    return init_row(&targets->position, "VALs", count) &&
           init_row(&targets->normal, "VALs", count) && init_row(&targets->flux, "VALs", count) &&
           framebuffer_init(
               &targets->framebuffer,
               &(struct framebuffer_desc){.label = "VALs",
                                          .colors = {[TARGET_VAL_POSITION] = &targets->position,
                                                     [TARGET_VAL_NORMAL] = &targets->normal,
                                                     [TARGET_VAL_FLUX] = &targets->flux}});
}

static void free_targets(struct val_targets *targets) {
    framebuffer_free(&targets->framebuffer);
    texture_free(&targets->position);
    texture_free(&targets->normal);
    texture_free(&targets->flux);
}

static bool init_programs(struct cluster_pass *pass) {
    char defines[64];
    snprintf(defines, sizeof defines, "METRIC %d;SEEDED %d;WEIGHTED %d", pass->desc.metric,
             pass->desc.seeds != NULL, pass->desc.weights != NULL);
    struct {
        GLuint *program;
        struct program_desc desc;
    } rows[] = {
        {&pass->seed_program, {.screen = {"lights/cluster_seed.frag"}}},
        {&pass->scatter_program,
         {.vertex = "lights/cluster_scatter.vert", .fragment = "lights/cluster_scatter.frag"}},
        {&pass->divide_program, {.screen = {"lights/cluster_divide.frag"}}},
        {&pass->map_program, {.vertex = "lights/cluster_map.vert"}},
        /* Of views: */
        {&pass->extent_program,
         {.vertex = "lights/cluster_extent.vert", .fragment = "lights/cluster_extent.frag"}},
        {&pass->views_program, {.vertex = "lights/cluster_views.vert"}},
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
    int count = desc->val_count;
    if (init_programs(pass) && init_targets(&pass->centers[0], count) &&
        init_targets(&pass->centers[1], count) && init_targets(&pass->sums, count) &&
        init_views(pass) && vpl_buffer_init(&pass->vpls, "VPLs", desc->vpl_count) &&
        buffer_init(&pass->params, "cluster parameters", sizeof(struct cluster_params), NULL))
        return true;
    cluster_pass_free(pass);
    return false;
}

void cluster_pass_free(struct cluster_pass *pass) {
    GLuint *programs[] = {&pass->seed_program, &pass->scatter_program, &pass->divide_program,
                          &pass->map_program,  &pass->extent_program,  &pass->views_program};
    for (size_t i = 0; i < sizeof programs / sizeof *programs; i++)
        program_free(programs[i]);
    free_targets(&pass->centers[0]);
    free_targets(&pass->centers[1]);
    free_targets(&pass->sums);
    framebuffer_free(&pass->extremes_framebuffer);
    texture_free(&pass->extremes);
    vpl_buffer_free(&pass->vpls);
    buffer_free(&pass->views.buffer);
    buffer_free(&pass->params);
    *pass = (struct cluster_pass){0};
}

static void write_params(const struct cluster_pass *pass, const struct frame *frame) {
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
    };
    memcpy(params.bounds_min, frame->geometry->bounds_min, sizeof frame->geometry->bounds_min);
    memcpy(params.bounds_max, frame->geometry->bounds_max, sizeof frame->geometry->bounds_max);
    buffer_write(&pass->params, 0, sizeof params, &params);
}

/* A pixel a VAL, of all VALs' centres and VPLs. */
static struct pass_state row_state(const struct cluster_pass *pass, GLuint program,
                                   GLuint framebuffer, const struct val_targets *centers) {
    return (struct pass_state){
        .name = "clustering",
        .program = program,
        .framebuffer = framebuffer,
        .width = pass->desc.val_count,
        .height = 1,
        .textures = {{UNIT_VPLS, pass->vpl_texels},
                     {UNIT_VAL_POSITION, centers->position.id},
                     {UNIT_VAL_NORMAL, centers->normal.id},
                     {UNIT_VAL_FLUX, centers->flux.id},
                     {UNIT_VPL_SUMS, pass->vpl_sums}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    };
}

/* Where a shader reads seeds (lights/val_seed.glsl). */
static void add_seeds(struct pass_state *state, const struct cluster_pass *pass) {
    if (pass->desc.seeds)
        pass_add_texture(state, UNIT_SEEDS, pass->desc.seeds->id);
}

static void seed(const struct cluster_pass *pass) {
    struct pass_state state = {
        .name = "clustering",
        .program = pass->seed_program,
        .framebuffer = pass->centers[pass->last].framebuffer,
        .width = pass->desc.val_count,
        .height = 1,
        .textures = {{UNIT_VPLS, pass->vpl_texels}},
        .blocks = {{BLOCK_PASS, &pass->params}},
    };
    add_seeds(&state, pass);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

static void clear(GLuint framebuffer, int targets, float value) {
    const float color[4] = {value, value, value, value};
    for (int i = 0; i < targets; i++)
        framebuffer_clear_color(framebuffer, i, color);
}

/* The points scatter to their VALs' pixels. */
static void scatter(const struct cluster_pass *pass, GLuint program, GLuint framebuffer,
                    enum pass_blend blend, const struct vpl_buffer *vpls,
                    const struct val_targets *centers) {
    struct pass_state state = row_state(pass, program, framebuffer, centers);
    state.vertex_array = vpls->vertices;
    state.blend = blend;
    if (pass->desc.weights) {
        pass_add_texture(&state, UNIT_VPL_VALUES, pass->desc.weights->values.id);
        pass_add_texture(&state, UNIT_VPL_VALUE_SUM, pass->desc.weights->sum.id);
    }
    pass_set_state(&state);
    pass_draw(GL_POINTS, vpls->count, 1);
}

static void iterate(const struct cluster_pass *pass, const struct vpl_buffer *vpls,
                    const struct val_targets *old, const struct val_targets *new) {
    clear(pass->sums.framebuffer, 3, 0);
    scatter(pass, pass->scatter_program, pass->sums.framebuffer, PASS_BLEND_ADD, vpls, old);
    struct pass_state state = row_state(pass, pass->divide_program, new->framebuffer, old);
    pass_add_texture(&state, UNIT_SUM_POSITION, pass->sums.position.id);
    pass_add_texture(&state, UNIT_SUM_NORMAL, pass->sums.normal.id);
    pass_add_texture(&state, UNIT_SUM_FLUX, pass->sums.flux.id);
    add_seeds(&state, pass);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

const struct val_targets *cluster_pass_centers(const struct cluster_pass *pass) {
    return &pass->centers[pass->last];
}

void cluster_pass_map(const struct cluster_pass *pass, const struct vpl_buffer *vpls,
                      const struct vpl_buffer *to) {
    struct pass_state state = row_state(pass, pass->map_program, 0, cluster_pass_centers(pass));
    state.vertex_array = vpls->vertices;
    pass_set_state(&state);
    pass_feedback(to->buffer.id, 0, vpls->count);
    vpl_buffer_take_sums(to, vpls);
}

/* k-means; afterwards pass->last is where the means are. */
static void find_centers(struct cluster_pass *pass, const struct vpl_buffer *vpls) {
    pass->vpl_texels = vpls->texels;
    pass->vpl_sums = vpls->sums.id;
    if (pass->desc.start == CLUSTER_START_SEEDS || !pass->started)
        seed(pass);
    pass->started = true;
    for (int i = 0; i < pass->desc.iterations; i++) {
        if (pass->desc.means_of_map && i == pass->desc.iterations - 1)
            cluster_pass_map(pass, vpls, &pass->vpls);
        int next = 1 - pass->last;
        iterate(pass, vpls, &pass->centers[pass->last], &pass->centers[next]);
        pass->last = next;
    }
}

static void render_views(struct cluster_pass *pass) {
    const struct val_targets *centers = cluster_pass_centers(pass);
    clear(pass->extremes_framebuffer, 1, -1e30f);
    scatter(pass, pass->extent_program, pass->extremes_framebuffer, PASS_BLEND_MAX, &pass->vpls,
            centers);

    pass->vpl_texels = pass->vpls.texels;
    struct pass_state state = row_state(pass, pass->views_program, 0, centers);
    pass_add_texture(&state, UNIT_VAL_EXTREMES, pass->extremes.id);
    pass_set_state(&state);
    pass_feedback(pass->views.buffer.id, 0, pass->desc.val_count);
}

void cluster_pass_render(struct cluster_pass *pass, const struct frame *frame,
                         const struct vpl_buffer *vpls) {
    timer_begin(frame->timers, "clustering");
    write_params(pass, frame);
    find_centers(pass, vpls);
    if (!pass->desc.means_of_map)
        cluster_pass_map(pass, vpls, &pass->vpls);
    if (pass->desc.has_views)
        render_views(pass);
    timer_end(frame->timers);
}
