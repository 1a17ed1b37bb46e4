#include "passes/gather.h"

#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/map_view.h"
#include "shared/params.h"
#include "shared/vpl.h"

#include <math.h>
#include <stdlib.h>

/* Uniform ranges begin at multiples of 256 bytes, which are 16 VPLs. */
enum { VPL_ALIGNMENT = 16 };

bool gather_pass_init(struct gather_pass *pass, const struct gather_desc *desc) {
    *pass = (struct gather_pass){.desc = *desc};
    int terms = desc->basis_terms > 0 ? desc->basis_terms : 1;
    char *defines = mem_printf("VISIBILITY %d;CLAMP %d;MAP_PER_VPL %d;MAP_COUNT %d;"
                               "BASIS_TERMS %d;BASIS_GROUPS %d;FILTER_JACOBIAN %d;SHARPEN %d",
                               desc->visibility, desc->clamp, desc->map_per_vpl, desc->map_count,
                               terms, (terms + 3) / 4, desc->filter_jacobian, desc->sharpen_a > 0);
    bool ok = program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                                  .fragment = "gather.frag",
                                                                  .defines = defines}) &&
              irradiance_init(&pass->irradiance, "gathered irradiance", desc->width, desc->height,
                              desc->interleave) &&
              buffer_init(&pass->params, "gather parameters", sizeof(struct gather_params), NULL);
    free(defines);
    if (!ok)
        gather_pass_free(pass);
    return ok;
}

void gather_pass_free(struct gather_pass *pass) {
    program_free(&pass->program);
    irradiance_free(&pass->irradiance);
    buffer_free(&pass->params);
    *pass = (struct gather_pass){0};
}

void gather_pass_clear(const struct gather_pass *pass) {
    static const float zero[4] = {0};
    gl.ClearNamedFramebufferfv(pass->irradiance.framebuffer, GL_COLOR, 0, zero);
}

static void write_params(const struct gather_pass *pass, const struct frame *frame) {
    const struct gather_desc *desc = &pass->desc;
    const struct irradiance *target = &pass->irradiance;
    struct gather_params params = {
        .interleave = (float)target->interleave,
        .scale = frame->irradiance_scale,
        .tile_width = (float)target->tile_width,
        .tile_height = (float)target->tile_height,
        .bias = desc->bias * frame->radius,
        .clamp_at = desc->clamp_value / (frame->radius * frame->radius),
        .map_size = (float)desc->map_size,
        .shift = desc->shift / (2 * fmaxf((float)desc->basis_terms, 1)),
        .gain = desc->gain,
        .sharpen_a = desc->sharpen_a,
        .sharpen_b = desc->sharpen_b,
        .map_bias = desc->map_bias * frame->radius,
        .reach = desc->reach,
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_PASS, pass->params.id);
}

static void bind_inputs(const struct gather_pass *pass, const struct gbuffer *gbuffer,
                        const struct gather_inputs *inputs) {
    gl.BindTextureUnit(0, gbuffer->depth.id);
    gl.BindTextureUnit(1, gbuffer->normal.id);
    if (pass->desc.visibility == GATHER_VISIBILITY_NONE)
        return;
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_MAPS, inputs->views->buffer.id);
    if (pass->desc.visibility == GATHER_VISIBILITY_HARD) {
        gl.BindTextureUnit(2, inputs->depth->depth.id);
        return;
    }
    gl.BindTextureUnit(2, inputs->bases->cos.id);
    gl.BindTextureUnit(3, inputs->bases->sin.id);
    gl.BindTextureUnit(4, inputs->bases->z_cos.id);
    gl.BindTextureUnit(5, inputs->bases->z_sin.id);
    gl.BindTextureUnit(6, inputs->bases->z.id);
}

/* VPLs first .. last of a slot, in runs that fit one uniform block. */
static void draw_run(const struct gather_pass *pass, const struct gather_inputs *inputs, int slot,
                     int first, int last) {
    int n = pass->desc.interleave;
    for (int at = first, block; at < last; at = block + VPLS_PER_BLOCK) {
        block = at / VPL_ALIGNMENT * VPL_ALIGNMENT;
        int end = block + VPLS_PER_BLOCK < last ? block + VPLS_PER_BLOCK : last;
        gl.BindBufferRange(GL_UNIFORM_BUFFER, BLOCK_VPLS, inputs->vpls->buffer.id,
                           (GLintptr)((size_t)block * sizeof(struct vpl)),
                           VPLS_PER_BLOCK * sizeof(struct vpl));
        gl.ProgramUniform4i(pass->program, 0, at - block, end - at, slot % n, slot / n);
        gl.ProgramUniform1i(pass->program, 2, block - inputs->first);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
}

/* Slot s of S has VPLs s N / S .. (s + 1) N / S. */
static void draw_slot(const struct gather_pass *pass, const struct gather_inputs *inputs,
                      int slot) {
    const struct irradiance *target = &pass->irradiance;
    int n = pass->desc.interleave, slots = n * n, total = inputs->vpls->count;
    int first = (int)((long)slot * total / slots), last = (int)((long)(slot + 1) * total / slots);
    float weight = (float)total / (float)(last - first);
    int range_last = inputs->count ? inputs->first + inputs->count : total;
    if (first < inputs->first)
        first = inputs->first;
    if (last > range_last)
        last = range_last;
    if (first >= last)
        return;
    gl.Viewport(slot % n * target->tile_width, slot / n * target->tile_height, target->tile_width,
                target->tile_height);
    gl.ProgramUniform1f(pass->program, 1, weight);
    draw_run(pass, inputs, slot, first, last);
}

void gather_pass_render(const struct gather_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs) {
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "gather",
                                  .program = pass->program,
                                  .framebuffer = pass->irradiance.framebuffer,
                                  .width = pass->irradiance.texture.desc.width,
                                  .height = pass->irradiance.texture.desc.height,
                                  .blend = PASS_BLEND_ADD,
                              });
    write_params(pass, frame);
    bind_inputs(pass, gbuffer, inputs);
    for (int slot = 0; slot < pass->desc.interleave * pass->desc.interleave; slot++)
        draw_slot(pass, inputs, slot);
    pass_end(frame->timers);
}
