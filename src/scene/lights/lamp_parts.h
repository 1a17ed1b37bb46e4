/* An emissive surface of any shape as a handful of rectangles that shine as it does from afar.
 *
 * Triangles near each other that face alike make a rectangle: of their middle, their mean normal, and
 * the second moments of their area, with all their flux. It lies before the foremost of their corners,
 * so that the surface does not stand in its own light.
 */
#ifndef SCENE_LIGHTS_LAMP_PARTS_H
#define SCENE_LIGHTS_LAMP_PARTS_H

struct lamp_triangle {
    double corners[3][3];
    double radiance[3]; /* the mean over it */
    double normal[3];   /* unit, where it shines */
    double area;        /* above 0 */
};

struct lamp_part {
    float center[3], right[3], up[3], normal[3];
    float size[2]; /* both above 0 */
    float radiance[3];
};

/* Makes `most` at most; returns how many. */
int lamp_parts_make(const struct lamp_triangle *triangles, int count, struct lamp_part *parts,
                    int most);

#endif
