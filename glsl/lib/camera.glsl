#include "lib/view.glsl"

layout(std140, binding = BLOCK_VIEW) uniform view_uniforms {
    view camera;
};
