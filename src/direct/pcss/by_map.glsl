// The share of a light that is free, by its map at one distance, that of what hides it on the mean.
const float KERNEL_MIN = 0.75; // of a texel's width, from the middle: a smaller one would show steps

float free_share(surface at, light l, shape s, place x, casters c, float texel_width) {
    float t = c.mean, width = texel_width * (IS_SUN ? 1.0 : 1.0 - t), blocked = 0.0, free = 0.0;
    vec2 widen = max(vec2(1.0), KERNEL_MIN * width / (max(t, 1e-6) * vec2(length(s.right), length(s.up))));
    // What is in front and yet hides nothing, as a thing close to the light, tells nothing of what is behind it.
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in after one step.
    for (int i = 0; i < (t > 0.0 ? FILTER_TAPS : 0); i++) {
        map_texel found = texel_at(l, on_way(s, x, shape_point(s, i) * widen, t));
        if (!is_blocked(x, found))
            free += 1.0;
        else if (hidden_at(s, x, found) > 0.0)
            blocked += 1.0;
    }
    return t > 0.0 ? free / max(free + blocked, 1.0) : 1.0;
}
