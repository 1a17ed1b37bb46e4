// Where the ray of a texel begins: texels of a light's view have equal solid angles, or areas.

// From a square to a disk that keeps ratios of areas, both from -1 to 1 [Shirley and Chiu 1997].
vec2 disk_of_square(vec2 place) {
    const float QUARTER = 0.785398163397;
    vec2 a = abs(place);
    float far = max(a.x, a.y), near = min(a.x, a.y);
    float turn = QUARTER * (far > 0.0 ? near / far : 0.0);
    vec2 direction = a.x >= a.y ? vec2(cos(turn), sin(turn)) : vec2(sin(turn), cos(turn));
    return far * direction * mix(vec2(1.0), vec2(-1.0), lessThan(place, vec2(0.0)));
}

struct light_ray {
    vec3 origin, direction;
    vec3 flux; // W
};

// Of a place from 0 to 1; beyond it there is no light.
light_ray light_ray_at(light l, vec2 place) {
    vec2 disk = disk_of_square(2.0 * place - 1.0);
    bool is_within = all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, vec2(1.0)));
    float measure = is_within ? params.measure : 0.0;
    vec3 aside = disk.x * params.right + disk.y * params.up;
    if (params.is_disk)
        return light_ray(params.start + params.spread * aside, params.axis, l.intensity * measure);
    float below = dot(disk, disk) * params.spread; // one less the cosine
    vec3 direction = normalize((1.0 - below) * params.axis + sqrt(params.spread * (2.0 - below)) * aside);
    return light_ray(l.position, direction, light_intensity(l, direction) * measure);
}
