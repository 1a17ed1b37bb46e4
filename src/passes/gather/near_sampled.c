#include "passes/gather/near_sampled.h"

#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/lists.h"
#include "passes/sampled_lights.h"
#include "passes/vpls.h"
#include "shared/sampled_light.h"

#include <stdlib.h>

enum { RAYS = 1, ADAPTIVE_RAYS = 8 }; /* of a pixel */

static bool init_program(const struct near_sampled_pass *pass, GLuint *program, int receivers) {
    const struct near_sampled_desc *desc = &pass->desc;
    bool of_lists = receivers == RECEIVERS_ADAPTIVE;
    char *defines = mem_printf("%s%sRECEIVERS %d", light_defines(desc->medium, desc->slides),
                               desc->by_importance ? "BY_IMPORTANCE;" : "", receivers);
    bool ok = program_init(
        program, &(struct program_desc){
                     .vertex = of_lists ? "passes/gather/list_rows.vert" : NULL,
                     .screen = {"passes/gather/near_sampled.frag", .blended = true, .tiled = true},
                     .defines = defines});
    free(defines);
    return ok;
}

bool near_sampled_pass_init(struct near_sampled_pass *pass, const struct near_sampled_desc *desc) {
    *pass = (struct near_sampled_pass){.desc = *desc};
    if (init_program(pass, &pass->program, desc->adaptive ? RECEIVERS_OTHERS : RECEIVERS_ALL) &&
        (!desc->adaptive || init_program(pass, &pass->adaptive_program, RECEIVERS_ADAPTIVE)) &&
        buffer_init(&pass->params, "near field of sampled lights",
                    sizeof(struct near_sampled_params), NULL))
        return true;
    near_sampled_pass_free(pass);
    return false;
}

void near_sampled_pass_free(struct near_sampled_pass *pass) {
    programs_free(&pass->program, &pass->adaptive_program);
    buffer_free(&pass->params);
    *pass = (struct near_sampled_pass){0};
}

static int number_of_many(const struct frame *frame) {
    int i = 0;
    while (i < frame->emitters->count - 1 && frame->emitters->items[i].type != EMITTER_MANY)
        i++;
    return i;
}

static void draw_tiles(const struct near_sampled_pass *pass,
                       const struct near_sampled_inputs *inputs) {
    const struct irradiance *irradiance = inputs->irradiance;
    int n = irradiance->interleave;
    for (int slot = 0; slot < n * n; slot++) {
        irradiance_view_tile(irradiance, slot);
        pass_set_ints(LOCATION_SLOT, 0, 0, slot % n, slot / n);
        if (!inputs->of_lists)
            pass_draw_fullscreen(1);
        for (int list = 0; inputs->of_lists && list < LIST_KINDS; list++)
            if (pass->desc.list_slots[list] > 0)
                pixel_lists_draw(inputs->lists, list);
    }
}

void near_sampled_pass_render(const struct near_sampled_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer,
                              const struct near_sampled_inputs *inputs) {
    const struct irradiance *irradiance = inputs->irradiance;
    const struct near_sampled_params params = {
        .pattern = irradiance_pattern(irradiance),
        .many = number_of_many(frame),
        .rays = inputs->of_lists ? ADAPTIVE_RAYS : RAYS,
        .scale = frame->irradiance_scale,
        .pass = frame->pass,
    };
    struct pass_state state = {
        .name = "near field, sampled",
        .program = inputs->of_lists ? pass->adaptive_program : pass->program,
        .framebuffer = irradiance->framebuffer,
        .width = irradiance->texture.desc.width,
        .height = irradiance->texture.desc.height,
        .blend = PASS_BLEND_ADD,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_VPL_SHARES, inputs->shares},
                   {BLOCK_PASS, &pass->params}},
    };
    frame_add_light(frame, &state);
    light_rays_add(&state, inputs->rays);
    sampled_lights_add(frame->sampled, &state);
    if (pass->desc.by_importance)
        pass_add_texture(&state, UNIT_VPL_DENSITY, inputs->importance->densities.id);
    pixel_lists_add(&state, inputs->lists,
                    inputs->of_lists      ? RECEIVERS_ADAPTIVE
                    : pass->desc.adaptive ? RECEIVERS_OTHERS
                                          : RECEIVERS_ALL,
                    frame->edge_samples);
    buffer_write(&pass->params, 0, sizeof params, &params);
    pass_begin(frame->timers, &state);
    draw_tiles(pass, inputs);
    pass_end(frame->timers);
}
