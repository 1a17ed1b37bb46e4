// Candidates of the first round: as many of each light.
float vpl_choose(vec3 point, out int index, out vec2 place) {
    index = min(int(point.z * float(light_count)), light_count - 1);
    place = point.xy;
    return 1.0;
}
