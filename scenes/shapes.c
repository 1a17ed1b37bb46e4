#include "shapes.h"

#include <cglm/cglm.h>
#include <math.h>

void add_quad(struct surface *surface, const float a[3], const float b[3], const float c[3],
              const float d[3]) {
    /* The diagonals, so that a slightly warped quad gets its mean normal. */
    vec3 ac, bd, normal;
    glm_vec3_sub((float *)c, (float *)a, ac);
    glm_vec3_sub((float *)d, (float *)b, bd);
    glm_vec3_crossn(ac, bd, normal);
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

void smooth_normals(struct surface *surface) {
    for (uint32_t i = 0; i < surface->vertex_count; i++)
        glm_vec3_zero(surface->normal[i]);
    for (uint32_t i = 0; i < surface->index_count; i++) {
        uint32_t first = i - i % 3, at = surface->indices[i];
        uint32_t b = surface->indices[first + (i + 1 - first) % 3],
                 c = surface->indices[first + (i + 2 - first) % 3];
        vec3 ab, ac, normal;
        glm_vec3_sub(surface->position[b], surface->position[at], ab);
        glm_vec3_sub(surface->position[c], surface->position[at], ac);
        glm_vec3_crossn(ab, ac, normal);
        glm_vec3_muladds(normal, glm_vec3_angle(ab, ac), surface->normal[at]);
    }
    for (uint32_t i = 0; i < surface->vertex_count; i++)
        glm_vec3_normalize(surface->normal[i]);
}
