#include "passes/frame.h"

#include "base/deal.h"
#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/vertex_array.h"
#include "shared/vpl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

float frame_turn(const struct frame *frame) {
    return (float)fmod(frame->pass * .6180339887498949, 1);
}

static bool init_part(struct texture *texture, const char *label, const char *part,
                      struct texture_desc desc) {
    char full[40];
    snprintf(full, sizeof full, "%s %s", label, part);
    desc.label = full;
    desc.target = GL_TEXTURE_2D_ARRAY;
    return texture_init(texture, &desc);
}

static bool init_layer(struct texture *texture, const char *label, const char *part, GLenum format,
                       const struct gbuffer *gbuffer) {
    return init_part(texture, label, part,
                     (struct texture_desc){.format = format,
                                           .width = gbuffer->width,
                                           .height = gbuffer->height,
                                           .layers = gbuffer->layers});
}

bool gbuffer_init(struct gbuffer *gbuffer, const struct gbuffer_desc *desc) {
    const char *label = desc->label;
    *gbuffer =
        (struct gbuffer){.width = desc->width, .height = desc->height, .layers = desc->layers};
    const struct texture *emission = desc->has_emission ? &gbuffer->emission : NULL;
    const struct texture *gloss = desc->has_gloss ? &gbuffer->gloss : NULL;
    if (init_layer(&gbuffer->normal, label, "normal", GL_RG16, gbuffer) &&
        init_layer(&gbuffer->albedo, label, "albedo", desc->facets ? GL_RGBA16F : GL_RGB10_A2,
                   gbuffer) &&
        init_layer(&gbuffer->depth, label, "depth", GL_DEPTH_COMPONENT32F, gbuffer) &&
        (!desc->has_emission ||
         init_layer(&gbuffer->emission, label, "emission", GL_RGBA16F, gbuffer)) &&
        (!desc->has_gloss || init_layer(&gbuffer->gloss, label, "gloss", GL_RGBA8, gbuffer)) &&
        framebuffer_init(
            &gbuffer->framebuffer,
            &(struct framebuffer_desc){.label = label,
                                       .colors = {[TARGET_GBUFFER_NORMAL] = &gbuffer->normal,
                                                  [TARGET_GBUFFER_ALBEDO] = &gbuffer->albedo,
                                                  [TARGET_GBUFFER_EMISSION] = emission,
                                                  [TARGET_GBUFFER_GLOSS] = gloss},
                                       .depth = &gbuffer->depth}))
        return true;
    gbuffer_free(gbuffer);
    return false;
}

void gbuffer_free(struct gbuffer *gbuffer) {
    framebuffer_free(&gbuffer->framebuffer);
    texture_free(&gbuffer->normal);
    texture_free(&gbuffer->albedo);
    texture_free(&gbuffer->depth);
    texture_free(&gbuffer->emission);
    texture_free(&gbuffer->gloss);
    *gbuffer = (struct gbuffer){0};
}

void rsm_add(struct pass_state *state, const struct gbuffer rsm[LIGHT_MAP_KINDS]) {
    for (GLuint kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        const struct gbuffer *maps = &rsm[rsm[kind].layers ? kind : !kind];
        pass_add_texture(state, UNIT_RSM_DEPTH + kind, maps->depth.id);
        pass_add_texture(state, UNIT_RSM_NORMAL + kind, maps->normal.id);
        pass_add_texture(state, UNIT_RSM_ALBEDO + kind, maps->albedo.id);
    }
}

/* Rounding where culling and the driver clip, ndc. */
static const float clip_margin = 1e-3F;

struct draw_views frame_camera_views(const struct frame *frame, int layers, float margin) {
    return (struct draw_views){
        .count = layers, .first = frame->camera, .margin = clip_margin + margin};
}

/* Faces see all around. */
struct draw_views frame_light_views(const struct frame *frame, int kind) {
    const struct light_view *views = frame->light_block->views;
    return (struct draw_views){.count = frame->layout.views[kind],
                               .first = kind == LIGHT_MAP_FACE ? NULL : &views->view,
                               .stride = sizeof *views,
                               .margin = clip_margin};
}

void frame_cut_by_range(const struct frame *frame, struct pass_state *state) {
    const float endless = 1e30F;
    const struct camera_range *range = &frame->camera_range;
    bool cuts = range->cuts;
    state->clip_distances =
        cuts ? 2 : 0; /* which Mesa 22's llvmpipe takes for 2 where a shader writes them */
    gl.ProgramUniform2fv(
        state->program, LOCATION_CAMERA_RANGE, 1,
        (float[]){cuts ? range->near : -endless, cuts ? fminf(range->far, endless) : endless});
}

int frame_target_views(const struct frame *frame, GLuint program, int kind) {
    int first = kind == LIGHT_MAP_FACE ? frame->layout.views[LIGHT_MAP_SINGLE] : 0;
    gl.ProgramUniform1i(program, LOCATION_FIRST_VIEW, first);
    return frame->layout.views[kind];
}

static bool init_map_layer(struct texture *texture, const char *label, const char *part,
                           GLenum format, const struct depth_maps *maps) {
    return init_part(
        texture, label, part,
        (struct texture_desc){
            .format = format, .width = maps->size, .height = maps->size, .layers = maps->count});
}

bool depth_maps_init(struct depth_maps *maps, const struct depth_maps_desc *desc) {
    const char *label = desc->label;
    *maps = (struct depth_maps){.size = desc->size, .count = desc->count};
    const struct texture *normal = desc->has_normals ? &maps->normal : NULL;
    if (init_map_layer(&maps->depth, label, "depth", GL_DEPTH_COMPONENT16, maps) &&
        (!normal || init_map_layer(&maps->normal, label, "normal", GL_RG16, maps)) &&
        framebuffer_init(&maps->framebuffer,
                         &(struct framebuffer_desc){.label = label,
                                                    .colors = {[TARGET_RESULT] = normal},
                                                    .depth = &maps->depth}))
        return true;
    depth_maps_free(maps);
    return false;
}

void depth_maps_free(struct depth_maps *maps) {
    framebuffer_free(&maps->framebuffer);
    texture_free(&maps->depth);
    texture_free(&maps->normal);
    *maps = (struct depth_maps){0};
}

/* Four floats of each VPL. */
static void add_attribute(const struct vpl_buffer *vpls, GLuint location, size_t offset) {
    vertex_array_attribute(
        vpls->vertices, location,
        &(struct vertex_attribute){&vpls->buffer, 4, GL_FLOAT, sizeof(struct vpl), offset});
}

static bool init_sums(struct vpl_buffer *vpls) {
    return texture_init(&vpls->sums, &(struct texture_desc){.label = "sums of VPLs",
                                                            .format = GL_RGBA32F,
                                                            .width = 1,
                                                            .height = 1}) &&
           framebuffer_init(
               &vpls->sums_framebuffer,
               &(struct framebuffer_desc){.label = "sums of VPLs", .colors = {&vpls->sums}});
}

bool vpl_buffer_init(struct vpl_buffer *vpls, const char *label, int count) {
    *vpls = (struct vpl_buffer){.count = count};
    size_t size = (size_t)(count > VPLS_PER_BLOCK ? count : VPLS_PER_BLOCK) * sizeof(struct vpl);
    if (!buffer_init(&vpls->buffer, label, size, NULL) || !init_sums(vpls)) {
        vpl_buffer_free(vpls);
        return false;
    }
    gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &vpls->texels);
    gl.TextureBuffer(vpls->texels, GL_RGBA32F, vpls->buffer.id);
    gl.CreateVertexArrays(1, &vpls->vertices);
    add_attribute(vpls, ATTRIBUTE_VPL_POSITION, offsetof(struct vpl, position));
    add_attribute(vpls, ATTRIBUTE_VPL_NORMAL, offsetof(struct vpl, normal));
    add_attribute(vpls, ATTRIBUTE_VPL_FLUX, offsetof(struct vpl, flux));
    return true;
}

void vpl_buffer_take_sums(const struct vpl_buffer *vpls, const struct vpl_buffer *from) {
    gl.CopyImageSubData(from->sums.id, GL_TEXTURE_2D, 0, 0, 0, 0, vpls->sums.id, GL_TEXTURE_2D, 0,
                        0, 0, 0, 1, 1, 1);
}

void vpl_buffer_free(struct vpl_buffer *vpls) {
    framebuffer_free(&vpls->sums_framebuffer);
    texture_free(&vpls->sums);
    vertex_array_free(&vpls->vertices);
    if (vpls->texels)
        gl.DeleteTextures(1, &vpls->texels);
    buffer_free(&vpls->buffer);
    *vpls = (struct vpl_buffer){0};
}

bool irradiance_init(struct irradiance *irradiance, const char *label, GLenum format, int width,
                     int height, int interleave) {
    *irradiance = (struct irradiance){
        .width = width,
        .height = height,
        .interleave = interleave,
        .tile_width = (width + interleave - 1) / interleave,
        .tile_height = (height + interleave - 1) / interleave,
    };
    if (texture_init(&irradiance->texture,
                     &(struct texture_desc){
                         .label = label,
                         .format = format,
                         .width = irradiance->tile_width * interleave,
                         .height = irradiance->tile_height * interleave,
                     }) &&
        framebuffer_init(
            &irradiance->framebuffer,
            &(struct framebuffer_desc){.label = label, .colors = {&irradiance->texture}}))
        return true;
    irradiance_free(irradiance);
    return false;
}

struct interleaving irradiance_pattern(const struct irradiance *irradiance) {
    return (struct interleaving){
        .tile = {irradiance->tile_width, irradiance->tile_height},
        .n = irradiance->interleave,
    };
}

void irradiance_free(struct irradiance *irradiance) {
    framebuffer_free(&irradiance->framebuffer);
    texture_free(&irradiance->texture);
    *irradiance = (struct irradiance){0};
}

enum { SLOTS_MAX = 16 * 16 }; /* of a pattern */

void light_picks_init(struct light_picks *picks, const struct light_layout *layout) {
    *picks = (struct light_picks){.stride = layout->lights};
    picks->items = mem_alloc((size_t)(SLOTS_MAX * layout->lights), sizeof *picks->items);
}

void light_picks_free(struct light_picks *picks) {
    free(picks->items);
    *picks = (struct light_picks){0};
}

/* As few of the group for each slot as show all; they follow those that are picked already. Returned is how many
 * there are. */
static int deal_group(const struct light_picks *picks, const struct frame *frame,
                      struct light_group group, int slots, int picked) {
    double fluxes[LIGHTS_MAX];
    struct dealt dealt[SLOTS_MAX + LIGHTS_MAX];
    int counts[LIGHTS_MAX];
    for (int i = 0; i < group.count; i++)
        fluxes[i] = emitter_flux(&frame->emitters->items[group.first + i], frame->radius);
    int each = (group.count + slots - 1) / slots;
    deal(fluxes, group.count, dealt, slots * each, counts);
    for (int slot = 0; slot < slots; slot++)
        for (int i = 0; i < each; i++) {
            int light = dealt[slot + i * slots].taker;
            float *pick = picks->items[slot * picks->stride + picked + i];
            pick[0] = (float)(group.first + light);
            pick[1] = (float)slots / (float)counts[light];
        }
    return picked + each;
}

int light_picks_deal(const struct light_picks *picks, const struct frame *frame, int slots) {
    int picked = 0;
    for (int g = 0; g < frame->layout.groups; g++)
        picked = deal_group(picks, frame, frame->groups[g], slots, picked);
    return picked;
}

void light_picks_set(const struct light_picks *picks, int slot, int first, int count) {
    pass_set_int(LOCATION_PICK_COUNT, count);
    pass_set_pairs(LOCATION_PICKS, count, picks->items[slot * picks->stride + first]);
}

void pixel_lists_size(int size[2], int interleave) {
    int shorter = size[0] < size[1] ? 0 : 1;
    for (int axis = 0; axis < 2; axis++)
        size[axis] = (size[axis] + interleave - 1) / interleave * interleave;
    size[shorter] *= 2;
}

void pixel_lists_add(struct pass_state *state, const struct pixel_lists *lists, int receivers) {
    if (receivers == RECEIVERS_OTHERS)
        pass_add_texture(state, UNIT_LIST_TEXELS, lists->texels.id);
    if (receivers != RECEIVERS_LISTED)
        return;
    pass_add_texture(state, UNIT_LISTED_PIXELS, lists->pixels.id);
    pass_add_block(state, BLOCK_LIST_COUNTS, &lists->counts);
}

void pixel_lists_draw(const struct pixel_lists *lists, int list) {
    pass_set_ints(LOCATION_TILE, lists->tile_width, lists->tile_height, lists->interleave, list);
    pass_draw_part(list, 6);
}
