#include "shapes/shapes.h"

#include "base/memory.h"
#include "base/unit.h"

#include <math.h>
#include <stdlib.h>

void add_quad(struct surface *surface, const float a[3], const float b[3], const float c[3],
              const float d[3]) {
    /* The diagonals, so that a slightly warped quad gets its mean normal. */
    vec3 ac, bd, normal;
    glm_vec3_sub((float *)c, (float *)a, ac);
    glm_vec3_sub((float *)d, (float *)b, bd);
    vec3_unit_cross(ac, bd, normal);
    uint32_t first = surface_add_vertex(surface, a, normal);
    surface_add_vertex(surface, b, normal);
    surface_add_vertex(surface, c, normal);
    surface_add_vertex(surface, d, normal);
    surface_add_triangle(surface, first, first + 1, first + 2);
    surface_add_triangle(surface, first, first + 2, first + 3);
}

void add_block(struct surface *surface, const float top[4][3], float low) {
    float bottom[4][3];
    for (int i = 0; i < 4; i++) {
        glm_vec3_copy((float *)top[i], bottom[i]);
        bottom[i][1] = low;
    }
    add_quad(surface, top[0], top[1], top[2], top[3]);
    add_quad(surface, bottom[3], bottom[2], bottom[1], bottom[0]);
    for (int i = 0; i < 4; i++) {
        int next = (i + 1) % 4;
        add_quad(surface, bottom[i], bottom[next], top[next], top[i]);
    }
}

void add_box(struct surface *surface, const float low[3], const float high[3]) {
    const float top[4][3] = {{low[0], high[1], high[2]},
                             {high[0], high[1], high[2]},
                             {high[0], high[1], low[2]},
                             {low[0], high[1], low[2]}};
    add_block(surface, top, low[1]);
}

void add_copy(struct surface *surface, const struct surface *piece, int quarters,
              const float move[3]) {
    static const float cosines[4] = {1.0f, 0.0f, -1.0f, 0.0f};
    float c = cosines[quarters & 3], s = cosines[(quarters + 3) & 3];
    uint32_t first = surface->vertex_count;
    for (uint32_t i = 0; i < piece->vertex_count; i++) {
        const float *p = piece->position[i], *n = piece->normal[i];
        surface_add_vertex(surface,
                           (const float[]){c * p[0] + s * p[2] + move[0], p[1] + move[1],
                                           c * p[2] - s * p[0] + move[2]},
                           (const float[]){c * n[0] + s * n[2], n[1], c * n[2] - s * n[0]});
    }
    for (uint32_t i = 0; i < piece->index_count; i += 3)
        surface_add_triangle(surface, first + piece->indices[i], first + piece->indices[i + 1],
                             first + piece->indices[i + 2]);
}

/* --- curved shapes ---------------------------------------------------------------------------- */

/* A point of a cube's face, u and v in [-1, 1], pushed out to the sphere. The tangent evens out the
 * sizes of the squares. */
static void cube_to_sphere(int face, double u, double v, double point[3]) {
    int axis = face / 2;
    double side = face % 2 ? -1.0 : 1.0;
    double x = tan(u * GLM_PI_4), y = tan(v * GLM_PI_4), length = sqrt(x * x + y * y + 1.0);
    point[axis] = side / length;
    point[(axis + 1) % 3] = side * x / length;
    point[(axis + 2) % 3] = y / length;
}

void add_sphere_inside(struct surface *surface, int n) {
    for (int face = 0; face < 6; face++) {
        uint32_t first = surface->vertex_count;
        for (int j = 0; j <= n; j++)
            for (int i = 0; i <= n; i++) {
                double point[3];
                cube_to_sphere(face, 2.0 * i / n - 1.0, 2.0 * j / n - 1.0, point);
                float position[3], normal[3];
                for (int k = 0; k < 3; k++) {
                    position[k] = (float)point[k];
                    normal[k] = -position[k];
                }
                surface_add_vertex(surface, position, normal);
            }
        for (int j = 0; j < n; j++)
            for (int i = 0; i < n; i++) {
                uint32_t a = first + (uint32_t)(j * (n + 1) + i), b = a + 1;
                uint32_t d = a + (uint32_t)(n + 1), c = d + 1;
                surface_add_triangle(surface, a, c, b);
                surface_add_triangle(surface, a, d, c);
            }
    }
}

struct lathe {
    const struct lathe_point *profile;
    int count, segments, lobes;
};

/* Where a profile point comes to lie at a step round the circle, and the tangent along
 * the circle. */
static void lathe_place(const struct lathe *lathe, int point, int step, vec3 position,
                        vec3 tangent) {
    const struct lathe_point *at = &lathe->profile[point];
    /* The last step is the first again, to the bit. */
    double angle = 2.0 * GLM_PI * (step % lathe->segments) / lathe->segments;
    double radius = at->radius * (1.0 + at->lobe * cos(lathe->lobes * angle));
    double slope = -at->radius * at->lobe * lathe->lobes * sin(lathe->lobes * angle);
    double c = cos(angle), s = sin(angle);
    glm_vec3_copy((vec3){(float)(radius * c), at->y, (float)(radius * s)}, position);
    glm_vec3_copy((vec3){(float)(slope * c - radius * s), 0.0f, (float)(slope * s + radius * c)},
                  tangent);
}

/* The normal of the strip between a profile point and the next. */
static void lathe_normal(const struct lathe *lathe, int strip, int step, vec3 normal) {
    vec3 low, high, low_tangent, high_tangent, up;
    lathe_place(lathe, strip, step, low, low_tangent);
    lathe_place(lathe, strip + 1, step, high, high_tangent);
    glm_vec3_sub(high, low, up);
    glm_vec3_add(low_tangent, high_tangent, low_tangent);
    vec3_unit_cross(up, low_tangent, normal);
}

/* The vertex at the lower (0) or upper (1) end of a strip; its normal takes in the next strip where
 * the joint is smooth. */
static void add_lathe_vertex(struct surface *surface, const struct lathe *lathe, int strip, int end,
                             int step) {
    vec3 position, tangent, normal, other;
    int neighbour = end ? strip + 1 : strip - 1;
    lathe_place(lathe, strip + end, step, position, tangent);
    lathe_normal(lathe, strip, step, normal);
    if (neighbour >= 0 && neighbour < lathe->count - 1) {
        lathe_normal(lathe, neighbour, step, other);
        if (glm_vec3_dot(normal, other) > cosf(glm_rad(35.0f)))
            glm_vec3_add(normal, other, normal);
    }
    vec3_unit(normal);
    surface_add_vertex(surface, position, normal);
}

void add_lathe(struct surface *surface, const struct lathe_point *profile, int count, int segments,
               int lobes) {
    const struct lathe lathe = {profile, count, segments, lobes};
    for (int strip = 0; strip + 1 < count; strip++) {
        uint32_t first = surface->vertex_count;
        for (int step = 0; step <= segments; step++)
            for (int end = 0; end < 2; end++)
                add_lathe_vertex(surface, &lathe, strip, end, step);
        for (int step = 0; step < segments; step++) {
            uint32_t low = first + 2 * (uint32_t)step, high = low + 1;
            if (profile[strip + 1].radius > 0.0f)
                surface_add_triangle(surface, low, high, high + 2);
            if (profile[strip].radius > 0.0f)
                surface_add_triangle(surface, low, high + 2, low + 2);
        }
    }
}

void add_ball(struct surface *surface, const float center[3], float radius, int rings) {
    struct lathe_point *profile = mem_alloc((size_t)rings + 1, sizeof *profile);
    uint32_t first = surface->vertex_count;
    for (int i = 0; i <= rings; i++) {
        float angle = GLM_PIf * (float)i / (float)rings;
        profile[i] = (struct lathe_point){.radius = i % rings ? radius * sinf(angle) : 0,
                                          .y = -radius * cosf(angle)};
    }
    add_lathe(surface, profile, rings + 1, 2 * rings, 0);
    for (uint32_t i = first; i < surface->vertex_count; i++)
        glm_vec3_add(surface->position[i], (float *)center, surface->position[i]);
    free(profile);
}

void add_moulding(struct surface *surface, const float (*profile)[2], int count, float length) {
    const float left = -0.5f * length, right = 0.5f * length;
    for (int i = 0; i < count; i++) {
        const float *a = profile[i], *b = profile[(i + 1) % count];
        add_quad(surface, (const float[]){left, a[1], a[0]}, (const float[]){right, a[1], a[0]},
                 (const float[]){right, b[1], b[0]}, (const float[]){left, b[1], b[0]});
    }
    for (int side = -1; side <= 1; side += 2) {
        uint32_t first = surface->vertex_count;
        for (int i = 0; i < count; i++)
            surface_add_vertex(
                surface, (const float[]){side < 0 ? left : right, profile[i][1], profile[i][0]},
                (const float[]){(float)side, 0.0f, 0.0f});
        for (uint32_t i = 1; i + 1 < (uint32_t)count; i++)
            surface_add_triangle(surface, first, first + i + (side > 0), first + i + (side < 0));
    }
}

void add_sheet(struct surface *surface, const struct sheet *sheet) {
    uint32_t first = surface->vertex_count, row = (uint32_t)sheet->nu + 1;
    for (int j = 0; j <= sheet->nv; j++)
        for (int i = 0; i <= sheet->nu; i++) {
            float point[3];
            sheet->place(sheet->context, (float)i / (float)sheet->nu, (float)j / (float)sheet->nv,
                         point);
            surface_add_vertex(surface, point, (const float[]){0.0f, 0.0f, 0.0f});
        }
    for (uint32_t j = 0; j < (uint32_t)sheet->nv; j++)
        for (uint32_t i = 0; i < (uint32_t)sheet->nu; i++) {
            uint32_t a = first + j * row + i;
            surface_add_triangle(surface, a, a + row, a + row + 1);
            surface_add_triangle(surface, a, a + row + 1, a + 1);
        }
    smooth_normals(surface, first);
}

void smooth_normals(struct surface *surface, uint32_t first) {
    for (uint32_t i = first; i < surface->vertex_count; i++)
        glm_vec3_zero(surface->normal[i]);
    for (uint32_t i = 0; i < surface->index_count; i++) {
        const uint32_t *triangle = surface->indices + i - i % 3;
        uint32_t a = triangle[i % 3], b = triangle[(i + 1) % 3], c = triangle[(i + 2) % 3];
        if (a < first)
            continue;
        vec3 ab, ac, normal;
        glm_vec3_sub(surface->position[b], surface->position[a], ab);
        glm_vec3_sub(surface->position[c], surface->position[a], ac);
        vec3_unit_cross(ab, ac, normal);
        glm_vec3_muladds(normal, glm_vec3_angle(ab, ac), surface->normal[a]);
    }
    for (uint32_t i = first; i < surface->vertex_count; i++)
        vec3_unit(surface->normal[i]);
}
