/* A cube for tiny glTF files (gltf_parts.h). */
#ifndef TEST_CUBE_PARTS_H
#define TEST_CUBE_PARTS_H

#include "gltf_parts.h"

/* The cube's edge is 2 m. It lies in the buffer at PARTS_EXTRA: corners at 64, indices of triangles
 * that face outwards at 160, inwards at 196, a place for the test's own bytes at 232. */
struct cube_bytes {
    float corners[8][3];
    uint8_t outwards[36], inwards[36];
};

/* Accessors 0 to 2 of the three. */
#define CUBE_ACCESSORS                                                                             \
    "{bufferView: 0, byteOffset: 64, componentType: 5126, count: 8, type: VEC3}, {bufferView: 0, " \
    "byteOffset: 160, componentType: 5121, count: 36, type: SCALAR}, {bufferView: 0, byteOffset: " \
    "196, componentType: 5121, count: 36, type: SCALAR}"

static inline struct cube_bytes make_cube(void) {
    static const uint8_t faces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                        {4, 6, 7, 5}, {0, 1, 3, 2}, {2, 3, 7, 6}};
    struct cube_bytes cube = {0};
    for (int i = 0; i < 8; i++)
        for (int c = 0; c < 3; c++)
            cube.corners[i][c] = i >> c & 1 ? 1 : -1;
    for (int f = 0; f < 6; f++)
        for (int k = 0; k < 6; k++) {
            uint8_t corner = faces[f][k < 3 ? k : k == 3 ? 0 : k - 2];
            cube.inwards[f * 6 + k] = corner;
            cube.outwards[f * 6 + 5 - k] = corner;
        }
    return cube;
}

#endif
