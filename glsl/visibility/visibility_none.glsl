float visibility(int map, vec3 position, vec3 normal) {
    return 1.0;
}
