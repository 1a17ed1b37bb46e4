/* Renders a frame: G-buffer, direct light, a technique's indirect light, composite.
 *
 * Init and changes allocate and compile everything; rendering cannot fail. Several renderers can
 * share one context. */
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
#include "passes/sampled_lights.h"
#include "renderer/airlight.h"
#include "renderer/settings.h"
#include "scene/camera_range.h"
#include "scene/gpu/caster_pool.h"
#include "techniques/technique.h"

/* Names of the layers that a picture can show, by LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT;
 * null-terminated. */
extern const char *const shown_layer_names[];

/* Returns the layer's prefix in an image (renderer_read_layers); "" for the beauty layer. */
const char *shown_layer_prefix(int layer);

/* Zero selects the default. */
struct renderer_desc {
    int width, height;                  /* required */
    const struct technique *technique;  /* default: technique_default */
    const struct direct_method *direct; /* default: direct_for of the emitters */
    struct settings settings;           /* default: renderer_settings_init */
    const struct scene *scene;          /* must outlive the renderer, as must the geometry */
    const struct geometry *geometry;
    struct emitters emitters; /* at least one; the renderer copies them */
    struct camera camera;
    /* Distance at which the camera sees a white plane in place of all surfaces (inspect/meter.h),
     * metres; 0: none. Needs picture.samples=1, and no caustics. */
    float sensor;
    /* Reuses the lights' passes of the previous frame if only the camera moved. The picture is the
     * same. */
    bool keep_lights;
    /* A kind other than the scene's hides the environment, in all layers. */
    struct background background;
    bool progressive; /* enables renderer_add_pass */
    bool timed;       /* measures the time of passes */
};

/* Layouts and lights for which maps and programs are made. */
struct light_plan {
    struct emitters mapped, sampled; /* lights with maps; all others */
    struct light_layout layout, sample_layout;
    struct light_samples_desc light_samples;
    struct environment_lights sky;
    /* Groups of the environment from which its reflected light starts. */
    struct sky_groups sky_samples;
    struct sky_wanted {
        const struct environment *environment;
        int fit, lights;
    } wanted; /* input of the environment's fit */
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
    /* Technique of technique_state, NULL without one; `direct` is that of direct_state. */
    const struct technique *technique;
    void *technique_state;
    const struct direct_method *direct; /* desc.direct, or environment_direct around it */
    void *direct_state;
    struct airlight airlight; /* zeroed without a medium and panes */
    struct caustics_part {    /* zeroed unless caustics are shown (renderer/caustics.h) */
        struct caustics_passes *passes;
        const struct texture *surface, *volume; /* NULL: the picture has none */
    } caustics;
    /* Copy of the geometry in which glass blocks light (renderer/caustics.h); NULL without
     * caustics. */
    struct geometry *glass_view;
    bool lights_drawn; /* camera-independent passes are those of desc */
    int pass;          /* index of the last frame's pass; 0: the first, or the only one */
    /* Mean of passes, with desc.progressive. */
    struct refining {
        /* Technique of passes after the first; NULL: the renderer's. */
        const struct technique *technique;
        void *state;
        /* Antialiasing of passes after the first: centres alone, because passes vary the
         * position. */
        struct antialias_pass centers;
        struct mean_pass mean;
        int count;     /* passes in the mean; 0: none */
        double weight; /* sum of the passes' weights */
    } refining;
    /* Frames drawn so far; an output rendered on demand belongs to one of them. */
    unsigned frame_count;
    struct ambient_occlusion *ambient_occlusion; /* NULL until first requested */
    unsigned occluded_frame;                     /* frame_count of its last render; 0: none */
    struct view camera_view;
    struct camera_range camera_range;
    struct ranged { /* view that camera_range belongs to */
        const struct geometry *geometry;
        unsigned pose;
        float aspect;
        struct camera camera;
    } ranged;
    struct buffer view_buffer;
    struct light_plan plan;
    struct light_search *light_search;
    /* Lights that shine, for direct light; their light samples, for techniques. */
    struct light_block *light_block, *sample_block;
    struct buffer light_buffer, sample_buffer;
    struct light_samples light_samples;
    struct sampled_lights sampled; /* lights without maps; zeroed without any */
    /* Directions of the environment's light samples; zeroed without an environment. */
    struct texture sky_pieces;
    struct emitters sample_emitters; /* the light samples as emitters; owns nothing */
};

/* Error: driver, shader, size, memory, or too many lights. */
bool renderer_init(struct renderer *renderer, const struct renderer_desc *desc);
void renderer_free(struct renderer *renderer);

/* Changes technique, direct method, settings, size, lights, camera or progressive between frames.
 * Other members of `desc` must equal renderer->desc. It rebuilds only the parts that the change
 * affects. Error: that of renderer_init; the renderer stays unchanged. */
bool renderer_follow(struct renderer *renderer, const struct renderer_desc *desc);
/* Updates the lights after the environment was rotated or scaled in place. */
void renderer_relight(struct renderer *renderer);
bool renderer_reload_shaders(struct renderer *renderer);

/* True if renderer_follow would rebuild the technique, and with it the parts that depend on the
 * geometry's current pose. */
bool renderer_makes_technique(const struct renderer *renderer, const struct technique *technique,
                              const struct settings *settings);

/* True if renderer_follow would rebuild a part with programs. A change of size alone does not. */
bool renderer_makes_programs(const struct renderer *renderer, const struct renderer_desc *desc);

/* Returns true if renderer_update follows other triangles (geometry_follow) from or to this
 * geometry: one without panes, caustics, metaballs and levels of detail. */
bool renderer_follows(const struct renderer *renderer, const struct geometry *geometry);

/* Uploads moved triangles, after geometry_pose or geometry_follow. Start with the geometry at time
 * 0 to get equal bits whatever came before. Error: out of GPU memory; the caller must then free the
 * renderer. */
bool renderer_update(struct renderer *renderer);

/* Renders one frame into the composite's display texture. Timer "frame". */
void renderer_render(struct renderer *renderer);

/* Renders a pass of a progressive picture, adds it to the mean and shows the mean
 * (desc.progressive). Reading and composing then use the mean, until renderer_render, a change, or
 * a pass out of order, which starts a new mean. A pass depends only on its index; pass 0 is the
 * frame. So means of parts, weighted, make the mean of all. Timer "frame". */
void renderer_add_pass(struct renderer *renderer, int pass);

/* Discards a cancelled frame (gl/cancel.h), so that the next frame reuses none of it. */
void renderer_forget_frame(struct renderer *renderer);

/* Return the passes in the displayed mean (0: a frame is displayed), and the sum of their
 * weights. */
int renderer_pass_count(const struct renderer *renderer);
double renderer_pass_weight(const struct renderer *renderer);

/* Composes the last frame again, with the current exposure and tone map: LAYER_BEAUTY, LAYER_DIRECT
 * or LAYER_INDIRECT. */
void renderer_compose(struct renderer *renderer, int layer);

/* Reads the picture's layers, row 0 at the top: R G B A, Z, direct.*, indirect.*, albedo.*,
 * normal.*. If some material is not plain, also specular.*, direct.specular.*,
 * indirect.specular.*: radiance that albedo x (direct + indirect) lacks. Error: out of memory, or
 * the context is lost. */
bool renderer_read_layers(struct renderer *renderer, struct image *image);

/* Returns the bit 1 << LAYER_... of a layer that the renderer has, "beauty", "Z" or "direct"; 0: it
 * has none of this name. */
unsigned renderer_layer_bit(const struct renderer *renderer, const char *name);

/* Reads only the layers whose bits 1 << LAYER_... are set. */
bool renderer_read_some(struct renderer *renderer, unsigned layers, struct image *image);

/* Reads the layers of one pixel, as a 1 x 1 image. */
bool renderer_read_pixel(struct renderer *renderer, int x, int y, struct image *image);

/* Reads the displayed frame, row 0 at the top. Alpha is 255; with BACKGROUND_NONE it is the
 * coverage, not premultiplied. Error: the context is lost. */
bool renderer_read_display(const struct renderer *renderer, struct bitmap *bitmap);

/* Returns the last frame's inputs of the technique's passes, for reading back. */
struct frame renderer_frame(struct renderer *renderer);
struct composite_inputs renderer_composite_inputs(const struct renderer *renderer);

/* Renders ambient occlusion of the last frame by the settings volume.*: R = open fraction, A = 0
 * where unknown. The renderer owns it; valid until the next change. NULL: error, out of GPU memory
 * or a shader. */
const struct irradiance *renderer_ambient_occlusion(struct renderer *renderer);

/* Returns the distance of ambient occlusion, m; 0: this build has none. */
float renderer_ao_distance(const struct settings *settings, const struct geometry *geometry);

struct contribution renderer_contribution(const struct renderer *renderer);
/* Returns the exposure setting, EV. */
float renderer_exposure(const struct renderer *renderer);

/* Lists the outputs: the G-buffer's, the technique's, the irradiance, ambient occlusion. */
void renderer_outputs(const struct renderer *renderer, struct output_list *outputs);

#endif
