/* Direct light of sampled lights (passes/sampled_lights.h) on top of another method, which has all
 * lights with maps and the environment. The renderer chooses it where lights are many. */
#ifndef DIRECT_SAMPLED_H
#define DIRECT_SAMPLED_H

#include "direct/direct.h"

extern const struct direct_method sampled_direct;

#endif
