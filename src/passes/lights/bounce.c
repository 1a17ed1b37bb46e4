#include "passes/lights/bounce.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "shared/bounce.h"
#include "shared/vpl.h"

#include <stdlib.h>
#include <string.h>

static int candidate_count(const struct bounce_pass *pass) {
    return pass->desc.count * BOUNCE_CANDIDATES;
}

static bool init_gather_program(GLuint *program, const struct bounce_desc *desc, bool candidates) {
    char *lookup = visibility_defines(&desc->visibility);
    char *defines =
        mem_printf("%s;MAP_PER_VPL %d;CANDIDATES %d", lookup, desc->map_per_vpl, candidates);
    bool ok = program_init(program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                           .fragment = "lights/bounce_gather.frag",
                                                           .defines = defines});
    free(lookup);
    free(defines);
    return ok;
}

static bool init_programs(struct bounce_pass *pass) {
    return init_gather_program(&pass->candidate_program, &pass->desc, true) &&
           init_gather_program(&pass->gather_program, &pass->desc, false) &&
           program_init(&pass->pick_program,
                        &(struct program_desc){.vertex = "lights/bounce_pick.vert"}) &&
           program_init(&pass->reflect_program,
                        &(struct program_desc){.vertex = "lights/bounce_reflect.vert"});
}

static bool init_light(struct texture *texture, int count, int rows) {
    return texture_init(texture, &(struct texture_desc){.label = "light of bounces",
                                                        .format = GL_RGBA32F,
                                                        .width = count,
                                                        .height = rows});
}

static bool init_targets(struct bounce_pass *pass) {
    int count = pass->desc.count;
    struct framebuffer_desc desc = {.label = "light of bounces"};
    desc.colors[TARGET_BOUNCE_LAST] = &pass->last;
    desc.colors[TARGET_BOUNCE_SUM] = &pass->sum;
    return init_light(&pass->candidate_light, count, BOUNCE_CANDIDATES) &&
           init_light(&pass->last, count, BOUNCE_ROWS) &&
           init_light(&pass->sum, count, BOUNCE_ROWS) &&
           framebuffer_init(&pass->candidate_framebuffer,
                            &(struct framebuffer_desc){.label = "light of candidates",
                                                       .colors = {&pass->candidate_light}}) &&
           framebuffer_init(&pass->framebuffer, &desc);
}

/* Passes of a picture that converges have candidates of their own. */
static void deal_candidates(struct bounce_pass *pass, const struct geometry *geometry,
                            int frame_pass) {
    int count = candidate_count(pass);
    surface_points_free(&pass->candidates);
    surface_points_init(&pass->candidates, &(struct surface_points_desc){
                                               .scene = pass->desc.scene,
                                               .geometry = geometry,
                                               .count = count,
                                               .first = (uint32_t)frame_pass * (uint32_t)count,
                                               .seed = pass->desc.seed,
                                               .solids = &pass->solids,
                                           });
    pass->dealt_pass = frame_pass;
    pass->pose = 0;
}

bool bounce_pass_init(struct bounce_pass *pass, const struct bounce_desc *desc) {
    *pass = (struct bounce_pass){.desc = *desc};
    int candidates = candidate_count(pass);
    solids_init(&pass->solids, desc->scene, desc->geometry);
    deal_candidates(pass, desc->geometry, 0);
    pass->room = mem_alloc((size_t)candidates, sizeof *pass->room);
    if (init_programs(pass) && init_targets(pass) &&
        vpl_buffer_init(&pass->places, "candidates of points", candidates) &&
        vpl_buffer_init(&pass->points, "surface points", desc->count) &&
        vpl_buffer_init(&pass->vpls, "VPLs of bounces", desc->count) &&
        buffer_init(&pass->lookup_params, "lookup parameters", sizeof(struct lookup_params), NULL))
        return true;
    bounce_pass_free(pass);
    return false;
}

void bounce_pass_free(struct bounce_pass *pass) {
    program_free(&pass->candidate_program);
    program_free(&pass->pick_program);
    program_free(&pass->gather_program);
    program_free(&pass->reflect_program);
    solids_free(&pass->solids);
    surface_points_free(&pass->candidates);
    free(pass->room);
    vpl_buffer_free(&pass->places);
    vpl_buffer_free(&pass->points);
    framebuffer_free(&pass->candidate_framebuffer);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->candidate_light);
    texture_free(&pass->last);
    texture_free(&pass->sum);
    vpl_buffer_free(&pass->vpls);
    buffer_free(&pass->lookup_params);
    *pass = (struct bounce_pass){0};
}

/* --- points ----------------------------------------------------------------------------------- */

/* Puts the candidates where the geometry is. */
static void place(struct bounce_pass *pass, const struct frame *frame) {
    if (pass->dealt_pass != frame->pass)
        deal_candidates(pass, frame->geometry, frame->pass);
    if (pass->pose == frame->geometry->pose_count)
        return;
    pass->pose = frame->geometry->pose_count;
    int count = candidate_count(pass);
    for (int i = 0; i < count; i++) {
        struct surface_place place = surface_points_place(&pass->candidates, frame->geometry, i);
        struct vpl *vpl = &pass->room[i];
        *vpl = (struct vpl){.area = place.area, .reach = 1};
        memcpy(vpl->position, place.position.raw, sizeof vpl->position);
        memcpy(vpl->normal, place.normal.raw, sizeof vpl->normal);
        memcpy(vpl->flux, place.albedo.raw, sizeof vpl->flux);
    }
    buffer_write(&pass->places.buffer, 0, (size_t)count * sizeof *pass->room, pass->room);
}

/* --- light ------------------------------------------------------------------------------------ */

static void draw_runs(GLuint program, const struct bounce_inputs *inputs, int first, int last) {
    for (struct vpl_run run = {.next = first}; vpl_run_next(&run, inputs->vpls, last);) {
        gl.ProgramUniform4i(program, LOCATION_SLOT, run.first, run.count, 0, 0);
        gl.ProgramUniform1i(program, LOCATION_FIRST_MAP, run.block - inputs->first);
        pass_draw_fullscreen(1);
    }
}

/* From the inputs' first VPLs, at most so many, with program and target of the state. */
static void gather(const struct bounce_pass *pass, struct pass_state state,
                   const struct bounce_inputs *inputs, int most) {
    int rest = inputs->vpls->count - inputs->first;
    int count = inputs->count ? inputs->count : rest;
    state.name = "bounces";
    state.width = pass->desc.count;
    state.blend = PASS_BLEND_ADD;
    visibility_add(&state, &pass->desc.visibility, &pass->lookup_params, &inputs->visibility);
    pass_set_state(&state);
    draw_runs(state.program, inputs, inputs->first, inputs->first + (count < most ? count : most));
}

static void light_candidates(const struct bounce_pass *pass, const struct bounce_inputs *inputs) {
    static const float none[4] = {0};
    framebuffer_clear_color(pass->candidate_framebuffer, TARGET_RESULT, none);
    gather(pass,
           (struct pass_state){
               .program = pass->candidate_program,
               .framebuffer = pass->candidate_framebuffer,
               .height = BOUNCE_CANDIDATES,
               .textures = {{UNIT_VPLS, pass->places.texels}},
           },
           inputs, BOUNCE_PICKING_VPLS);
}

void bounce_pass_pick(struct bounce_pass *pass, const struct frame *frame,
                      const struct bounce_inputs *inputs) {
    static const float none[4] = {0};
    timer_begin(frame->timers, "bounces");
    place(pass, frame);
    light_candidates(pass, inputs);
    pass_set_state(&(struct pass_state){
        .name = "bounces",
        .program = pass->pick_program,
        .textures = {{UNIT_VPLS, pass->places.texels}, {UNIT_IRRADIANCE, pass->candidate_light.id}},
    });
    pass_feedback(pass->points.buffer.id, 0, pass->desc.count);
    framebuffer_clear_color(pass->framebuffer, TARGET_BOUNCE_SUM, none);
    timer_end(frame->timers);
}

void bounce_pass_begin(const struct bounce_pass *pass) {
    static const float none[4] = {0};
    framebuffer_clear_color(pass->framebuffer, TARGET_BOUNCE_LAST, none);
}

void bounce_pass_gather(const struct bounce_pass *pass, const struct frame *frame,
                        const struct bounce_inputs *inputs) {
    timer_begin(frame->timers, "bounces");
    gather(pass,
           (struct pass_state){
               .program = pass->gather_program,
               .framebuffer = pass->framebuffer,
               .height = BOUNCE_ROWS,
               .textures = {{UNIT_VPLS, pass->points.texels}},
           },
           inputs, inputs->vpls->count);
    timer_end(frame->timers);
}

void bounce_pass_reflect(const struct bounce_pass *pass, const struct frame *frame, bool all) {
    timer_begin(frame->timers, "bounces");
    pass_set_state(&(struct pass_state){
        .name = "bounces",
        .program = pass->reflect_program,
        .vertex_array = pass->points.vertices,
        .textures = {{UNIT_IRRADIANCE, all ? pass->sum.id : pass->last.id}},
    });
    pass_feedback(pass->vpls.buffer.id, 0, pass->desc.count);
    timer_end(frame->timers);
}
