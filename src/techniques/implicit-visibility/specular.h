/* Renders light of the bins on specular surfaces [Dong 2011 §4.2.1, fig. 4.11]. Each pixel weights
 * the links of nearby elements by its BRDF instead of their cosine.
 *
 * The thesis colours vertices; here each pixel reflects by its own normal and view. Lobes narrower
 * than a bin are widened to it. Cost: specular pixels x nearby elements x links. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_SPECULAR_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_SPECULAR_H

#include "techniques/implicit-visibility/interpolate.h"

struct specular_pass {
    GLuint program;
    struct irradiance radiance; /* towards the camera */
    struct buffer links;
    uint32_t (*texels)[4]; /* upload buffer of all links */
    int side;
};

/* side: side of the links' bins. Error: shader, or out of GPU memory. */
bool specular_pass_init(struct specular_pass *pass, int side, int width, int height);
void specular_pass_free(struct specular_pass *pass);

/* Makes a target like pass->radiance in another size, to replace it. Error: out of GPU memory. */
bool specular_target_init(struct irradiance *radiance, int width, int height);

/* Reserves memory for the links of element_count elements. Error: out of memory, or more than a
 * shader can read; the caller must then free the pass. */
bool specular_pass_fit(struct specular_pass *pass, int element_count);

/* Light along links, before `scale`. Either may be NULL: none. */
struct specular_light {
    const float (*nodes)[4]; /* radiance of each node of the tree */
    const float (*sky)[3];   /* radiance of each empty bin */
    float scale;
};

/* Uploads the light of all links. */
void specular_pass_write(struct specular_pass *pass, const struct links *links,
                         const struct specular_light *light);

/* Fills pass->radiance. `elements` must be the elements of the last interpolate_pass_write. Timer
 * "specular links". */
void specular_pass_render(const struct specular_pass *pass, const struct interpolate_pass *elements,
                          const struct frame *frame, const struct gbuffer *gbuffer);

#endif
