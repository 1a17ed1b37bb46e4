#include "reference/scene/rectangle.h"

#include <math.h>

static const double least_solid_angle = 1e-4;

static double along(const float axis[3], const double v[3]) {
    return (double)axis[0] * v[0] + (double)axis[1] * v[1] + (double)axis[2] * v[2];
}

/* Of the outward normal of the plane through the point and a side, which lies c outwards of the
 * point, the part across the rectangle. */
static double normal_part(double c, double z) {
    return c / sqrt(z * z + c * c);
}

bool rectangle_see(struct seen_rectangle *seen, const struct emitter *light, vec3s from) {
    double v[3];
    for (int c = 0; c < 3; c++)
        v[c] = (double)light->position[c] - (double)from.raw[c];
    double x = along(light->right, v), y = along(light->up, v);
    double width = (double)light->size[0], height = (double)light->size[1];
    *seen = (struct seen_rectangle){.x = {x - width / 2, x + width / 2},
                                    .y = {y - height / 2, y + height / 2},
                                    .z = -fabs(along(light->direction, v))};
    if (seen->z == 0)
        return false;
    /* The angles between neighbouring sides' planes, at (x0,y0)-(x1,y0) and on. */
    double bottom = normal_part(-seen->y[0], seen->z), top = normal_part(seen->y[1], seen->z);
    double right = normal_part(seen->x[1], seen->z), left = normal_part(-seen->x[0], seen->z);
    seen->first = 2 * GLM_PI - acos(-top * left) - acos(-left * bottom);
    seen->solid_angle = acos(-bottom * right) + acos(-right * top) - seen->first;
    seen->normal_y[0] = bottom;
    seen->normal_y[1] = top;
    return seen->solid_angle > least_solid_angle;
}

static double clamp(double value, double low, double high) {
    return fmin(fmax(value, low), high);
}

vec2s rectangle_place(const struct seen_rectangle *seen, vec2s sample) {
    double angle = (double)sample.x * seen->solid_angle + seen->first;
    double slope = (cos(angle) * seen->normal_y[0] - seen->normal_y[1]) / sin(angle);
    double cosine = clamp(copysign(1 / hypot(slope, seen->normal_y[0]), slope), -1, 1);
    double x =
        clamp(-cosine * seen->z / sqrt(fmax(1 - cosine * cosine, 1e-300)), seen->x[0], seen->x[1]);
    double aside = hypot(x, seen->z);
    double low = seen->y[0] / hypot(aside, seen->y[0]),
           high = seen->y[1] / hypot(aside, seen->y[1]);
    double sine = low + (double)sample.y * (high - low);
    double y = clamp(sine * aside / sqrt(fmax(1 - sine * sine, 1e-300)), seen->y[0], seen->y[1]);
    return (vec2s){{(float)((x - seen->x[0]) / (seen->x[1] - seen->x[0])),
                    (float)((y - seen->y[0]) / (seen->y[1] - seen->y[0]))}};
}
