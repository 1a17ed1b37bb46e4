// Where the ray of a texel begins: texels of a light's view have equal solid angles, or areas.

struct light_ray {
    vec3 origin, direction;
    vec3 flux; // W
};

// Of a place from 0 to 1; beyond the cap or disk there is no light. Lambert's azimuthal projection keeps areas.
light_ray light_ray_at(light l, vec2 place) {
    vec2 disk = 2.0 * place - 1.0;
    float measure = dot(disk, disk) <= 1.0 ? params.measure : 0.0;
    vec3 aside = disk.x * params.right + disk.y * params.up;
    if (params.is_disk)
        return light_ray(params.start + params.spread * aside, params.axis, l.intensity * measure);
    float below = dot(disk, disk) * params.spread; // one less the cosine
    vec3 across = sqrt(params.spread * max(2.0 - below, 0.0)) * aside;
    vec3 direction = normalize((1.0 - below) * params.axis + across);
    return light_ray(l.position, direction, light_intensity(l, direction) * measure);
}
