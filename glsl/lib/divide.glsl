// Of integers from 0 to 2^24, by floats: a software rasteriser divides integers one by one. GLSL grants divisions an error,
// which may move a quotient by one.
ivec2 divide(ivec2 a, ivec2 b) {
    ivec2 quotient = ivec2((vec2(a) + 0.5) / vec2(b)), rest = a - quotient * b;
    return quotient + ivec2(greaterThanEqual(rest, b)) - ivec2(lessThan(rest, ivec2(0)));
}
