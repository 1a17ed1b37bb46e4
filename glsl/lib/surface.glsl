// Reads the G-buffer: what one pixel of the camera, or one texel of the light, sees.
#include "lib/octahedral.glsl"
#include "lib/view.glsl"

struct surface {
    bool present; // else the pixel sees nothing
    vec3 position, normal;
};

surface surface_fetch(view v, sampler2DArray depths, sampler2DArray normals, ivec3 texel) {
    surface s;
    float depth = texelFetch(depths, texel, 0).r;
    s.present = depth > 0.0;
    vec2 size = vec2(textureSize(depths, 0).xy);
    s.position = view_position(v, (vec2(texel.xy) + 0.5) / size * 2.0 - 1.0, max(depth, 1e-9)); // far where nothing is
    s.normal = octahedral_decode(texelFetch(normals, texel, 0).rg);
    return s;
}

// How much a surface bends towards what is seen beside it: the squared difference of normals; 1 where nothing is.
float surface_bend(vec3 normal, surface beside) {
    vec3 apart = beside.normal - normal;
    return beside.present ? dot(apart, apart) : 1.0;
}

// Albedo is stored as its square root, so that sixteen bits serve dark colours too.
vec3 albedo_fetch(sampler2DArray albedos, ivec3 texel) {
    vec3 root = texelFetch(albedos, texel, 0).rgb;
    return root * root;
}
