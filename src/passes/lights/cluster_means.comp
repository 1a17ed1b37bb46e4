// k-means by one workgroup, all iterations in one dispatch: a step waits for the step before, and a launch costs
// more than a step. First it seeds the VALs, where it is told to. Many VPLs or iterations take several dispatches.
//
// An iteration has two parts. Each invocation finds the nearest VAL of a VPL, for as many VPLs as there is room
// for; then each invocation adds one row of one VAL's sums. Sums are added in the order of VPLs, so that they do not
// depend on the chip. The second part divides [Dong 2009 §6].
#include "shared/cluster.h"

layout(local_size_x = CLUSTER_GROUP) in;
layout(rgba32f, binding = IMAGE_VAL_POSITION) coherent uniform image2D vals_position; // w: count
layout(rgba32f, binding = IMAGE_VAL_NORMAL) coherent uniform image2D vals_normal;
layout(rgba32f, binding = IMAGE_VAL_FLUX) coherent uniform image2D vals_flux;
layout(rgba32f, binding = IMAGE_VAL_SUMS) coherent uniform image2D val_sums; // a row each of the three

vec3 val_position(int k) {
    return imageLoad(vals_position, ivec2(k, 0)).xyz;
}

vec3 val_normal(int k) {
    return imageLoad(vals_normal, ivec2(k, 0)).xyz;
}

vec3 val_flux(int k) {
    return imageLoad(vals_flux, ivec2(k, 0)).rgb;
}

#define VALS_AS_IMAGES
#include "passes/lights/val_distance.glsl"

// VAL k starts as VPL k N / M, the same every frame [Dong 2009 §6]; of many as VPL k: Halton's first points are even,
// and those N / M apart are not where that is a power of two. Where that one met nothing, as the next one that did.
// With SEEDED as a VPL that is told, or nowhere.
#include "lib/vpl_texels.glsl"

#if SEEDED
layout(binding = UNIT_SEEDS) uniform sampler2D seeds; // numbers; -1: none
#endif

bool has_seed(int k) {
#if SEEDED
    return texelFetch(seeds, ivec2(k, 0), 0).r > VAL_SEED_NOWHERE;
#else
    return true;
#endif
}

vpl seed_vpl(int k) {
#if METRIC == CLUSTER_METRIC_SQUARES
    int i = k % params.vpl_count;
#else
    int i = k * params.vpl_count / params.val_count;
#endif
#if SEEDED
    int told = int(texelFetch(seeds, ivec2(k, 0), 0).r);
    i = told < 0 ? i : told;
#endif
    for (int step = 0; step < params.vpl_count && vpl_at(i).reach == 0.0; step++)
        i = (i + 1) % params.vpl_count;
    return vpl_at(i);
}

#if WEIGHTED
// How much VPL i counts where VPLs are clustered: by what it would give to the picture, and a little for all, as what is
// between is not asked and what is hardly seen needs a cluster, too.
layout(binding = UNIT_VPL_VALUES) uniform sampler2D vpl_values;
layout(binding = UNIT_VPL_VALUE_SUM) uniform sampler2D vpl_value_sum; // and how many VPLs have light

float vpl_weight(int i, vpl v) {
    const float FOR_ALL = 0.1, LEAST = 1e-30; // of the mean; where the picture shows nothing
    vec2 sum = texelFetch(vpl_value_sum, ivec2(0), 0).rg;
    float mean = sum.r / max(sum.g, 1.0);
    float weight = mix(texelFetch(vpl_values, ivec2(i, 0), 0).r, mean, FOR_ALL) + LEAST;
    return v.reach > 0.0 ? weight : 0.0;
}
#endif

const int NO_VAL = -1;
const float FAR_OFF = 1e15; // metres: nobody's nearest

// Of the VPLs at hand: their VALs, and what they add to each of the three rows.
shared int nearest[CLUSTER_GROUP];
shared vec4 added[3][CLUSTER_GROUP];

int local() {
    return int(gl_LocalInvocationIndex);
}

void wait_for_all() {
    memoryBarrierImage();
    memoryBarrierShared();
    barrier();
}

float weight_of(int i, vpl v) {
#if METRIC == CLUSTER_METRIC_SQUARES
    return dot(v.flux, vec3(1.0));
#elif WEIGHTED
    return vpl_weight(i, v);
#else
    return 1.0;
#endif
}

void store_val(int k, vec4 position, vec3 normal, vec3 flux) {
    imageStore(vals_position, ivec2(k, 0), position);
    imageStore(vals_normal, ivec2(k, 0), vec4(normal, 0.0));
    imageStore(vals_flux, ivec2(k, 0), vec4(flux, 0.0));
}

void seed(int k) {
    vpl v = seed_vpl(k);
    store_val(k, vec4(has_seed(k) ? v.position : vec3(FAR_OFF), 0.0), v.normal, v.flux);
}

void take_vpl(int i) {
    nearest[local()] = NO_VAL;
    if (i >= params.vpl_count)
        return;
    vpl v = vpl_at(i);
    if (v.reach == 0.0)
        return;
    float weight = weight_of(i, v);
    nearest[local()] = nearest_val(v);
    added[0][local()] = vec4(v.position * weight, 1.0);
    added[1][local()] = vec4(v.normal * weight, weight);
    added[2][local()] = vec4(v.flux, 0.0);
}

void add_taken(int row, int k, bool first) {
    vec4 sum = first ? vec4(0.0) : imageLoad(val_sums, ivec2(k, row));
    for (int i = 0; i < CLUSTER_GROUP; i++)
        sum += nearest[i] == k ? added[row][i] : vec4(0.0);
    imageStore(val_sums, ivec2(k, row), sum);
}

// After the last VPL of the dispatch.
int vpls_end() {
    return min(params.first_vpl + CLUSTER_GROUPS_MAX(params.val_count) * CLUSTER_GROUP, params.vpl_count);
}

void add_all() {
    for (int first = params.first_vpl; first < vpls_end(); first += CLUSTER_GROUP) {
        take_vpl(first + local());
        wait_for_all();
        for (int i = local(); i < 3 * params.val_count; i += CLUSTER_GROUP)
            add_taken(i / params.val_count, i % params.val_count, first == 0);
        wait_for_all();
    }
}

// Sums become means. An empty cluster keeps its centre, or begins again from its seed [Prutkin 2012 §4]; a mean
// normal of zero keeps the old one.
void divide(int k) {
    vec4 position = imageLoad(val_sums, ivec2(k, 0)), normal = imageLoad(val_sums, ivec2(k, 1));
    float count = position.w, strength = length(normal.xyz);
    vec3 empty_position = val_position(k), empty_normal = val_normal(k);
    if (count == 0.0 && params.reseed) {
        vpl v = seed_vpl(k);
        empty_position = v.position;
        empty_normal = v.normal;
    }
    store_val(k, vec4(count > 0.0 ? position.xyz / normal.w : empty_position, count),
              strength > 1e-6 * normal.w ? normal.xyz / strength : empty_normal, imageLoad(val_sums, ivec2(k, 2)).rgb);
}

void main() {
    for (int k = local(); params.seeds && k < params.val_count; k += CLUSTER_GROUP)
        seed(k);
    wait_for_all();
    for (int i = 0; i < params.iterations; i++) {
        add_all();
        for (int k = local(); vpls_end() == params.vpl_count && k < params.val_count; k += CLUSTER_GROUP)
            divide(k);
        wait_for_all();
    }
}
