// Keeps the pixels of whose samples one lies off what the pixel's centre sees: the others need no assignment.
#include "passes/picture/sample_plane.glsl"

// On its own plane a sample stays within this, over the pixel's width there.
const float PLANE_TOLERANCE = 0.1;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    plane center = plane_of(pixel);
    float off = 0.0;
    for (int i = 0; i < SAMPLES; i++)
        off = max(off, off_plane(center, params.places[i].xy, sample_depth(pixel, i)));
    if (off <= PLANE_TOLERANCE * center.across)
        discard;
}
