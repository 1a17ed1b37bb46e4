/* One element with the partners of its bins, for the viewer. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_SHOW_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_SHOW_H

#include "techniques/element_view.h"
#include "techniques/implicit-visibility/light.h"

/* Of the element nearest to the position that faces as the normal does. The view is zeroed or freed. */
void show_element(struct element_view *view, const struct elements *elements,
                  const struct tree *tree, const struct links *links,
                  const struct element_light *light, const float position[3],
                  const float normal[3]);

#endif
