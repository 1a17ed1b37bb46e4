// Light between two smooth surfaces outside glass. A ray keeps one of these segments, chosen by chance in proportion to
// its light times its length, and it stands for all of them (reservoir sampling).

vec3 between_from = vec3(0.0), between_to = vec3(0.0);
vec3 between_flux = vec3(0.0); // over the segment's weight
float between_weights = 0.0;   // of all segments

void between_add(walk w, float metres, float share, float number) {
    float weight = share * dot(w.flux, vec3(1.0)) * metres;
    between_weights += weight;
    if (number * between_weights < weight) {
        between_from = w.place;
        between_to = w.origin + metres * w.direction;
        between_flux = share * w.flux / weight;
    }
}

// Red and green, over the sum of three channels, as one whole number.
void between_pack(out vec4 leave, out vec4 end) {
    float sum = dot(between_flux, vec3(1.0));
    vec2 shares = sum > 0.0 ? round(between_flux.rg / sum * BETWEEN_LEVELS) : vec2(0.0);
    leave = vec4(between_from, sum * between_weights);
    end = vec4(between_to, shares.x * (BETWEEN_LEVELS + 1.0) + shares.y);
}
