// A light's own map from the views of it: the texel of a view that lies nearest in each direction.
#include "passes/visibility/light_map.glsl"

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray view_depths;
layout(location = LOCATION_LIGHT) uniform int light_index;

flat in int instance;

layout(location = TARGET_RESULT) out float depth;

const float NOTHING = 1.0;

void main() {
    light l = light_at(light_index);
    light_map m = light_map_at(l, instance);
    vec2 s = light_map_plane(m.plain, gl_FragCoord.xy / float(MAP_SIZE) * 2.0 - 1.0);
    vec3 aside = s.x * m.right + s.y * m.up;
    vec3 direction = m.orthographic ? m.forward : m.forward + aside;
    light_view v = light_view_at(light_view_index(l, direction));
    vec2 half_size2 = vec2(dot(v.view.right, v.view.right), dot(v.view.up, v.view.up));
    vec3 seen = m.orthographic ? aside : direction / dot(direction, v.view.forward);
    vec2 ndc = vec2(dot(seen, v.view.right), dot(seen, v.view.up)) / half_size2;
    ivec2 texels = textureSize(view_depths, 0).xy;
    ivec2 texel = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(texels)), ivec2(0), texels - 1);
    float stored = texelFetch(view_depths, ivec3(texel, v.layer), 0).r;
    float along = stored > 0.0 ? view_linear_depth(v.view, stored) : 1e30;
    depth = min(along * (m.orthographic ? 1.0 : dot(seen, m.forward)) / m.unit, NOTHING);
}
