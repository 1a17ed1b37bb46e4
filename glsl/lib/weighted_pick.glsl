// One of many, picked in proportion to its weight while they come: whether this one stands for all up to it, which weigh `sum`.
// One number serves all: within the part that it fell into it is as random as before.
bool weighted_pick(float own, float sum, inout float random) {
    float share = own / max(sum, 1e-30);
    bool taken = random < share;
    random = (taken ? random : random - share) / max(taken ? share : 1.0 - share, 1e-6);
    return taken;
}
