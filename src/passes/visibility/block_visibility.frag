// The visibility of map `instance` at the centre of each block.
#include "shared/maps.h"

PASS_BLOCK(block_visibility_params, 16)

#include "passes/gather/block.glsl"
#include "passes/visibility/visibility.glsl"

flat in int instance;

layout(location = TARGET_RESULT) out float visible;

void main() {
    surface s = gbuffer_surface(block_center(ivec2(gl_FragCoord.xy)));
    bool used = map_view_at(instance).near < MAP_VIEW_EMPTY;
    visible = used && s.present ? visibility(instance, s.position, s.normal) : 1.0;
}
