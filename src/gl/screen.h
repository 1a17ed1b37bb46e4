/* Screen passes: a shader's body that runs once for each pixel of a pass's targets.
 *
 * A pass names the body as struct program_desc's `screen`, and draws by pass_draw_fullscreen. The body is a
 * fragment shader. It runs in one of two ways, and the pass need not know which.
 *
 *     fragment    one triangle covers the viewport (glsl/fullscreen.vert, glsl/layers.vert).
 *     compute     the same text as a compute shader, dispatched in groups of 8x8 pixels.
 *
 * gl/screen_glsl.c turns the text into a compute shader.
 *
 *     layout(location = L) out T name;    a variable, and an image at IMAGE_SCREEN_TARGETS + L that gets its value.
 *     gl_FragCoord                        a variable.
 *     flat in int instance;               the layer, from the dispatch's z.
 *     layout(early_fragment_tests) in;    nothing: only marked pixels are dispatched.
 *     discard;                            the pixel is not marked; in main alone.
 *     void main()                         void screen_body(), which the dispatch's own main calls.
 *
 * A body therefore has its outputs, inputs and main each on a line of this form. It sets no depth, takes no
 * derivatives, and discards nothing unless its passes mark pixels. It may use `#ifdef SCREEN_COMPUTE`.
 *
 * The framebuffer of a pass tells the textures (gl/framebuffer.h). PASS_BLEND_ADD loads and adds. A pass that `marks`
 * pixels has PASS_DEPTH_LESS, no targets, and a mask (gl/pixel_mask.h); one that is `masked` has PASS_DEPTH_EQUAL and the
 * same mask, whose depth texture is its framebuffer's where passes are drawn. No other depth test, blending or colour mask
 * is possible.
 *
 * A `tiled` pass draws many rectangles, each with its own uniforms, which pass_set_int and the like set. Its body
 * declares them as `layout(location = L) uniform T name;`. Dispatched, they are variables, and the rectangles are rows
 * of one dispatch (gl/screen_rows.h), which pass_end submits: until then nothing else may change. A body that defines
 * SCREEN_BEGIN has it run before each pixel, to narrow screen_area (x, y, width, height) or to set further variables.
 *
 * Barriers: a dispatch waits for all that earlier commands read and write, and all later commands see its targets,
 * however they read or write them. Most passes read what the pass before has written, so that finer barriers would
 * gain little.
 */
#ifndef GL_SCREEN_H
#define GL_SCREEN_H

#include "gl/pass.h"

enum screen_way {
    SCREEN_AUTO, /* the faster one: on a GPU timed when the process makes its first screen pass, else fragment */
    SCREEN_FRAGMENT,
    SCREEN_COMPUTE,
};

/* For option tables: "auto", "fragment", "compute", NULL. */
extern const char *const screen_way_names[];

/* A setting of the process, for programs made from now on. */
void screen_set_way(enum screen_way way);

/* How screen passes run that the current context makes: never SCREEN_AUTO. */
enum screen_way screen_way(void);

/* Of one pass, milliseconds; infinite where it does not run. Error: no memory for a picture. */
struct screen_times {
    double drawn, dispatched;
};

bool screen_time_ways(struct screen_times *times);

/* For gl/pass.c. The pass that the state begins is a dispatch, if its program is one. */
void screen_begin(const struct pass_state *state);

/* Whether it is; those below are for it alone. */
bool screen_dispatches(void);
void screen_viewport(int x, int y, int width, int height);
void screen_draw_layers(int layers);
void screen_draw_part(int part);
void screen_end(void);

/* Whether the pass is tiled: then it takes a uniform's value, of count elements of size bytes, for its next draws. */
bool screen_takes(GLint location, const void *values, size_t size, int count);

#endif
