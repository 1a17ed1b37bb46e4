/* Settings that methods with shadow maps share. */
#ifndef DIRECT_SHADOW_H
#define DIRECT_SHADOW_H

#include "base/settings.h"

struct shadow_settings {
    int size;   /* of a light's map, texels a side */
    float bias; /* receiver offset along its normal, texels */
};

extern const struct settings_part shadow_part;

#endif
