#include "techniques/technique.h"

extern const struct technique clustered_technique;
extern const struct technique instant_radiosity_technique;
extern const struct technique unshadowed_technique;

const struct technique *const techniques[] = {
    &clustered_technique,
    &instant_radiosity_technique,
    &unshadowed_technique,
    NULL,
};

const char *const technique_names[] = {"clustered", "instant-radiosity", "unshadowed", NULL};
