// VPLs by flux: points know their light (passes/lights/vpl.c).
float vpl_choose(vec3 point, out int light, out vec2 place) {
    light = int(point.z);
    place = point.xy;
    return 1.0;
}
