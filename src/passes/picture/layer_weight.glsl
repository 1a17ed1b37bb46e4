#include "shared/composite.h"

// Takes the place of the albedo where it is zero, so that the light on a black surface is told.
const float LEAST_WEIGHT = 1e-6;

// What a pass counts for in a layer's mean, by its weight, the share of the pixel that it covers and its
// albedo; likewise sums of them.
vec3 layer_weight(int layer, float weight, float coverage, vec3 albedo) {
    if (layer == LAYER_DIRECT || layer == LAYER_INDIRECT || layer == LAYER_CAUSTIC)
        return albedo + LEAST_WEIGHT * coverage;
    return vec3(layer == LAYER_NORMAL || layer == LAYER_DEPTH ? coverage : weight);
}
