// The pixel's samples, and the planes that pixels see.
#include "lib/plane.glsl"
#include "shared/antialias.h"

layout(binding = UNIT_SAMPLE_DEPTH) uniform sampler2DMSArray sample_depths;

float sample_depth(ivec2 pixel, int i) {
    return texelFetch(sample_depths, ivec3(pixel, i / SAMPLES_PER_LAYER), i % SAMPLES_PER_LAYER).r;
}
