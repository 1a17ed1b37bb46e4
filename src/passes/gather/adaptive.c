#include "passes/gather/adaptive.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/gather.h"

#include <assert.h>

/* A pixel this far off another's plane, over the picture's height there, is another surface. */
static const float plane_apart = .008F;

static bool init_picture(struct texture *texture, const char *label, int width, int height) {
    return texture_init(texture,
                        &(struct texture_desc){
                            .label = label, .format = GL_R32UI, .width = width, .height = height});
}

static bool init_lists(struct pixel_lists *lists, const struct adaptive_desc *desc) {
    int n = desc->interleave, size[2] = {desc->width, desc->height};
    assert(n * n * LIST_KINDS <= PIXEL_LISTS_MAX);
    pixel_lists_size(size, n);
    lists->interleave = n;
    lists->tile_width = size[0] / n;
    lists->tile_height = size[1] / n;
    return init_picture(&lists->pixels, "adaptive pixels", size[0], size[1]) &&
           init_picture(&lists->texels, "list texels", desc->width, desc->height) &&
           init_picture(&lists->edge_sample_texels, "edge sample texels", desc->width,
                        desc->height) &&
           buffer_init(&lists->counts, "list counts", PIXEL_LISTS_MAX * sizeof(GLuint), NULL);
}

bool adaptive_pass_init(struct adaptive_pass *pass, const struct adaptive_desc *desc) {
    *pass = (struct adaptive_pass){.desc = *desc};
    if (program_init(&pass->program,
                     &(struct program_desc){
                         .screen = {"passes/gather/adaptive.frag"},
                         .defines = desc->block ? "SHARE_VISIBILITY 1" : "SHARE_VISIBILITY 0",
                     }) &&
        init_lists(&pass->lists, desc) &&
        framebuffer_init(
            &pass->framebuffer,
            &(struct framebuffer_desc){.label = "list texels", .colors = {&pass->lists.texels}}) &&
        buffer_init(&pass->params, "adaptive pixels' parameters", sizeof(struct adaptive_params),
                    NULL))
        return true;
    adaptive_pass_free(pass);
    return false;
}

void adaptive_pass_free(struct adaptive_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    textures_free(&pass->lists.pixels, &pass->lists.texels, &pass->lists.edge_sample_texels);
    buffers_free(&pass->lists.counts, &pass->params);
    *pass = (struct adaptive_pass){0};
}

static void write_params(const struct adaptive_pass *pass) {
    const struct adaptive_desc *desc = &pass->desc;
    static const GLuint none[PIXEL_LISTS_MAX] = {0};
    struct adaptive_params params = {
        .pattern = {.tile = {pass->lists.tile_width, pass->lists.tile_height},
                    .n = desc->interleave},
        .distance = desc->distance,
        .cosine = desc->cosine,
        .apart = plane_apart,
        .fewest = desc->share * 4,
        .radius = desc->radius,
        .block = desc->block,
        .sharp_cosine = desc->sharp_cosine,
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
    buffer_write(&pass->lists.counts, 0, sizeof none, none);
}

void adaptive_pass_render(const struct adaptive_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer) {
    static const GLuint none[4] = {0};
    write_params(pass);
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "adaptive",
                   .program = pass->program,
                   .framebuffer = pass->framebuffer,
                   .width = pass->desc.width,
                   .height = pass->desc.height,
                   .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                                {UNIT_SAMPLE_ASSIGNMENT, frame->assignment->id}},
                   .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
                   .storages = {{STORAGE_LIST_COUNTS, &pass->lists.counts}},
                   .images = {{IMAGE_ADAPTIVE_PIXELS, &pass->lists.pixels, 0, GL_WRITE_ONLY},
                              {IMAGE_EDGE_SAMPLE_TEXELS, &pass->lists.edge_sample_texels, 0,
                               GL_WRITE_ONLY}},
               });
    framebuffer_clear_integers(pass->framebuffer, TARGET_RESULT, none);
    pass_draw_fullscreen(1);
    /* Later passes fetch the lists, and read their lengths as uniforms; the next frame clears
     * these. */
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT |
                     GL_BUFFER_UPDATE_BARRIER_BIT);
    pass_end(frame->timers);
}
