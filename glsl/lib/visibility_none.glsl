float visibility(int map, vec3 position) {
    return 1.0;
}
