// VAL k starts as VPL k N / M, the same every frame [Dong 2009 §6]; where that one met nothing, as the
// next one that did. Three texels a VPL: position, normal, flux.
int seed_vpl(samplerBuffer vpls, int k, int val_count, int vpl_count) {
    int i = k * vpl_count / val_count;
    for (int step = 0; step < vpl_count && texelFetch(vpls, 3 * i + 2).w == 0.0; step++)
        i = (i + 1) % vpl_count;
    return i;
}
