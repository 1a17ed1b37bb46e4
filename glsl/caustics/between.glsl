// Light between two smooth surfaces outside glass. A ray keeps one of these segments, chosen by chance in proportion to
// its light times its length, and it stands for all of them (reservoir sampling).

vec3 between_from = vec3(0.0), between_to = vec3(0.0);
vec3 between_flux = vec3(0.0); // over the segment's weight
float between_weights = 0.0;   // of all segments

void between_add(walk w, float metres, float number) {
    float weight = dot(w.flux, vec3(1.0)) * max(metres, 0.0);
    between_weights += weight;
    if (number * between_weights < weight) {
        between_from = w.place;
        between_to = w.origin + metres * w.direction;
        between_flux = w.flux / weight;
    }
}

// Red and green, over the sum of three channels, as one whole number. Chance rounds, so that each channel is right on
// average, however small its share.
void between_pack(float number, out vec4 leave, out vec4 end) {
    float red_green = between_flux.r + between_flux.g, sum = red_green + between_flux.b;
    vec2 shares = sum > 0.0 ? vec2(between_flux.r, red_green) / sum : vec2(0.0);
    vec2 levels = min(floor(shares * BETWEEN_LEVELS + number), BETWEEN_LEVELS);
    leave = vec4(between_from, sum * between_weights);
    end = vec4(between_to, levels.x * (BETWEEN_LEVELS + 1.0) + levels.y - levels.x);
}
