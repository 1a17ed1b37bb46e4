// The soft shadow of a VAL alone [Dong 2009 Fig. 9], or a sheet of all of them.
#include "lib/gbuffer.glsl"
#include "inspect/inspect.glsl"
#include "passes/visibility/visibility.glsl"

layout(location = TARGET_RESULT) out vec4 color;

void main() {
    color = vec4(NOTHING, 1.0);
    ivec2 size = gbuffer_size();
    inspected at = inspect_place(vec2(size));
    if (!at.present)
        return;
    ivec2 pixel = min(ivec2(at.place * vec2(size)), size - 1);
    surface s = gbuffer_surface(pixel);
    if (!s.present)
        return;
    float visible = visibility(at.layer, s.position, s.normal);
    vec3 to_val = map_view_at(at.layer).center - s.position;
    bool faces = dot(s.normal, to_val) > 0.0 && dot(map_view_at(at.layer).axis, to_val) < 0.0;
    vec3 white = faces ? vec3(INSPECT_LIT) : vec3(INSPECT_TURNED_AWAY);
    color.rgb = white * mix(INSPECT_SHADOW, 1.0, visible);
}
