/* The frame: G-buffer, direct light, a technique's indirect light, composite.
 *
 * All allocation and compilation happen in init and in changes; render cannot fail. Two renderers
 * may coexist in one context.
 */
#ifndef RENDERER_RENDERER_H
#define RENDERER_RENDERER_H

#include "base/image.h"
#include "direct/direct.h"
#include "direct/environment.h"
#include "lights/light_samples.h"
#include "passes/picture/antialias.h"
#include "passes/picture/composite.h"
#include "passes/picture/geometry.h"
#include "passes/picture/mean.h"
#include "renderer/airlight.h"
#include "renderer/settings.h"
#include "scene/camera_range.h"
#include "scene/gpu/caster_pool.h"
#include "techniques/technique.h"

/* What a picture can show, by LAYER_BEAUTY, LAYER_DIRECT and LAYER_INDIRECT; null-terminated. */
extern const char *const shown_layer_names[];

/* The layer's name in an image (renderer_read_layers): "" for the beauty. */
const char *shown_layer_prefix(int layer);

/* Zero means default. */
struct renderer_desc {
    int width, height;                  /* required */
    const struct technique *technique;  /* technique_default */
    const struct direct_method *direct; /* direct_for the emitters */
    struct settings settings;           /* renderer_settings_init */
    const struct scene *scene;          /* must outlive the renderer, as must the geometry */
    const struct geometry *geometry;
    struct emitters emitters; /* one at least; the renderer takes a copy */
    struct camera camera;
    bool keep_lights; /* frames in which only the camera moved use the lights' passes of the one
                         before: the same picture in less time */
    struct background background; /* what is not the scene's hides its sky, in all layers */
    bool progressive;             /* ready for renderer_add_pass */
    bool timed;                   /* measure passes */
};

/* What maps and programs are made for. */
struct light_plan {
    struct light_layout layout, sample_layout;
    struct light_samples_desc light_samples;
    struct environment_lights sky;
    struct sky_groups sky_samples; /* from which its reflected light starts */
    struct sky_wanted {
        const struct environment *environment;
        int fit, lights;
    } wanted; /* that the lights were fitted by */
};

struct renderer {
    struct renderer_desc desc;
    struct timers timers;
    struct scene_gpu scene;
    struct caster_pool *casters;
    struct gbuffer gbuffer;
    struct geometry_pass geometry;
    struct antialias_pass antialias;
    struct composite_pass composite;
    const struct technique *technique; /* as long as there is a state of its; and so below */
    void *technique_state;
    const struct direct_method *direct; /* desc.direct, or with it environment_direct */
    void *direct_state;
    struct airlight airlight; /* of a medium; zeroed without one */
    struct caustics_part {    /* zeroed where they are not shown: renderer/caustics.h */
        struct caustics_passes *passes;
        const struct texture *surface, *volume; /* NULL: the picture has none */
    } caustics;
    struct geometry *glass_view; /* NULL without caustics */
    bool lights_drawn;           /* what depends on no camera is that of desc */
    int pass;                    /* that the last frame was: 0 = the first, or the only one */
    /* The mean of passes, where desc.progressive. */
    struct refining {
        const struct technique *technique; /* of passes after the first; NULL: the renderer's own */
        void *state;
        struct antialias_pass centers; /* of their pixels: samples come by the passes */
        struct mean_pass mean;
        int count;     /* of passes in the mean; 0: none */
        double weight; /* of them */
    } refining;
    unsigned frame_count; /* of frames drawn: outputs that are drawn on demand are of one of them */
    struct ambient_occlusion *ambient_occlusion; /* NULL until somebody asks for it */
    unsigned occluded_frame;                     /* that it shows; 0: none */
    struct view camera_view;
    struct camera_range camera_range;
    struct ranged { /* the view that it is of */
        const struct geometry *geometry;
        unsigned pose;
        float aspect;
        struct camera camera;
    } ranged;
    struct buffer view_buffer;
    struct light_plan plan;
    struct light_search *light_search;
    /* What shines, for direct light; and what techniques are given for it. */
    struct light_block *light_block, *sample_block;
    struct buffer light_buffer, sample_buffer;
    struct light_samples light_samples;
    struct texture sky_pieces; /* of those that are a sky's; zeroed where the scene has none */
    struct emitters sample_emitters; /* of the light samples: nothing to be freed */
};

/* Error: driver, shader, size, memory, or more lights than there is room for. */
bool renderer_init(struct renderer *renderer, const struct renderer_desc *desc);
void renderer_free(struct renderer *renderer);

/* Changes between frames: to another technique, direct method, settings, size, lights, camera, or progressive; all
 * else as it is in renderer->desc. What a change reaches is made anew, all else stays; when it fails the
 * renderer is what it was. Errors are renderer_init's. */
bool renderer_follow(struct renderer *renderer, const struct renderer_desc *desc);
/* The environment was turned, or its strength changed, in place. */
void renderer_relight(struct renderer *renderer);
bool renderer_reload_shaders(struct renderer *renderer);

/* Whether renderer_follow would make the technique anew, and what it has of the geometry from the
 * pose that this has then. */
bool renderer_makes_technique(const struct renderer *renderer, const struct technique *technique,
                              const struct settings *settings);

/* Whether renderer_follow would make anything anew that has programs of its own: of another size all are the same. */
bool renderer_makes_programs(const struct renderer *renderer, const struct renderer_desc *desc);

/* After geometry_pose: uploads what has moved. For the same bits whatever came before, begin with the
 * geometry at time 0. Error: out of GPU memory; the renderer must then be freed. */
bool renderer_update(struct renderer *renderer);

/* Renders one frame into the composite's display texture. Timer "frame". */
void renderer_render(struct renderer *renderer);

/* Renders a pass of a picture that converges, where desc.progressive, adds it to the mean and shows
 * that. What is read and composed is then the mean's, until a frame is rendered, anything that it shows
 * changes, or a pass comes that is not the next: a mean begins anew. Passes depend on their number
 * alone, 0 is the frame: means of some, weighted, make the mean of all. Timer "frame". */
void renderer_add_pass(struct renderer *renderer, int pass);

/* After a frame that was cancelled (gl/cancel.h): nothing that it drew counts for the next. */
void renderer_forget_frame(struct renderer *renderer);

/* Passes in the mean that is shown; 0: it is a frame. Of their weights, the sum. */
int renderer_pass_count(const struct renderer *renderer);
double renderer_pass_weight(const struct renderer *renderer);

/* Composes the last frame's picture anew: LAYER_BEAUTY, LAYER_DIRECT or LAYER_INDIRECT, with the
 * present exposure and tone map. */
void renderer_compose(struct renderer *renderer, int layer);

/* The picture's layers, row 0 at the top: R G B A, Z, direct.*, indirect.*, albedo.*, normal.*, and where
 * materials are not all plain specular.*, direct.specular.*, indirect.specular.*, radiance that albedo x
 * (direct + indirect) does not have.
 * Error: out of memory, or the context is lost. */
bool renderer_read_layers(struct renderer *renderer, struct image *image);

/* The same of one pixel, as an image of 1 x 1. */
bool renderer_read_pixel(struct renderer *renderer, int x, int y, struct image *image);

/* The last frame as the display shows it, row 0 at the top; alpha is 255 but with BACKGROUND_NONE, where it
 * is the coverage, by which colours are not multiplied. Error: the context is lost. */
bool renderer_read_display(const struct renderer *renderer, struct bitmap *bitmap);

/* For reading back: what the technique's passes of the last frame were given. */
struct frame renderer_frame(struct renderer *renderer);
struct composite_inputs renderer_composite_inputs(const struct renderer *renderer);

/* Draws the ambient occlusion of what the last frame shows, by the settings volume.*: R = the open fraction, A = 0 where it
 * is not known. The renderer's until the next change. NULL: an error, out of GPU memory or a shader. */
const struct irradiance *renderer_ambient_occlusion(struct renderer *renderer);

/* How far it looks, metres; 0: this build has none. */
float renderer_ao_distance(const struct settings *settings, const struct geometry *geometry);

struct contribution renderer_contribution(const struct renderer *renderer);
/* As the settings have it, EV. */
float renderer_exposure(const struct renderer *renderer);

/* What there is to look at: the G-buffer, the technique's, the irradiance, ambient occlusion. */
void renderer_outputs(const struct renderer *renderer, struct output_list *outputs);

#endif
