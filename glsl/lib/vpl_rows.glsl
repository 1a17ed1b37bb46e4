// A VPL from the four rows in which buffers hold it, one that emits evenly, and the colour of its cluster.
#include "shared/vpl.h"

vpl vpl_of_rows(vec4 position_and_val, vec4 normal_and_area, vec4 flux_and_reach, vec4 lobe) {
    return vpl(position_and_val.xyz, position_and_val.w, normal_and_area.xyz, normal_and_area.w,
               flux_and_reach.rgb, flux_and_reach.w, lobe.xy, lobe.z, lobe.w);
}

vpl vpl_even(vec3 position, vec3 normal, float area, vec3 flux, float reach) {
    return vpl(position, 0.0, normal, area, flux, reach, vec2(0.0), 0.0, 0.0);
}

// The false colour of a cluster.
vec3 cluster_color(int k) {
    return vec3(cluster_color(k, 0), cluster_color(k, 1), cluster_color(k, 2));
}
