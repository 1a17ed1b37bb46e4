/* Draws the scene's surfaces into a G-buffer: the camera's, or the lights'.
 *
 * The lights' G-buffer is the reflective shadow map [Dong 2009 §6; Dachsbacher and Stamminger
 * 2005]: one map of a spot or a directional light, six of a point light, which the papers keep in a
 * cube map.
 */
#ifndef PASSES_GEOMETRY_H
#define PASSES_GEOMETRY_H

#include "passes/targets.h"

struct frame;

struct geometry_pass {
    GLuint camera_program, light_program;
};

/* What the camera's G-buffers have; of lights', has_specular: materials are not all plain. facets, where
 * they are: what lights see sends light on as its triangles, and not as the smooth surface that shading
 * normals tell of. has_mappings: materials_have_mappings. */
struct geometry_desc {
    bool has_emission, has_specular, has_mappings, facets;
};

bool geometry_pass_init(struct geometry_pass *pass, const struct geometry_desc *desc);
void geometry_pass_free(struct geometry_pass *pass);

/* Clears and fills the G-buffer as the camera sees it. Timer "gbuffer". */
void geometry_pass_render_camera(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer *gbuffer);

/* Clears and fills the map of each view from a light. Timer "rsm". */
void geometry_pass_render_lights(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer rsm[LIGHT_MAP_KINDS]);

#endif
