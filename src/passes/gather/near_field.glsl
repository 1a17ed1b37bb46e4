// Of the squared distance over that where the near field ends.
float near_share_at(float far) {
    far = min(far, 1.0);
    return (1.0 - far) * (1.0 - far);
}

// How much of the light from a surface point at this distance is the near field's: 1 at the point, 0
// from `reach` times the spacing of VPLs on. VPLs give the rest, so that their light stays bounded:
// G (1 - near) <= 2 cos cos / (reach^2 area).
float near_share(float distance2, float area, float reach) {
    return near_share_at(distance2 / (reach * reach * area));
}
