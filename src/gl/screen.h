/* Screen passes: a shader body that runs once for each pixel of the targets of a pass.
 *
 * A pass names the body in `screen` of struct program_desc and draws it by pass_draw_fullscreen.
 * The body is a fragment shader that runs as one of two stages; passes need not know which:
 *     fragment    one triangle covers the viewport (glsl/fullscreen.vert)
 *     compute     the same text as a compute shader, dispatched in groups of 8x8 pixels
 * gl/screen_glsl.c makes the compute shader. It replaces lines of these forms.
 *
 *     layout(location = L) out T name;    variable, stored to image IMAGE_SCREEN_TARGETS + L.
 *     gl_FragCoord                        variable.
 *     flat in int instance;               layer: z of the dispatch.
 *     layout(early_fragment_tests) in;    nothing: only marked pixels are dispatched.
 *     discard;                            leaves the pixel unmarked; in main only.
 *     void main()                         void screen_body(), called by the main of the dispatch.
 *
 * Write each output, each input and main of a body on a line of such a form. A body sets no depth,
 * takes no derivatives, and discards only if its passes mark pixels. `#ifdef SCREEN_COMPUTE` is
 * allowed.
 *
 * The targets are the textures of the pass's framebuffer (gl/framebuffer.h). PASS_BLEND_ADD loads
 * and adds. A pass that `marks` has PASS_DEPTH_LESS, no targets, and a mask (gl/pixel_mask.h). A
 * `masked` pass has PASS_DEPTH_EQUAL and the same mask; if drawn, its framebuffer has the mask's
 * depth texture. Other depth tests, blending and colour masks are not possible.
 *
 * A `tiled` pass draws many rectangles, each with uniforms set by pass_set_int and the like. Its
 * body declares them as `layout(location = L) uniform T name;`. Dispatched, the uniforms become
 * variables and the rectangles rows of one dispatch (gl/screen_rows.h). pass_end submits it; change
 * no other state before. SCREEN_BEGIN, if the body defines it, runs before each pixel. It narrows
 * screen_area (x, y, width, height) or sets further variables.
 *
 * Barriers: a dispatch waits for all earlier reads and writes, and all later commands see its
 * targets. Finer barriers would save little, because most passes read the output of the pass
 * before. */
#ifndef GL_SCREEN_H
#define GL_SCREEN_H

#include "gl/pass.h"

enum screen_way {
    /* On a GPU the faster way, timed at the first screen pass of the process; else fragment. */
    SCREEN_AUTO,
    SCREEN_FRAGMENT,
    SCREEN_COMPUTE,
};

/* Names for option tables: "auto", "fragment", "compute", NULL. */
extern const char *const screen_way_names[];

/* Sets the way of all programs that the process makes later. */
void screen_set_way(enum screen_way way);

/* Returns the way of programs that the current context makes; never SCREEN_AUTO. */
enum screen_way screen_way(void);

/* Times of one pass, milliseconds; infinite if it does not run. */
struct screen_times {
    double drawn, dispatched;
};

/* Times both ways on the current context. Error: no memory for a picture. */
bool screen_time_ways(struct screen_times *times);

/* Begins a pass, for gl/pass.c. The pass is a dispatch if its program is one. */
void screen_begin(const struct pass_state *state);

/* True during a dispatched pass. Call the functions below only then. */
bool screen_dispatches(void);
void screen_viewport(int x, int y, int width, int height);
void screen_draw_layers(int layers);
void screen_draw_part(int part);
void screen_end(void);

/* Sets a uniform of a tiled pass for its next draws: count elements of size bytes. Returns false,
 * and does nothing, if the pass is not tiled. */
bool screen_takes(GLint location, const void *values, size_t size, int count);

#endif
