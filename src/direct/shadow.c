#include "direct/shadow.h"

#include <stddef.h>

static const struct option table[] = {
    {"shadow-size", 0, OPTION_INT, offsetof(struct shadow_settings, size), 2048, 16, 16384,
     .help = "shadow map of a light, texels a side"},
    {"shadow-bias", 0, OPTION_FLOAT, offsetof(struct shadow_settings, bias), 1.5, 0, 100,
     .help = "receiver offset along its normal, in shadow texels"},
    {NULL},
};

const struct settings_part shadow_part = {"direct", "shadow maps of direct light", table,
                                          sizeof(struct shadow_settings)};
