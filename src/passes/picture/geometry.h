/* Draws the scene's surfaces into a G-buffer of the camera or the lights.
 *
 * The lights' G-buffer is the reflective shadow map [Dong 2009 §6; Dachsbacher and Stamminger
 * 2005]. A spot or directional light has one map, a point light six, which the papers keep in a
 * cube map. */
#ifndef PASSES_GEOMETRY_H
#define PASSES_GEOMETRY_H

#include "passes/targets.h"

struct frame;

struct geometry_pass {
    GLuint camera_program, light_program;
};

/* Targets of the camera's G-buffer, and options. has_specular: for lights' maps, too, if some
 * material is not plain. facets: lights' maps have triangle normals, not shading normals.
 * has_mappings: that of materials_have_mappings. */
struct geometry_desc {
    bool has_emission, has_specular, has_mappings, facets;
};

bool geometry_pass_init(struct geometry_pass *pass, const struct geometry_desc *desc);
void geometry_pass_free(struct geometry_pass *pass);

/* Clears and fills the camera's G-buffer; with a sensor by its plane alone. Timer "gbuffer". */
void geometry_pass_render_camera(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer *gbuffer);

/* Clears and fills the map of each light's view. Timer "rsm". */
void geometry_pass_render_lights(const struct geometry_pass *pass, const struct frame *frame,
                                 const struct gbuffer rsm[LIGHT_MAP_KINDS]);

#endif
