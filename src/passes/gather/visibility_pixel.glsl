// Visibility that a pixel finds by itself, of each light.
#include "passes/visibility/visibility.glsl"

// Whether a light's own arrives there, by that map.
float visibility_of(int map, surface s, vec3 light) {
    return visibility_from(map, s.position, s.normal, light);
}

// Loops and no branches: a software rasteriser leaves a loop that no pixel is in after one step, but executes both
// sides of a branch.
vec3 light_by_pixel(surface s, ivec2 lights) {
    vec3 sum = vec3(0.0), back;
    for (int i = lights.x; i < lights.y; i++) {
        vpl light = light_at(i);
        vec3 own = unshadowed(i, light, s, back);
        float visible = 1.0;
        for (int lit = own + back != vec3(0.0) ? 1 : 0; lit > 0; lit--)
            visible = visibility_of(map_of(i, light), s, light.position);
        sum += arriving(own, back, visible);
    }
    return sum;
}
