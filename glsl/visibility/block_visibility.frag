// The visibility of map `instance` at the centre of each block.
#include "lib/gbuffer.glsl"
#include "visibility/visibility.glsl"
#include "shared/block_visibility.h"

flat in int instance;

layout(location = TARGET_RESULT) out float visible;

void main() {
    int size = params.block;
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * size + size / 2, gbuffer_size() - 1);
    surface s = gbuffer_surface(pixel);
    bool used = map_view_at(instance).near < MAP_VIEW_EMPTY;
    visible = used && s.present ? visibility(instance, s.position, s.normal) : 1.0;
}
