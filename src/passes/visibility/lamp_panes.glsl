// What a medium and panes let pass of a light with a size. Panes have edges, which points of the light see apart.
#include "lib/medium.glsl"
#ifdef HAS_MEDIUM
#include "lib/tangent.glsl"

const int LAMP_PLACES = 16;

// From its middle, of a directional light one metre away; `place` is from 0 to 1.
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
