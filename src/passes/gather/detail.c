#include "passes/gather/detail.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/detail.h"

#include <assert.h>

/* A pixel this far off another's plane, over the picture's height there, is another surface. */
static const float plane_apart = .008F;

static bool init_picture(struct texture *texture, const char *label, int width, int height) {
    return texture_init(texture,
                        &(struct texture_desc){
                            .label = label, .format = GL_R32UI, .width = width, .height = height});
}

static bool init_lists(struct pixel_lists *lists, const struct detail_desc *desc) {
    int n = desc->interleave, size[2] = {desc->width, desc->height};
    assert(n * n * LIST_KINDS <= PIXEL_LISTS_MAX);
    pixel_lists_size(size, n);
    lists->interleave = n;
    lists->tile_width = size[0] / n;
    lists->tile_height = size[1] / n;
    return init_picture(&lists->pixels, "listed pixels", size[0], size[1]) &&
           init_picture(&lists->texels, "list texels", desc->width, desc->height) &&
           init_picture(&lists->further_texels, "further texels", desc->width, desc->height) &&
           buffer_init(&lists->counts, "list counts", PIXEL_LISTS_MAX * sizeof(GLuint), NULL);
}

bool detail_pass_init(struct detail_pass *pass, const struct detail_desc *desc) {
    *pass = (struct detail_pass){.desc = *desc};
    if (program_init(&pass->program,
                     &(struct program_desc){
                         .screen = {"gather/detail.frag"},
                         .defines = desc->block ? "SHARE_VISIBILITY 1" : "SHARE_VISIBILITY 0",
                     }) &&
        init_lists(&pass->lists, desc) &&
        framebuffer_init(
            &pass->framebuffer,
            &(struct framebuffer_desc){.label = "list texels", .colors = {&pass->lists.texels}}) &&
        buffer_init(&pass->params, "detail parameters", sizeof(struct detail_params), NULL))
        return true;
    detail_pass_free(pass);
    return false;
}

void detail_pass_free(struct detail_pass *pass) {
    program_free(&pass->program);
    framebuffer_free(&pass->framebuffer);
    texture_free(&pass->lists.pixels);
    texture_free(&pass->lists.texels);
    texture_free(&pass->lists.further_texels);
    buffer_free(&pass->lists.counts);
    buffer_free(&pass->params);
    *pass = (struct detail_pass){0};
}

static void write_params(const struct detail_pass *pass) {
    const struct detail_desc *desc = &pass->desc;
    static const GLuint none[PIXEL_LISTS_MAX] = {0};
    struct detail_params params = {
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

void detail_pass_render(const struct detail_pass *pass, const struct frame *frame,
                        const struct gbuffer *gbuffer) {
    static const GLuint unlisted[4] = {0};
    write_params(pass);
    pass_begin(
        frame->timers,
        &(struct pass_state){
            .name = "detail",
            .program = pass->program,
            .framebuffer = pass->framebuffer,
            .width = pass->desc.width,
            .height = pass->desc.height,
            .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                         {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                         {UNIT_SAMPLE_PICKS, frame->picks->id}},
            .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
            .storages = {{STORAGE_LIST_COUNTS, &pass->lists.counts}},
            .images = {{IMAGE_LISTED_PIXELS, &pass->lists.pixels, 0, GL_WRITE_ONLY},
                       {IMAGE_FURTHER_TEXELS, &pass->lists.further_texels, 0, GL_WRITE_ONLY}},
        });
    framebuffer_clear_integers(pass->framebuffer, TARGET_RESULT, unlisted);
    pass_draw_fullscreen(1);
    /* Later passes fetch the lists, and read their lengths as uniforms. */
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT);
    pass_end(frame->timers);
}
