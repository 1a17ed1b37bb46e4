#include "atrium/furnishing.h"
#include "shapes/shapes.h"

#include "base/halton.h"

#include <cglm/cglm.h>
#include <math.h>

/* --- cloth ------------------------------------------------------------------------------------ */

static float wave(float turns) {
    return sinf(2.0f * GLM_PIf * turns);
}

static void place_curtain(const void *context, float u, float v, float point[3]) {
    const struct curtain *curtain = context;
    float away = (v - curtain->waist) / 0.16f;
    float bound = expf(-away * away);
    float across = (u - 0.5f) * curtain->width * (1.0f - curtain->gather * bound);
    /* Folds open towards the hem; where the cord binds they are many and tight. */
    float depth = curtain->depth * (0.35f + 0.65f * v) * (1.0f - 0.5f * bound);
    float lean = 0.03f * wave(0.7f * v + curtain->phase);
    point[0] = across + lean * v;
    point[1] = -curtain->height * v + 0.02f * bound * wave(3.0f * u + curtain->phase);
    point[2] = depth * wave(curtain->folds * u + curtain->phase + 0.12f * wave(v)) +
               0.4f * depth * wave(0.37f * curtain->folds * u + 2.0f * curtain->phase);
}

void add_curtain(struct surface *surface, const struct curtain *curtain) {
    struct sheet sheet = {place_curtain, curtain, curtain->columns, curtain->rows};
    add_sheet(surface, &sheet);
}

/* Down one side, over the rail, down the other. */
static void place_rail_cloth(const void *context, float u, float v, float point[3]) {
    const struct rail_cloth *cloth = context;
    float over = GLM_PIf * cloth->rail_radius, along = (2.0f * cloth->drop + over) * v;
    float hang = fmaxf(fmaxf(cloth->drop - along, along - cloth->drop - over), 0.0f);
    float turn = glm_clamp((along - cloth->drop) / cloth->rail_radius, 0.0f, GLM_PIf);
    float fold = cloth->depth * hang / cloth->drop * (1.0f + wave(cloth->folds * u + cloth->phase));
    /* The back comes first: the front of the sheet is what is seen from outside. */
    point[0] = (u - 0.5f) * cloth->width * (1.0f - 0.06f * hang / cloth->drop);
    point[1] = cloth->rail_radius * sinf(turn) - hang;
    point[2] = -cosf(turn) * (cloth->rail_radius + fold);
}

void add_rail_cloth(struct surface *surface, const struct rail_cloth *cloth) {
    struct sheet sheet = {place_rail_cloth, cloth, cloth->columns, cloth->rows};
    add_sheet(surface, &sheet);
}

/* --- plants ----------------------------------------------------------------------------------- */

struct leaf {
    float direction[2]; /* in x and z, unit */
    float height, reach, width;
};

/* Rises, bends outwards and droops; widest a third of the way up. */
static void place_leaf(const void *context, float u, float v, float point[3]) {
    const struct leaf *leaf = context;
    float along = 1.0f - v, out = leaf->reach * along * along;
    float rise = leaf->height * (1.6f * along - 0.85f * along * along * along);
    float half = leaf->width * (u - 0.5f) * powf(along + 0.05f, 0.4f) * (1.02f - along);
    point[0] = leaf->direction[0] * out - leaf->direction[1] * half;
    point[1] = rise - 0.4f * fabsf(u - 0.5f) * leaf->width;
    point[2] = leaf->direction[1] * out + leaf->direction[0] * half;
}

void add_plant(struct surface *surface, const struct plant *plant) {
    for (int i = 0; i < plant->leaves; i++) {
        uint32_t n = (uint32_t)(plant->seed + i + 1);
        float angle = 2.0f * GLM_PIf * (float)radical_inverse(2, n);
        float size = 0.65f + 0.35f * (float)radical_inverse(3, n);
        float open = (float)radical_inverse(5, n);
        struct leaf leaf = {.direction = {cosf(angle), sinf(angle)},
                            .height = plant->height * size * (1.05f - 0.5f * open),
                            .reach = plant->spread * size * (0.15f + 0.85f * open),
                            .width = plant->leaf_width * size};
        struct sheet sheet = {place_leaf, &leaf, 2, plant->segments};
        add_sheet(surface, &sheet);
    }
}
