// Of integers from 0 to 2^22, by floats: a software rasteriser divides integers one by one.
ivec2 divide(ivec2 a, ivec2 b) {
    return ivec2((vec2(a) + 0.5) / vec2(b));
}
