/* Converts the scene's arrays to cglm's vectors, which are passed by value. */
#ifndef REFERENCE_VECTOR_H
#define REFERENCE_VECTOR_H

#include "base/unit.h"

static inline vec3s vector_of(const float v[3]) {
    return (vec3s){{v[0], v[1], v[2]}};
}

#endif
