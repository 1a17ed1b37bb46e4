#include "passes/visibility/basis.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/maps.h"

#include <cglm/cglm.h>

#include <math.h>
#include <stdlib.h>

static bool init_map(struct texture *texture, const char *label, GLenum format, int layers,
                     const struct basis_maps *maps) {
    return texture_init(texture, &(struct texture_desc){
                                     .label = label,
                                     .target = GL_TEXTURE_2D_ARRAY,
                                     .format = format,
                                     .width = maps->size,
                                     .height = maps->size,
                                     .layers = layers,
                                     .levels = texture_full_levels(maps->size, maps->size),
                                     .filter = FILTER_TRILINEAR,
                                 });
}

static bool init_mips(struct basis_maps *maps) {
    int layers = maps->count * maps->groups;
    return init_map(&maps->cos, "basis", GL_RGBA8, layers, maps) &&
           init_map(&maps->sin, "basis", GL_RGBA8, layers, maps) &&
           init_map(&maps->z_cos, "basis z", GL_RGBA16F, layers, maps) &&
           init_map(&maps->z_sin, "basis z", GL_RGBA16F, layers, maps) &&
           init_map(&maps->z, "basis z", GL_R16F, maps->count, maps);
}

static bool init_params(struct basis_pass *pass) {
    for (int group = 0; group < pass->maps.groups; group++) {
        struct basis_params params = {.first_term = 4 * group};
        if (!buffer_init(&pass->params[group], "basis parameters", sizeof params, &params))
            return false;
    }
    return true;
}

static bool init_ranges(struct basis_pass *pass) {
    char *defines = mem_printf("BASIS_TERMS %d", pass->maps.terms);
    bool ok = program_init(&pass->range_program,
                           &(struct program_desc){.compute = "passes/visibility/series_range.comp",
                                                  .defines = defines}) &&
              buffer_init(&pass->maps.ranges, "series ranges",
                          SERIES_RANGES_MAX * sizeof(struct series_range), NULL);
    free(defines);
    return ok;
}

/* What draws bases, to MIP maps. */
static bool init_drawing(struct basis_pass *pass) {
    struct basis_maps *maps = &pass->maps;
    struct framebuffer_desc first = {.label = "basis"}, more = {.label = "basis"};
    first.colors[TARGET_BASIS_COS] = more.colors[TARGET_BASIS_COS] = &maps->cos;
    first.colors[TARGET_BASIS_SIN] = more.colors[TARGET_BASIS_SIN] = &maps->sin;
    first.colors[TARGET_BASIS_Z_COS] = more.colors[TARGET_BASIS_Z_COS] = &maps->z_cos;
    first.colors[TARGET_BASIS_Z_SIN] = more.colors[TARGET_BASIS_Z_SIN] = &maps->z_sin;
    first.colors[TARGET_BASIS_Z] = &maps->z;
    char *defines = mem_printf("BASIS_TERMS %d", maps->terms);
    bool ok = program_init(
                  &pass->program,
                  &(struct program_desc){.screen = {"passes/visibility/basis.frag", .layers = true},
                                         .defines = defines}) &&
              init_mips(maps) && framebuffer_init(&pass->first_framebuffer, &first) &&
              framebuffer_init(&pass->more_framebuffer, &more) && init_params(pass);
    free(defines);
    return ok;
}

static double step_at(int terms, double t) {
    double sum = .5;
    for (int k = 0; k < terms; k++)
        sum += 2 * sin(GLM_PI * (2 * k + 1) * t) / (GLM_PI * (2 * k + 1));
    return sum;
}

/* Its slope is sin(2 pi K t) / sin(pi t): it climbs between -1 / (2K) and 1 / (2K), and then falls
 * as far again. */
struct series_step series_step_of(int terms) {
    double low = -.5 / terms, high = 0;
    for (int i = 0; i < 50; i++) {
        double middle = (low + high) / 2;
        *(step_at(terms, middle) < 0 ? &low : &high) = middle;
    }
    return (struct series_step){-low, step_at(terms, 1. / terms)};
}

bool basis_pass_init(struct basis_pass *pass, const struct basis_desc *desc) {
    *pass = (struct basis_pass){.maps = {.size = desc->size,
                                         .count = desc->count,
                                         .groups = (desc->terms + 3) / 4,
                                         .terms = desc->terms}};
    if (init_ranges(pass) && (desc->ranges_alone || init_drawing(pass)))
        return true;
    basis_pass_free(pass);
    return false;
}

void basis_pass_free(struct basis_pass *pass) {
    programs_free(&pass->range_program, &pass->program);
    framebuffers_free(&pass->first_framebuffer, &pass->more_framebuffer);
    textures_free(&pass->maps.cos, &pass->maps.sin, &pass->maps.z_cos, &pass->maps.z_sin,
                  &pass->maps.z);
    buffer_free(&pass->maps.ranges);
    for (int i = 0; i < 4; i++)
        buffer_free(&pass->params[i]);
    *pass = (struct basis_pass){0};
}

static void build_mips(const struct basis_pass *pass, const struct frame *frame) {
    const struct basis_maps *maps = &pass->maps;
    timer_begin(frame->timers, "mips");
    gl.GenerateTextureMipmap(maps->cos.id);
    gl.GenerateTextureMipmap(maps->sin.id);
    gl.GenerateTextureMipmap(maps->z_cos.id);
    gl.GenerateTextureMipmap(maps->z_sin.id);
    gl.GenerateTextureMipmap(maps->z.id);
    timer_end(frame->timers);
}

static void find_ranges(const struct basis_pass *pass, const struct frame *frame,
                        const struct texture *depth) {
    pass_begin(frame->timers, &(struct pass_state){
                                  .name = "range",
                                  .program = pass->range_program,
                                  .textures = {{UNIT_MAP_DEPTH, depth->id}},
                                  .storages = {{STORAGE_SERIES_RANGES, &pass->maps.ranges}},
                              });
    pass_dispatch(pass->maps.count, 1, 1);
    /* Later passes read the ranges as uniforms. */
    gl.MemoryBarrier(GL_UNIFORM_BARRIER_BIT);
    pass_end(frame->timers);
}

static void draw_bases(const struct basis_pass *pass, const struct frame *frame,
                       const struct texture *depth) {
    struct pass_state state = {
        .name = "basis",
        .program = pass->program,
        .framebuffer = pass->first_framebuffer,
        .width = pass->maps.size,
        .height = pass->maps.size,
        .textures = {{UNIT_MAP_DEPTH, depth->id}},
        .blocks = {{BLOCK_PASS, &pass->params[0]}, {BLOCK_SERIES_RANGES, &pass->maps.ranges}},
    };
    pass_begin(frame->timers, &state);
    for (int group = 0; group < pass->maps.groups; group++) {
        if (group > 0) {
            state.framebuffer = pass->more_framebuffer;
            state.blocks[0].buffer = &pass->params[group];
            pass_set_state(&state);
        }
        gl.ProgramUniform1i(pass->program, LOCATION_FIRST_LAYER, group * pass->maps.count);
        pass_draw_fullscreen(pass->maps.count);
    }
    pass_end(frame->timers);
}

void basis_pass_render(const struct basis_pass *pass, const struct frame *frame,
                       const struct texture *depth) {
    find_ranges(pass, frame, depth);
    if (pass->program) {
        draw_bases(pass, frame, depth);
        build_mips(pass, frame);
    }
}
