// VPL x's share of the light of the paths of row y.
#include "passes/lights/bounce_paths.glsl"

layout(binding = UNIT_PATH_RESULTS) uniform sampler2D path_shares;

layout(location = TARGET_RESULT) out vec4 flux;

void main() {
    ivec2 path = ivec2(gl_FragCoord.xy);
    ivec2 pool = path_power(path.x) > 0.0 && path.y > 0 ? pool_of(path.x) : ivec2(0);
    path_end end = path_end_at(ivec2(path.x, 0));
    flux = path.y > 0 ? vec4(0.0) : texelFetch(path_shares, path, 0);
    for (int k = pool.x; k < pool.y; k++) {
        ivec2 other = ivec2(k, path.y);
        vec4 light = texelFetch(path_shares, other, 0);
        float share = share_between(path_end_at(other), end);
        flux += share >= light.a ? light * share : vec4(0.0);
    }
}
