// The area of a VPL of light `index` at a point, where `area` is its area by flux alone: the same.
float vpl_area_at(float area, int index, light l, vec3 position) {
    return area;
}
