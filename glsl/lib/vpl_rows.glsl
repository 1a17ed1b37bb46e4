// A VPL from the three rows in which buffers hold it.
#include "shared/vpl.h"

vpl vpl_of_rows(vec4 position_and_val, vec4 normal_and_area, vec4 flux_and_reach) {
    return vpl(position_and_val.xyz, position_and_val.w, normal_and_area.xyz, normal_and_area.w,
               flux_and_reach.rgb, flux_and_reach.w);
}
