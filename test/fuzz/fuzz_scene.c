#include "fuzz/fuzz.h"

#include "scene/open.h"

void fuzz_scene(const uint8_t *bytes, size_t size) {
    struct scene scene;
    struct geometry geometry;
    if (!scene_open(&scene, &geometry, fuzz_file(bytes, size), NULL))
        return;
    geometry_free(&geometry);
    scene_free(&scene);
}
