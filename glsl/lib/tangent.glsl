// A unit vector perpendicular to a unit vector, continuous but at one point [Duff et al. 2017].
vec3 perpendicular(vec3 n) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    return vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// A unit direction around a unit axis, by its cosine.
vec3 cosine_direction(vec3 axis, vec2 number) {
    float turn = 6.28318530718 * number.y, radius = sqrt(number.x);
    vec3 right = perpendicular(axis);
    return sqrt(1.0 - number.x) * axis + radius * (cos(turn) * right + sin(turn) * cross(axis, right));
}

// A place of a disk around the origin, evenly over its area.
vec3 disk_place(float radius, vec3 right, vec3 up, vec2 place) {
    float turn = 6.28318531 * place.y;
    return radius * sqrt(place.x) * (cos(turn) * right + sin(turn) * up);
}
