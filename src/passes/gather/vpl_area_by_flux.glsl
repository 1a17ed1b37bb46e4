// The area of a VPL of light `index` at a place of its domain, where `area` is its area by flux alone: the same.
float vpl_area_at(float area, int index, vec2 place) {
    return area;
}
