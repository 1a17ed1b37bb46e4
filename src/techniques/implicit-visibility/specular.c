#include "techniques/implicit-visibility/specular.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/unit.h"
#include "gl/program.h"
#include "passes/frame.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char label[] = "specular light of elements";

/* Texels of an element: how many links it has, and each. */
static int stride_of(int side) {
    return links_stride(side) + 1;
}

bool specular_target_init(struct irradiance *radiance, int width, int height) {
    return irradiance_init(radiance, label, GL_RGBA32F, width, height, 1);
}

bool specular_pass_init(struct specular_pass *pass, int side, int width, int height) {
    char defines[48];
    *pass = (struct specular_pass){.side = side};
    snprintf(defines, sizeof defines, "SIDE %d;STRIDE %d", side, stride_of(side));
    if (program_init(&pass->program,
                     &(struct program_desc){
                         .screen = {"techniques/implicit-visibility/specular.frag"},
                         .defines = defines,
                     }) &&
        specular_target_init(&pass->radiance, width, height))
        return true;
    specular_pass_free(pass);
    return false;
}

static void free_room(struct specular_pass *pass) {
    buffer_free(&pass->links);
    free(pass->texels);
    pass->texels = NULL;
}

void specular_pass_free(struct specular_pass *pass) {
    free_room(pass);
    program_free(&pass->program);
    irradiance_free(&pass->radiance);
    *pass = (struct specular_pass){0};
}

/* A shader may read no more of a storage. */
static bool fits_storage(size_t bytes, int element_count, int side) {
    GLint64 most = 0;
    gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    return bytes <= (size_t)most ||
           error_set(
               "radiosity.specular: links of %d surface elements, %d bins a side, are %.0f MiB, "
               "and a storage of this GPU has %.0f: use fewer radiosity.elements or "
               "radiosity.bins",
               element_count, side, (double)bytes / (1 << 20), (double)most / (1 << 20));
}

bool specular_pass_fit(struct specular_pass *pass, int element_count) {
    size_t count = (size_t)element_count * (size_t)stride_of(pass->side);
    free_room(pass);
    if (!fits_storage(count * sizeof *pass->texels, element_count, pass->side))
        return false;
    if (!mem_check(count * sizeof *pass->texels))
        return error_prefix("specular light of %d surface elements", element_count);
    pass->texels = mem_alloc(count, sizeof *pass->texels);
    return buffer_init(&pass->links, "links of elements", count * sizeof *pass->texels, NULL);
}

/* 16 bits each. */
static uint32_t octahedral(vec3s n) {
    float code[2];
    octahedral_encode(n.raw, code);
    return (uint32_t)lroundf(code[0] * 65535) | (uint32_t)lroundf(code[1] * 65535) << 16;
}

struct writing {
    const struct links *links;
    const struct specular_light *light;
    uint32_t (*texels)[4]; /* of all leaves */
};

/* A leaf's part of it. */
struct leaf_writing {
    const struct writing *all;
    mat3s to_world;
    uint32_t (*texels)[4]; /* their number, then they */
};

/* Links that bring no light are left out. nodes: NULL: the bin is empty. */
static void write_link(const struct leaf_writing *writing, int bin, const float *node) {
    const struct bins *bins = &writing->all->links->bins;
    const struct specular_light *light = writing->all->light;
    vec3s direction = glms_mat3_mulv(writing->to_world, bins->directions[bin]);
    const float *radiance = node ? node : light->sky[bins_find(bins, direction.raw)];
    float scale = light->scale * bins_solid_angle(bins, bins->directions[bin].raw, 1), scaled[3];
    if (!(radiance[0] > 0 || radiance[1] > 0 || radiance[2] > 0))
        return;
    glm_vec3_scale((float *)radiance, scale, scaled);
    uint32_t *texel = writing->texels[++writing->texels[0][0]];
    memcpy(texel, scaled, sizeof scaled);
    texel[3] = octahedral(direction);
}

static void write_leaf(void *context, size_t leaf) {
    const struct writing *all = context;
    const struct links *links = all->links;
    const struct link *items = links->items + leaf * (size_t)links->stride;
    const struct leaf_writing writing = {all, links_to_world(links, (int)leaf),
                                         all->texels + leaf * (size_t)stride_of(links->desc.side)};
    writing.texels[0][0] = 0;
    for (int k = 0; all->light->nodes && k < links->counts[leaf]; k++)
        write_link(&writing, items[k].bin, all->light->nodes[items[k].node]);
    for (int k = 1; all->light->sky && k <= links->open_counts[leaf]; k++)
        write_link(&writing, items[links->stride - k].bin, NULL);
}

void specular_pass_write(struct specular_pass *pass, const struct links *links,
                         const struct specular_light *light) {
    const size_t stride = (size_t)stride_of(pass->side), count = (size_t)links->leaf_count;
    parallel_for(count, links->desc.threads, write_leaf,
                 &(struct writing){links, light, pass->texels});
    buffer_write(&pass->links, 0, count * stride * sizeof *pass->texels, pass->texels);
}

void specular_pass_render(const struct specular_pass *pass, const struct interpolate_pass *elements,
                          const struct frame *frame, const struct gbuffer *gbuffer) {
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "specular links",
                   .program = pass->program,
                   .framebuffer = pass->radiance.framebuffer,
                   .width = pass->radiance.width,
                   .height = pass->radiance.height,
                   .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                                {UNIT_GBUFFER_SPECULAR, gbuffer->specular.id}},
                   .storages = {{STORAGE_ELEMENT_CELLS, &elements->cells},
                                {STORAGE_ELEMENTS, &elements->elements},
                                {STORAGE_ELEMENT_LINKS, &pass->links}},
                   .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &elements->params}},
               });
    pass_set_ints(LOCATION_OF_PANES, frame->of_panes, 0, 0, 0);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
