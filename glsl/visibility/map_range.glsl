// The distance from a point to the farthest corner of a box.
float farthest_corner(vec3 from, vec3 bounds_min, vec3 bounds_max) {
    return length(max(abs(from - bounds_min), abs(from - bounds_max)));
}
