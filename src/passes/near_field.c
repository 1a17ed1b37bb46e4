#include "passes/near_field.h"

#include "base/halton.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/params.h"

/* As many samples as each slot may have of its own; fewer slots' worth are shared. */
static int pattern_count(const struct near_field_desc *desc) {
    int slots = desc->interleave * desc->interleave, most = NEAR_SAMPLES_MAX / desc->samples;
    return slots < most ? slots : most;
}

static bool upload_samples(struct near_field_pass *pass) {
    float samples[NEAR_SAMPLES_MAX][4] = {{0}};
    for (uint32_t i = 0; i < NEAR_SAMPLES_MAX; i++) {
        samples[i][0] = (float)radical_inverse(2, i);
        samples[i][1] = (float)radical_inverse(3, i);
    }
    return buffer_init(&pass->samples, "near field samples", sizeof samples, samples);
}

bool near_field_pass_init(struct near_field_pass *pass, const struct near_field_desc *desc) {
    *pass = (struct near_field_pass){.desc = *desc};
    if (program_init(&pass->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                            .fragment = "near_field.frag"}) &&
        upload_samples(pass) &&
        buffer_init(&pass->params, "near field parameters", sizeof(struct near_field_params), NULL))
        return true;
    near_field_pass_free(pass);
    return false;
}

void near_field_pass_free(struct near_field_pass *pass) {
    program_free(&pass->program);
    buffer_free(&pass->samples);
    buffer_free(&pass->params);
    *pass = (struct near_field_pass){0};
}

static void write_params(const struct near_field_pass *pass, const struct frame *frame,
                         const struct irradiance *target) {
    struct near_field_params params = {
        .interleave = (float)target->interleave,
        .scale = frame->irradiance_scale,
        .tile_width = (float)target->tile_width,
        .tile_height = (float)target->tile_height,
        .vpl_share = frame->light_measure / (float)pass->desc.vpl_count,
        .reach = frame_near_reach(frame, pass->desc.vpl_count, pass->desc.reach),
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_PASS, pass->params.id);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, BLOCK_VPLS, pass->samples.id);
}

void near_field_pass_render(const struct near_field_pass *pass, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct gbuffer *rsm,
                            const struct irradiance *irradiance) {
    int n = irradiance->interleave, patterns = pattern_count(&pass->desc);
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "near field",
                                  .program = pass->program,
                                  .framebuffer = irradiance->framebuffer,
                                  .width = irradiance->texture.desc.width,
                                  .height = irradiance->texture.desc.height,
                                  .blend = PASS_BLEND_ADD,
                              });
    write_params(pass, frame, irradiance);
    gl.BindTextureUnit(0, gbuffer->depth.id);
    gl.BindTextureUnit(1, gbuffer->normal.id);
    gl.BindTextureUnit(2, rsm->depth.id);
    gl.BindTextureUnit(3, rsm->normal.id);
    gl.BindTextureUnit(4, rsm->albedo.id);
    for (int slot = 0; slot < n * n; slot++) {
        gl.Viewport(slot % n * irradiance->tile_width, slot / n * irradiance->tile_height,
                    irradiance->tile_width, irradiance->tile_height);
        gl.ProgramUniform4i(pass->program, 0, slot % patterns * pass->desc.samples,
                            pass->desc.samples, slot % n, slot / n);
        pass_draw_fullscreen(1);
    }
    pass_end(frame->timers);
}
