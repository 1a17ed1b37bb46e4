/* What passes exchange: the data contract of the frame. A pass includes this and no other pass.
 *
 * All pictures have row 0 at the bottom, as GL has it.
 */
#ifndef PASSES_FRAME_H
#define PASSES_FRAME_H

#include "gl/buffer.h"
#include "gl/pass.h"
#include "gl/texture.h"
#include "gl/timer.h"
#include "lights/starts.h"
#include "lights/view.h"
#include "scene/camera_range.h"
#include "scene/gpu/scene_gpu.h"
#include "shared/interleaving.h"

/* What every pass of one frame may use. */
struct frame {
    struct timers *timers;
    const struct buffer *view; /* for BLOCK_VIEW */
    const struct view *camera; /* what it holds */
    struct camera_range camera_range;
    /* For direct light those that shine, for a technique those that reflected light starts from: */
    const struct buffer *lights; /* for BLOCK_LIGHTS */
    const struct scene_gpu *scene;
    const struct emitters *emitters;
    const struct light_block *light_block; /* of the emitters: what the buffer holds */
    struct light_layout layout;            /* of the lights' maps */
    const struct light_group *groups;      /* layout.groups of them; NULL for direct light */
    const struct geometry *geometry;       /* for views of other lights */
    float bounds_min[3], bounds_max[3];    /* of the scene, metres */
    float radius;                          /* of its bounding sphere, metres */
    /* Of the camera's pixels: which surfaces their samples see (passes/picture/antialias.h), and the further
     * points of those whose samples have one (lib/further_point.glsl). */
    const struct texture *picks, *further_points;
    int pass; /* of those whose mean the picture is: others lights and samples in each; 0: the first, or
                 the only one */
    float irradiance_scale; /* stored irradiance = W/m2 times this: a power of two that
                                           keeps half floats in range at every scale of scene and light */
};

/* From 0 to 1, 0 in the first pass: multiples of the golden ratio, for numbers of pixels that are others in each pass. */
float frame_turn(const struct frame *frame);

/* What a display shows behind all surfaces. */
struct background {
    int kind;        /* BACKGROUND_..., shared/composite.h */
    float colour[3]; /* light of the display, from 0 to 1 */
};

/* Surfaces seen from the camera (one layer) or from the lights (the reflective shadow map: one of
 * LIGHT_MAP_KINDS, a layer each view; without textures where there are none of the kind). Arrays of
 * layers:
 *   normal  RG16      world normal, octahedral
 *   albedo  RGB10_A2  square root of the albedo; A = 1 where something is. RGBA16F of facets: of what a
 *                     triangle receives, over what meets its plane, times the albedo; normal is the triangle's
 *   depth   D32F      reversed (shared/view.h); 0 where nothing is
 *   emission RGBA16F  radiance times irradiance_scale; the camera's, of a scene with emissive materials
 *                     or such as are not plain
 *   gloss   RGBA8     what is reflected as by a mirror (lib/gloss.glsl), of a scene whose materials are not
 *                     plain (scene/material.h): the camera's, and the lights' where rays ask for it. The
 *                     normal is then the bent one; albedo the diffuse part's, of lights' views with
 *                     what the rest reflects, as if evenly
 */
struct gbuffer {
    struct texture normal, albedo, depth, emission, gloss;
    GLuint framebuffer;
    int width, height, layers;
};

/* N virtual point lights: struct vpl (shared/vpl.h), at least as many as a uniform block has room for; and sums
 * over them, which tell how far they are apart, the scale of what is lit, and their hue. */
struct vpl_buffer {
    struct buffer buffer;
    GLuint vertices; /* vertex array: position 0, normal 1, flux 2 */
    GLuint texels;   /* buffer texture: lib/vpl_texels.glsl */
    int count;
    struct texture sums; /* a pixel, RGBA32F: lib/vpl_sums.glsl */
    GLuint sums_framebuffer;
};

/* How much VPLs count where they are clustered (lights/vpl_weight.glsl): what each would give to the picture, R32F, a texel
 * a VPL; and a pixel of what all would, and of how many there are, RGBA32F. */
struct vpl_weights {
    struct texture values, sum;
};

/* A binary tree over VPLs (shared/vpl_tree.h), and the VPL that stands for each node, as many times as there are sets
 * of pixels: R32UI, a layer a set. */
struct vpl_tree {
    struct texture nodes, picks;
    GLuint vpls; /* buffer texture over the VPLs */
    int leaves, sets;
};

/* Of each block of block x block pixels two cuts through a tree, the second for pixels of lists: R32UI, of each cut a
 * layer with the counts of nodes, and a layer for each node. */
struct vpl_cuts {
    struct texture texture;
    const struct vpl_tree *tree;
    int block, detail_layer; /* where the second begins */
};

/* Of clusters of VPLs, M x 1 RGBA32F: position and count, normal, flux (W). */
struct val_targets {
    struct texture position, normal, flux;
    GLuint framebuffer;
};

/* Up to MAP_VIEWS_MAX paraboloid views (shared/map_view.h). */
struct map_views {
    struct buffer buffer;
    int count;
};

/* Map depth |q| / z_far of the nearest caster; 1 where there is none. D16, one layer a view. */
struct depth_maps {
    struct texture depth;
    struct texture normal; /* RG16, of the caster in the map's frame, octahedral; or none */
    GLuint framebuffer;
    int size, count;
};

/* What lights see along their own axes: linear depth over the light's map_unit, 1 where nothing is
 * (visibility/light_map.glsl). R32F, one layer a map. */
struct light_maps {
    struct texture depth;
    int size, count;
};

/* Summed area tables of what filters average over maps of depth: R32UI to RGBA32UI, a border of zeros and
 * then a texel for each of the map; texel (x, y) has the sums over all before column x and row y, modulo
 * 2^32 (shared/sums.h). One layer a map, of Fourier bases several. */
struct sum_maps {
    struct texture sums;
    int size, count; /* of the maps: the texture is one texel larger */
};

/* Nearest and farthest depth in squares of a map of depth, RG32F; level l has squares of 2^(l + 1) texels,
 * the last of a row also what is left over (shared/depth_bounds.h). One layer a map. */
struct depth_bounds {
    struct texture bounds;
    int size, count; /* of the maps */
    int levels;
};

/* Fourier bases of the depth maps with MIP maps; layer g x count + k is group g (four terms) of map
 * k, whose depths its range makes the argument of (visibility/series.glsl). */
struct basis_maps {
    struct texture cos, sin;     /* RGBA8, (b + 1) / 2 */
    struct texture z_cos, z_sin; /* RGBA16F */
    struct texture z;            /* R16F, one layer a map */
    struct buffer ranges;        /* struct series_range, one a map */
    int size, count, groups, terms;
};

/* R8: the visibility of map k at the centre of each block of block x block pixels, in layer k. */
struct block_visibilities {
    struct texture texture;
    GLuint framebuffer;
    int block;
};

/* Irradiance times irradiance_scale; in tiles of equal place in the n x n pattern, or plain where
 * interleave is 1. RGBA32F where many draws add up: halves would lose some of each. RGBA16F where
 * one draw writes. */
struct irradiance {
    struct texture texture;
    GLuint framebuffer;
    int width, height; /* of the picture that it stands for */
    int interleave, tile_width, tile_height;
};

/* Some pixels of a picture and further points of some, as a list for each grade (PIXEL_GRADE_...) or of points
 * (LIST_FURTHER) and place of the n x n pattern. */
struct pixel_lists {
    struct texture
        pixels; /* R32UI, x | y << 16, in tiles, twice as large as a picture's; a list fills its tile
                              row by row: of one grade from its begin, of the other from the end of its first
                              half, of points from there on */
    struct texture texels;         /* R32UI, of each pixel of the picture its texel in the lists
                              (gather/list_texel.glsl); 0 where it is not listed */
    struct texture further_texels; /* likewise of its further point */
    struct buffer counts;          /* of the lists: uint */
    int interleave, tile_width, tile_height;
};

/* What a technique makes, each NULL where it does not; composite adds what is there:
 *
 *     L = transmittance (albedo (direct + irradiance / pi) + radiance) + in_scatter
 *
 * Light of surfaces: irradiance, not yet times albedo, or radiance towards the camera. Light of
 * what lies before them: in_scatter, with the share of the surfaces' light that passes. Textures
 * are of the picture's size; radiance and in_scatter times irradiance_scale. */
struct contribution {
    const struct irradiance *irradiance;
    const struct irradiance
        *further_irradiance; /* likewise at pixels' further points, and the texel of each in */
    const struct texture *further_texels; /* it, gather/list_texel.glsl; both or none */
    const struct texture *radiance;
    const struct texture *in_scatter, *transmittance; /* both or none */
};

/* Lets what is drawn by one of the programs end where the camera's range does (picture/camera_range.glsl). */
void frame_cut_by_range(const struct frame *frame, struct pass_state *state);

/* The camera's view, of that many layers; the margin is draw_views'. */
struct draw_views frame_camera_views(const struct frame *frame, int layers, float margin);

/* The lights' of that kind. */
struct draw_views frame_light_views(const struct frame *frame, int kind);

/* Sets what lib/light_target.glsl needs to draw views of that kind; returns how many there are. */
int frame_target_views(const struct frame *frame, GLuint program, int kind);

struct gbuffer_desc {
    const char *label;
    int width, height, layers;
    bool has_emission, has_gloss;
    bool facets; /* as geometry_desc's */
};

bool gbuffer_init(struct gbuffer *gbuffer, const struct gbuffer_desc *desc);
void gbuffer_free(struct gbuffer *gbuffer);

struct depth_maps_desc {
    const char *label;
    int size, count;
    bool has_normals;
};

bool depth_maps_init(struct depth_maps *maps, const struct depth_maps_desc *desc);
void depth_maps_free(struct depth_maps *maps);

/* Binds what lib/rsm.glsl reads. For a kind that is not there, and is not read, the other stands in:
 * drivers warn of empty units. */
void rsm_add(struct pass_state *state, const struct gbuffer rsm[LIGHT_MAP_KINDS]);

bool vpl_buffer_init(struct vpl_buffer *vpls, const char *label, int count);
void vpl_buffer_free(struct vpl_buffer *vpls);

/* The sums of what the VPLs stand for. */
void vpl_buffer_take_sums(const struct vpl_buffer *vpls, const struct vpl_buffer *from);

bool irradiance_init(struct irradiance *irradiance, const char *label, GLenum format, int width,
                     int height, int interleave);
void irradiance_free(struct irradiance *irradiance);

/* Which lights each slot of a pattern takes, and each one's weight there: of a group of many, one stands
 * for all. */
struct light_picks {
    float (*items)[2]; /* of each slot: a light's number and weight */
    int stride;        /* room for a slot's */
};

void light_picks_init(struct light_picks *picks, const struct light_layout *layout);
void light_picks_free(struct light_picks *picks);

/* Deals the frame's lights out to that many slots, by their flux; returns how many each takes. */
int light_picks_deal(const struct light_picks *picks, const struct frame *frame, int slots);

/* Sets so many of the slot's, from the first on, at LOCATION_PICK_COUNT and LOCATION_PICKS. */
void light_picks_set(const struct light_picks *picks, int slot, int first, int count);

/* From a picture's size to that of the tiles of its lists, all of them: along its shorter side twice as large, as
 * textures have a limit. */
void pixel_lists_size(int size[2], int interleave);

/* What a pass over such RECEIVERS_ binds, for gather/receiver.glsl; lists are not read for all. And the draw
 * of one place's list of a kind, after LOCATION_SLOT is set. */
void pixel_lists_add(struct pass_state *state, const struct pixel_lists *lists, int receivers);
void pixel_lists_draw(const struct pixel_lists *lists, int list);

/* For shaders. */
struct interleaving irradiance_pattern(const struct irradiance *irradiance);

#endif
