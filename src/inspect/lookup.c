#include "inspect/lookup.h"

#include "gl/program.h"
#include "shared/maps.h"

#include <stdlib.h>
#include <string.h>

bool lookup_fit(struct lookup *lookup, const char *fragment, const struct visibility_desc *desc) {
    char *defines = visibility_defines(desc);
    if (lookup->defines && strcmp(lookup->defines, defines) == 0) {
        free(defines);
        return true;
    }
    lookup_free(lookup);
    lookup->defines = defines;
    if (program_init(&lookup->program,
                     &(struct program_desc){.screen = {fragment}, .defines = defines}) &&
        buffer_init(&lookup->params, "inspected visibility parameters",
                    sizeof(struct lookup_params), NULL))
        return true;
    lookup_free(lookup);
    return false;
}

void lookup_free(struct lookup *lookup) {
    program_free(&lookup->program);
    buffer_free(&lookup->params);
    free(lookup->defines);
    *lookup = (struct lookup){0};
}
