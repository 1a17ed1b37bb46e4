// Which half x lies in; x is stretched over this half.
int take_half(inout float x, float first, float second) {
    float share = first / max(first + second, 1e-30);
    bool is_first = x < share;
    x = is_first ? x / share : (x - share) / max(1.0 - share, 1e-6);
    x = min(x, 0.999999);
    return is_first ? 0 : 1;
}
