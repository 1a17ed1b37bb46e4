/* Approximates an emissive surface by a few rectangles that emit like it from afar.
 *
 * Nearby triangles with similar normals form a rectangle of their centre, mean normal, second
 * moments of area and total flux. It is in front of their foremost corner, so that the surface does
 * not shadow it. */
#ifndef SCENE_LIGHTS_LAMP_PARTS_H
#define SCENE_LIGHTS_LAMP_PARTS_H

struct lamp_triangle {
    double corners[3][3];
    double radiance[3]; /* mean over the triangle, W/(sr m2) */
    double normal[3];   /* unit, on the emitting side */
    double area;        /* above 0 */
};

struct lamp_part {
    float center[3], right[3], up[3], normal[3];
    float size[2]; /* both above 0 */
    float radiance[3];
};

/* Makes at most `most` rectangles; returns their number. */
int lamp_parts_make(const struct lamp_triangle *triangles, int count, struct lamp_part *parts,
                    int most);

#endif
