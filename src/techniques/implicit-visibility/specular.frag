// Light along the links of the elements around each pixel's surface, reflected by its specular part: the bins' radiance
// times the BRDF, which eq. 4.2 of [Dong 2011] has for each bin.
#include "lib/gbuffer_specular.glsl"
#include "techniques/implicit-visibility/elements.glsl"
#include "lib/direction.glsl"

layout(std430, binding = STORAGE_ELEMENT_LINKS) readonly buffer element_link_storage {
    // STRIDE of each element: the number of its links, then their radiance times the bin's solid angle, and direction.
    uvec4 element_links[];
};

layout(location = TARGET_RESULT) out vec4 result;

// Elements of less weight would cost time alone.
const float LEAST_WEIGHT = 1e-3;

vec3 along_link(specular_surface s, int k, int last) {
    uvec4 link = element_links[min(k, last)];
    vec3 arrives = k <= last ? uintBitsToFloat(link.rgb) : vec3(0.0);
    return specular_brdf(s, octahedral_decode(unpackUnorm2x16(link.w))) * arrives;
}

vec3 along_four(specular_surface s, int k, int last) {
    vec3 two = along_link(s, k, last) + along_link(s, k + 1, last);
    return two + along_link(s, k + 2, last) + along_link(s, k + 3, last);
}

// Eight links a step: llvmpipe ends all loops of an invocation after 65,536 steps.
vec3 reflected(specular_surface s, int element) {
    vec3 sum = vec3(0.0);
    int first = STRIDE * element, last = first + int(element_links[first].x);
    for (int k = first + 1; k <= last; k += 8)
        sum += along_four(s, k, last) + along_four(s, k + 4, last);
    return sum;
}

void main() {
    result = vec4(0.0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    surface s = gbuffer_surface(pixel);
    if (!s.present)
        return;
    specular_surface reflector = gbuffer_specular(s, pixel);
    if (reflector.f0 == vec3(0.0))
        return;
    // A lobe narrower than a bin would fall between bins: half vectors of neighbours lie 1 / SIDE apart.
    reflector.alpha = max(reflector.alpha, 1.0 / float(SIDE));
    vec4 sum = vec4(0.0);
    for (int k = 0; k < ELEMENT_ROWS; k++) {
        ivec2 row = element_row(s.position, k);
        for (int number = row.x; number < row.y; number++) {
            vec3 path;
            float weight = element_weight(s, number, path);
            if (weight > LEAST_WEIGHT)
                sum += weight * vec4(reflected(reflector, int(elements[ELEMENT_TEXELS * number + 2].w)), 1.0);
        }
    }
    result = vec4(sum.w > 0.0 ? sum.rgb / sum.w : vec3(0.0), 1.0);
}
