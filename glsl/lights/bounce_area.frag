// The area that path i's VPL stands for, of those around it that face alike: of random points P / A to an area the nearest
// of a share s lies within pi d^2 = A / (s P) on the mean. Runs of paths are even subsets; their mean is steadier than one.
#include "lights/bounce_paths.glsl"
#include "gather/patch.glsl"

// And how much of its power is seen to arrive as a patch sends it, and as it does.
layout(location = TARGET_RESULT) out vec4 area_and_powers;

const float PI = 3.14159265359;
const float LIKE = 0.5; // cosine of normals

float nearest2(int i, vec3 position, vec3 normal, int first, int last) {
    float nearest = params.radius * params.radius;
    for (int k = first; k < last; k++) {
        vec3 apart = path_position(k) - position;
        bool like = k != i && dot(path_normal(k), normal) > LIKE;
        nearest = min(nearest, like ? dot(apart, apart) : nearest);
    }
    return nearest;
}

void main() {
    int i = int(gl_FragCoord.x), partners = min(params.paths, BOUNCE_PARTNERS);
    vec3 position = path_position(i), normal = path_normal(i);
    float power = path_power(i), sum = 0.0;
    for (int run = 0; run < (power > 0.0 ? BOUNCE_RUNS : 0); run++)
        sum += nearest2(i, position, normal, run * partners / BOUNCE_RUNS, (run + 1) * partners / BOUNCE_RUNS);
    float share = float(partners) / float(params.paths * BOUNCE_RUNS);
    float area = PI * share * sum / float(BOUNCE_RUNS);
    float apart = path_next(i).w, arrives = apart >= 0.0 ? power : 0.0;
    float as_patch = arrives > 0.0 ? arrives * patch_share(apart * apart, area) : 0.0;
    area_and_powers = vec4(area, as_patch, arrives, 0.0);
}
