// Marks in the scene: points and lines over its picture.
#include "lib/cluster_color.glsl"
#include "lib/view.glsl"
#include "shared/params.h"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    mark_params params;
};

// How strongly a VAL is drawn.
float cluster_strength(int k) {
    if (params.chosen < 0.0 || k == int(params.chosen))
        return 1.0;
    return params.only_chosen > 0.5 ? 0.0 : 0.25;
}
