/* Constant ambient light, for tests and as an example: no VPLs, no maps, no blur, one compute pass.
 * The level is written as textures store irradiance. A technique with a value in W/m2 multiplies it
 * by frame->irradiance_scale first. */
#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "techniques/technique.h"

#include <stdlib.h>

struct ambient_settings {
    float level;
};

static const struct option table[] = {
    {"level", 0, OPTION_FLOAT, offsetof(struct ambient_settings, level), .25, 0, 100,
     .help = "irradiance, in what the light makes across the scene"},
    {NULL},
};

static const struct settings_part own_part = {"ambient", "ambient light", table,
                                              sizeof(struct ambient_settings)};

struct ambient {
    float level;
    GLuint program;
    struct irradiance irradiance;
};

static bool resize(void *state, int width, int height) {
    struct ambient *ambient = state;
    struct irradiance fresh;
    if (!irradiance_init(&fresh, "ambient", GL_RGBA16F, width, height, 1))
        return false;
    irradiance_free(&ambient->irradiance);
    ambient->irradiance = fresh;
    return true;
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct ambient_settings *own =
        settings_of(struct ambient_settings, desc->settings, &own_part);
    struct ambient *ambient = *state = mem_alloc(1, sizeof *ambient);
    ambient->level = own->level;
    return program_init(&ambient->program,
                        &(struct program_desc){.compute = "techniques/ambient/ambient.comp"}) &&
           resize(ambient, desc->width, desc->height);
}

static void free_state(void *state) {
    struct ambient *ambient = state;
    if (ambient) {
        program_free(&ambient->program);
        irradiance_free(&ambient->irradiance);
    }
    free(ambient);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct ambient *ambient = state;
    gl.ProgramUniform1f(ambient->program, 0, ambient->level);
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "ambient",
                                  .program = ambient->program,
                                  .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id}},
                                  .images = {{0, &ambient->irradiance.texture, 0, GL_WRITE_ONLY}},
                              });
    pass_dispatch((gbuffer->width + 7) / 8, (gbuffer->height + 7) / 8, 1);
    pass_end(frame->timers);
}

static struct contribution contribution(const void *state) {
    const struct ambient *ambient = state;
    return (struct contribution){.irradiance = &ambient->irradiance};
}

static const struct settings_part *const parts[] = {&own_part, NULL};

extern const struct technique ambient_technique;
const struct technique ambient_technique = {
    .name = "ambient",
    .help = "the same light everywhere",
    .parts = parts,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_view = render_view,
    .contribution = contribution,
};
