// A ray tells whether something is between a receiver and a sample of the near field.
#include "passes/visibility/bvh.glsl"

const bool NEAR_IS_TESTED = true;

// Where there is no sample, its place is the receiver's.
bool is_between(surface s, near_arrival representative, bool any) {
    return is_blocked(s.position, s.normal, representative.position);
}
