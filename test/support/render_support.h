/* What the tests of the renderer share: a scene that a test may change, and pictures of it. */
#ifndef TEST_RENDER_SUPPORT_H
#define TEST_RENDER_SUPPORT_H

#include "support.h"

#include "gl/context/context.h"
#include "gl/pass.h"
#include "reference/path_tracer.h"
#include "reference/scene/ray_scene.h"
#include "renderer/renderer.h"
#include "renderer/stage.h"

/* A debug context of that kind that is current; the test is skipped where there is none. */
struct context *open_context(enum context_kind kind);

/* For cmocka_run_group_tests: one context for all tests of the group; the program fails where
 * OpenGL had something to say, or an object or a byte of GPU memory is left at its end. */
int open_group_context(void **state);
int close_group_context(void **state);

/* What a compute shader of test/support is asked: it has the questions in storage 0 and gives the
 * answers in the next one. */
struct questions {
    const char *shader, *defines; /* shader: "traced.comp" */
    const void *asked;            /* NULL: none, and the answers are storage 0 */
    void *answers;                /* the shader finds what is in them */
    size_t asked_bytes, answer_bytes;
    int groups[2]; /* of the dispatch; groups[1] 0: 1 */
    struct pass_texture textures[8];
    struct {
        GLuint block;
        const void *data;
        size_t bytes;
    } blocks[4];
};

void ask_shader(const struct questions *questions);

/* A stage that the test may change; fails the test on an error. */
struct stage open_stage(const char *path);

/* Geometry, camera and light anew from a scene that the test has changed. */
void pose_stage(struct stage *stage);

/* Makes the scene s times as large with s^2 times the intensity, or the same radiance, which is the
 * same picture: no length and no light is absolute. pose_stage follows. */
void scale_scene(struct scene *scene, float s);

/* A sky of that many texels in place of the scene's, and no other light. */
void set_sky(struct stage *stage, int width, int height,
             void (*paint)(const float direction[3], float radiance[3]));

/* A medium that fills the scene; coefficients in 1/m. */
void set_medium(struct stage *stage, float scattering, float absorption, float g);

/* Turns everything, camera and light too, about the y axis. */
void turn_stage(struct stage *stage, double degrees);

static inline vec3s to_vec3s(const float v[3]) {
    return (vec3s){{v[0], v[1], v[2]}};
}

/* The same scene for rays: the second opinion on what a rasteriser saw. */
struct rays {
    struct hit_table table;
    struct ray_scene scene;
};

void open_rays(struct rays *rays, const struct stage *stage);
void close_rays(struct rays *rays);

/* The desc of a renderer: settings as "vpls=64 vals=8", in order; the technique by name. A pixel is
 * its centre, which other ways to a pixel's value have too, unless the settings say samples=8. */
struct renderer_desc desc_of(const struct stage *stage, const char *technique, const char *settings,
                             int width, int height);

/* A renderer that has rendered one frame. */
void open_renderer(struct renderer *renderer, struct renderer_desc desc);

/* All layers of the frame that a renderer of this desc renders. */
struct image render_layers(const struct renderer_desc *desc);

/* The mean of passes first .. first + count - 1. */
struct image render_mean(const struct renderer_desc *desc, int first, int count);

/* The same as render_layers by one renderer, which follows from desc to desc of one scene in one
 * pose; the first of a zeroed one makes it. renderer_free frees it. */
struct image follow_layers(struct renderer *renderer, const struct renderer_desc *desc);

/* The same with the desc of desc_of. */
struct image render_stage(const struct stage *stage, const char *technique, const char *settings,
                          int size);

/* The VPLs of the last frame, as the gather reads them; vpl_count of them, for free(). */
struct vpl *read_vpls(const struct renderer *renderer);

/* Where the surface is that a pixel of the layers sees, by its Z. */
void pixel_position(const struct renderer *renderer, const struct image *layers, int x, int y,
                    float position[3]);

/* Whether all values are the same bits. */
bool same_pixels(const struct image *a, const struct image *b);

/* The first light of the stage in place of desc's, once whole and once as two halves. */
void render_halves(const struct stage *stage, struct renderer_desc desc, struct image *whole,
                   struct image *halves);

/* RMS of the difference of a layer over the mean of the reference's, over what both see. */
double relative_rmse(const struct image *test, const struct image *reference, const char *layer);

/* RMS of the gradient of the difference over the mean of the reference: banding. */
double gradient_error(const struct image *test, const struct image *reference, const char *layer);

/* The mean of a layer's channels over the pixels that see something. */
double layer_mean(const struct image *image, const char *layer);

/* One bounce by the path tracer, through the pixels' centres: the layers that a frame has too. */
struct image trace_stage(const struct stage *stage, int size, int samples);

/* The path tracer's picture: TRACE(&stage, .width = 8, .height = 8, .samples = 64). */
#define TRACE(stage, ...) trace_paths(stage, &(struct path_tracer_desc){__VA_ARGS__})
struct image trace_paths(const struct stage *stage, const struct path_tracer_desc *desc);

/* Of a picture of the path tracer the layers that a frame has too. */
struct image common_layers(const struct image *traced);

/* Fails where a value of any channel is NaN or infinite. */
void check_finite(const char *what, const struct image *image);

#endif
