// How far the nearest VPLs lie that face as VPL x does, squared: a row's part of the runs. Runs of paths are even subsets; their
// mean is steadier than one (passes/lights/bounce_paths.glsl).
#include "passes/lights/bounce_paths.glsl"

layout(location = TARGET_RESULT) out vec4 nearest_squares;

const float LIKE = 0.5; // cosine of normals
const int RUNS_PER_ROW = BOUNCE_RUNS / BOUNCE_ROWS;

float nearest2(int i, vec3 position, vec3 normal, int first, int last) {
    float nearest = params.radius * params.radius;
    for (int k = first; k < last; k++) {
        path_end other = path_end_at(ivec2(k, 0));
        vec3 apart = other.position - position;
        bool like = k != i && dot(other.normal, normal) > LIKE;
        nearest = min(nearest, like ? dot(apart, apart) : nearest);
    }
    return nearest;
}

void main() {
    int i = int(gl_FragCoord.x), first = int(gl_FragCoord.y) * RUNS_PER_ROW;
    int partners = min(params.later, BOUNCE_PARTNERS);
    vec3 position = path_position(i), normal = path_normal(i);
    int last = path_power(i) > 0.0 ? first + RUNS_PER_ROW : first;
    float sum = 0.0;
    for (int run = first; run < last; run++)
        sum += nearest2(i, position, normal, run * partners / BOUNCE_RUNS, (run + 1) * partners / BOUNCE_RUNS);
    nearest_squares = vec4(sum);
}
