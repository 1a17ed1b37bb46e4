/* Light of the bins on specular surfaces [Dong 2011 §4.2.1, fig. 4.11]: each pixel weighs the links of the elements around
 * it by its BRDF, in place of their cosine.
 *
 * The thesis colours vertices; here each pixel reflects by its own normal and view. Lobes narrower than a bin are widened
 * to one. Cost: specular pixels x elements around each x links. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_SPECULAR_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_SPECULAR_H

#include "techniques/implicit-visibility/interpolate.h"

struct specular_pass {
    GLuint program;
    struct irradiance radiance; /* towards the camera */
    struct buffer links;
    uint32_t (*texels)[4]; /* of all links */
    int side;
};

/* side: of the links' bins. Error: shader, or out of GPU memory. */
bool specular_pass_init(struct specular_pass *pass, int side, int width, int height);
void specular_pass_free(struct specular_pass *pass);

/* What specular_pass_render fills, of another size, to stand in for pass->radiance. Error: out of GPU memory. */
bool specular_target_init(struct irradiance *radiance, int width, int height);

/* Makes room for the links of so many elements. Error: out of memory, or more than a shader may read; the pass must then
 * be freed. */
bool specular_pass_fit(struct specular_pass *pass, int element_count);

/* What arrives along links, times scale. Each NULL: nothing. */
struct specular_light {
    const float (*nodes)[4]; /* radiance of each of the tree's nodes */
    const float (*sky)[3];   /* of each bin, where it is empty */
    float scale;
};

/* Uploads the light of all links. */
void specular_pass_write(struct specular_pass *pass, const struct links *links,
                         const struct specular_light *light);

/* Fills pass->radiance; elements: as they were written last. Timer "specular links". */
void specular_pass_render(const struct specular_pass *pass, const struct interpolate_pass *elements,
                          const struct frame *frame, const struct gbuffer *gbuffer);

#endif
