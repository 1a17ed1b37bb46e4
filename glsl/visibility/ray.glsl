// Whether a VPL's own light reaches a point, by the map of its VAL: a ray from the point to the VPL through what
// the VAL's centre saw [Agrawala et al. 2000]. One centre cannot speak for a wide cluster, but it saw most of what
// lies between: a place of the ray that lies a little behind what the map has there is within a caster.
#include "visibility/depth_maps.glsl"

const int RAY_PLACES = 8;
// Casters are as deep as this, over the point's distance from the centre: farther behind them the ray passes where
// the centre does not see. A little more than between two places, so that no wall is stepped over.
const float CASTER_DEPTH = 0.3;

bool within_caster(float distance, float seen, float deep) {
    return distance > seen && distance < seen + deep;
}

float visibility_from(int map, vec3 position, vec3 normal, vec3 light) {
    map_view v = map_view_at(map);
    receiver r;
    if (!project(v, position, normal, r))
        return 1.0;
    float deep = CASTER_DEPTH * r.distance;
    vec3 to_light = paraboloid_local(v, light) - r.point;
    bool hidden = false;
    for (int i = 0; i < RAY_PLACES && !hidden; i++) {
        vec3 place = r.point + float(i) / float(RAY_PLACES) * to_light;
        float distance = length(place);
        ivec2 texel = ivec2((paraboloid_project(place / distance) * 0.5 + 0.5) * lookup.map_size);
        float seen = texelFetch(depth_maps, ivec3(texel, map), 0).r * r.unit;
        float compared = i == 0 ? receiver_distance(r, texel) : distance * (1.0 - lookup.map_bias);
        bool known = place.z > 0.05 * distance; // the map has nothing behind its plane, and little beside it
        hidden = (known && within_caster(compared, seen, deep));
    }
    return hidden ? 0.0 : 1.0;
}
