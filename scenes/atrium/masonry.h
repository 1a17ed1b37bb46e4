/* Arches and vaults, as closed solids. */
#ifndef SCENES_MASONRY_H
#define SCENES_MASONRY_H

#include "scene/shapes/surface.h"

/* A wall in x and y, `thickness` about z = 0, with an opening in its middle: straight up to
 * `spring`, then half an ellipse. */
struct arch_wall {
    float width, low, high, thickness;
    float half_opening, spring, rise;
    int segments; /* of the half ellipse, a multiple of 4 */
};
void add_arch_wall(struct surface *surface, const struct arch_wall *wall);

/* A moulding round the opening. Points of the profile are (distance from the opening's edge,
 * z); counter-clockwise as seen on the right foot of the arch from below with +z up. All of it can
 * be seen from its first point. */
void add_archivolt(struct surface *surface, const struct arch_wall *wall, const float (*profile)[2],
                   int count);

/* A block 2 half_x by 2 half_z wide and `height` high, hollowed from below by two crossing barrel
 * vaults of this rise. */
struct groin_vault {
    float half_x, half_z, rise, height;
    int segments; /* even */
};
void add_groin_vault(struct surface *surface, const struct groin_vault *vault);

#endif
