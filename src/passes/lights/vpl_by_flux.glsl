// VPLs by flux: points know their light (passes/lights/vpl.c).
float vpl_choose(vec3 point, out int index, out vec2 place) {
    index = int(point.z);
    place = point.xy;
    return 1.0;
}
