// Neighbours in number get hues far apart: steps of the golden ratio.
vec3 cluster_color(int k) {
    float hue = fract(0.1 + float(k) * 0.61803399) * 6.0;
    vec3 pure = clamp(abs(mod(hue + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0);
    float pale = k % 2 == 0 ? 0.15 : 0.4;
    return mix(pure, vec3(1.0), pale) * (k % 3 == 0 ? 0.8 : 1.0);
}
