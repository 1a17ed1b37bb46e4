#include "techniques/element_view.h"

#include <stdlib.h>

void element_view_free(struct element_view *view) {
    free(view->bins);
    *view = (struct element_view){0};
}
