#include "techniques/output.h"

#include <assert.h>
#include <string.h>

void output_add(struct output_list *list, const struct output *output) {
    assert(list->count < OUTPUTS_MAX && !output_find(list, output->name));
    list->items[list->count++] = *output;
}

const struct output *output_find(const struct output_list *list, const char *name) {
    for (int i = 0; name && i < list->count; i++)
        if (strcmp(list->items[i].name, name) == 0)
            return &list->items[i];
    return NULL;
}

static const void *first_of(const struct output_list *list, enum output_kind kind) {
    for (int i = 0; i < list->count; i++)
        if (list->items[i].kind == kind)
            return list->items[i].source;
    return NULL;
}

const struct vpl_buffer *output_vpls(const struct output_list *list) {
    return first_of(list, OUTPUT_VPLS);
}

const struct val_output *output_vals(const struct output_list *list) {
    return first_of(list, OUTPUT_VALS);
}
