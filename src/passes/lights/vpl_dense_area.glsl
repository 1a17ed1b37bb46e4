// The area of a VPL, where `area` is its area by flux alone. Sparse VPLs keep this area, so that near fields never grow.
float vpl_dense_area(float area, float density) {
    return area / max(density, 1.0);
}
