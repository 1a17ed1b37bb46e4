// Direct light of one light, at the G-buffer. Who includes it says which share of the light arrives:
#include "passes/gather/receiver_facet.glsl"
#include "lib/direction.glsl"
#include "lib/medium.glsl"

float arriving(surface s, light l, vec3 direction);

layout(location = LOCATION_LIGHT) uniform int light_index;

layout(location = TARGET_RESULT) out vec4 direct;
#ifdef HAS_SPECULAR
#include "lib/unshadowed_specular.glsl"
#include "passes/visibility/pixel_spread.glsl"

layout(location = TARGET_DIRECT_SPECULAR) out vec4 specular;

// The narrower side as an angle, rad.
float angular_width(light l, float away) {
    float width = l.shape == LIGHT_SHAPE_RECTANGLE ? min(l.width, l.height) : l.width;
    return l.shape == LIGHT_SHAPE_CAP ? width : width / max(away, 1e-20);
}
#endif

// What a medium and panes let pass of a light with a size. Panes have edges, which points of the light see apart.
#ifdef HAS_MEDIUM
const int LAMP_PLACES = 16;

// Returns a point of the lamp relative to its centre; a directional light is a metre away. `place` is from 0 to 1.
vec3 lamp_place(light l, vec3 direction, vec2 place) {
    if (l.shape == LIGHT_SHAPE_RECTANGLE)
        return (place.x - 0.5) * l.width * l.right + (place.y - 0.5) * l.height * l.up;
    bool flat_disk = l.shape == LIGHT_SHAPE_DISK;
    vec3 right = flat_disk ? l.right : perpendicular(direction), up = flat_disk ? l.up : cross(direction, right);
    return disk_place(l.shape == LIGHT_SHAPE_CAP ? tan(0.5 * l.width) : 0.5 * l.width, right, up, place);
}

vec3 lamp_passes(light l, surface s, vec3 direction, float distance2) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    float metres = directional ? MEDIUM_FAR : sqrt(distance2);
    int places = l.shape == LIGHT_SHAPE_POINT || panes_none() ? 1 : LAMP_PLACES;
    vec2 shift = places == 1 ? vec2(0.0) : random_of(uvec3(gl_FragCoord.xy, l.first_view));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < places; i++) {
        vec2 place = fract(shift + vec2(float(i) / float(places), float(i) * 0.61803399));
        vec3 to = -direction * (directional ? 1.0 : metres);
        to += places == 1 ? vec3(0.0) : lamp_place(l, direction, place);
        float away = length(to);
        sum += medium_panes(s.position, to / away, directional ? MEDIUM_FAR : away);
    }
    return sum / float(places) * medium_alone(s.position, -direction, metres);
}
#else
vec3 lamp_passes(light l, surface s, vec3 direction, float distance2) {
    return vec3(1.0);
}
#endif

// Whether the triangle is turned away from all of the light, of which nothing is farther from its middle than its sides.
// A map tells only beyond its bias, so that what is round would be lit behind its horizon, in a strip.
bool is_turned_away(surface s, ivec2 pixel, light l, vec3 to_light) {
    vec3 facet = facet_of(s, pixel);
    return is_behind_horizon(facet, to_light + facet * (0.5 * (l.width + l.height)));
}

void main() {
    direct = vec4(0.0);
#ifdef HAS_SPECULAR
    specular = vec4(0.0);
#endif
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    surface s = gbuffer_surface(pixel);
    if (!s.present)
        return;
    light l = light_at(light_index);
    vec3 to_light = l.position - s.position;
    float distance2 = dot(to_light, to_light);
    vec3 direction = l.type == LIGHT_TYPE_DIRECTIONAL ? l.direction : -to_light * inversesqrt(distance2);
    float in_range = light_in_range(l, distance2);
    float share = unshadowed(l, s.position, s.normal, direction, distance2) * in_range;
    if (is_turned_away(s, pixel, l, l.type == LIGHT_TYPE_DIRECTIONAL ? -direction : to_light))
        share = 0.0;
#ifdef HAS_SPECULAR
    if (share <= 0.0)
        return;
    float lit = arriving(s, l, direction);
    specular_surface seen = gbuffer_specular(s, pixel);
    float wide_angle = angular_width(l, sqrt(distance2));
    specular_surface wide = widened(seen, wide_angle, pixel);
    vec3 reflected = unshadowed_specular(l, wide, s.position, direction, distance2) * widened_scale(seen, wide) *
                     bent_lobe(seen, wide, -direction, wide_angle, pixel);
    direct.rgb = l.radiance * (share * lit * diffuse_share(seen, direction));
    specular.rgb = l.radiance * reflected * lit * in_range;
#else
    direct.rgb = l.radiance * (share > 0.0 ? share * arriving(s, l, direction) : 0.0);
#endif
    vec3 passes = lamp_passes(l, s, direction, distance2);
#ifdef HAS_SLIDES
    passes *= light_slide(l, direction);
#endif
    direct.rgb *= passes;
#ifdef HAS_SPECULAR
    specular.rgb *= passes;
#endif
}
