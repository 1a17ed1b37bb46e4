#include "passes/smooth_surfaces.h"

#include "base/memory.h"
#include "base/unit.h"
#include "scene/material.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- triangles and materials ------------------------------------------------------------------ */

static bool init_materials(struct smooth_surfaces *surfaces) {
    const struct scene *scene = surfaces->scene;
    size_t count = (size_t)scene->material_count * SMOOTH_TEXELS;
    float(*texels)[4] = mem_alloc(count, sizeof *texels);
    for (int i = 0; i < scene->material_count; i++) {
        const struct material *material = &scene->materials[i];
        float(*row)[4] = texels + i * SMOOTH_TEXELS;
        memcpy(row[0], material->base_color, 3 * sizeof(float));
        row[0][3] = (float)material_smooth_kind(material);
        memcpy(row[1], material->absorption, 3 * sizeof(float));
        row[1][3] = material->index_of_refraction;
        row[2][0] = material->transmission * (1 - material->metalness);
        row[2][1] = material->thin_walled;
        row[2][2] = material->double_sided;
    }
    bool ok = buffer_init_texels(&surfaces->materials, GL_RGBA32F, "smooth materials",
                                 count * sizeof *texels, texels);
    free(texels);
    return ok;
}

/* Marks each vertex once. */
static void add_vertices(struct smooth_surfaces *surfaces, const struct geometry *geometry,
                         const struct geometry_batch *batch, bool *marked) {
    for (uint32_t i = 0; i < batch->index_count; i++) {
        uint32_t vertex = geometry->indices[batch->first_index + i];
        if (!marked[vertex])
            surfaces->vertices[surfaces->vertex_count++] = vertex;
        marked[vertex] = true;
    }
}

static bool init_rows(struct smooth_surfaces *surfaces, const struct geometry *geometry) {
    size_t count = geometry->index_count / 3;
    uint32_t *rows = mem_alloc(count, sizeof *rows);
    bool *marked = mem_alloc(geometry->vertex_count, sizeof *marked);
    surfaces->vertices = mem_alloc(geometry->vertex_count, sizeof *surfaces->vertices);
    surfaces->vertex_count = 0;
    surfaces->has_glass = false;
    for (int b = 0; b < geometry->batch_count; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        enum smooth_kind kind = material_smooth_kind(&surfaces->scene->materials[batch->material]);
        if (kind == SMOOTH_NONE)
            continue;
        surfaces->has_glass |= kind == SMOOTH_GLASS;
        for (uint32_t i = 0; i < batch->index_count / 3; i++)
            rows[batch->first_index / 3 + i] = (uint32_t)batch->material + 1;
        add_vertices(surfaces, geometry, batch, marked);
    }
    bool ok = buffer_init_texels(&surfaces->rows, GL_R32UI, "rows of triangles",
                                 count * sizeof *rows, rows) &&
              buffer_init_texels(&surfaces->corners, GL_R32UI, "corners of triangles",
                                 3 * count * sizeof *geometry->indices, geometry->indices);
    mem_free(rows, marked);
    surfaces->painted = geometry->painted;
    return ok;
}

bool smooth_surfaces_init(struct smooth_surfaces *surfaces, const struct scene *scene,
                          const struct geometry *geometry) {
    _Static_assert(SMOOTH_GLASS == SMOOTH_IS_GLASS && SMOOTH_MIRROR == SMOOTH_IS_MIRROR, "kinds");
    *surfaces = (struct smooth_surfaces){.scene = scene};
    if (init_materials(surfaces) && init_rows(surfaces, geometry))
        return true;
    smooth_surfaces_free(surfaces);
    return false;
}

static void free_rows(struct smooth_surfaces *surfaces) {
    buffers_free(&surfaces->rows, &surfaces->corners);
    free(surfaces->vertices);
    surfaces->vertices = NULL;
    surfaces->vertex_count = 0;
}

void smooth_surfaces_free(struct smooth_surfaces *surfaces) {
    free_rows(surfaces);
    buffer_free(&surfaces->materials);
    *surfaces = (struct smooth_surfaces){0};
}

/* Where there is no memory for metaballs that have grown, none is smooth. */
void smooth_surfaces_follow(struct smooth_surfaces *surfaces, const struct scene_gpu *gpu,
                            const struct geometry *geometry) {
    if (surfaces->painted != geometry->painted) {
        free_rows(surfaces);
        buffer_free(&surfaces->materials);
        if (!init_materials(surfaces) || !init_rows(surfaces, geometry))
            free_rows(surfaces);
    }
    for (int b = 0; b < geometry->batch_count && surfaces->vertex_count > 0; b++) {
        const struct geometry_batch *batch = &geometry->batches[b];
        if (batch->dynamic)
            buffer_write(&surfaces->corners, batch->first_index * sizeof *geometry->indices,
                         batch->index_count * sizeof *geometry->indices,
                         geometry->indices + batch->first_index);
    }
    surfaces->gpu = gpu;
}

void smooth_surfaces_add(const struct smooth_surfaces *surfaces, struct pass_state *state) {
    pass_add_texture(state, UNIT_TRIANGLE_ROWS, surfaces->rows.texels);
    pass_add_texture(state, UNIT_SMOOTH_MATERIALS, surfaces->materials.texels);
    pass_add_texture(state, UNIT_CORNERS, surfaces->corners.texels);
    pass_add_texture(state, UNIT_CORNER_POSITIONS, surfaces->gpu->positions.texels);
    pass_add_texture(state, UNIT_CORNER_NORMALS, surfaces->gpu->normals.texels);
}

/* --- a light's view --------------------------------------------------------------------------- */

/* Texels around the surfaces that rays miss them in. */
static const double margin = 1.5;

static void find_box(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                     vec3 box[2]) {
    glm_aabb_invalidate(box);
    for (uint32_t i = 0; i < surfaces->vertex_count; i++) {
        float *position = geometry->position[surfaces->vertices[i]];
        glm_vec3_minv(box[0], position, box[0]);
        glm_vec3_maxv(box[1], position, box[1]);
    }
}

void smooth_surfaces_middle(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                            float middle[3]) {
    vec3 box[2];
    find_box(surfaces, geometry, box);
    glm_vec3_center(box[0], box[1], middle);
}

static double angle_between(vec3 a, vec3 b) {
    vec3 across;
    glm_vec3_cross(a, b, across);
    return atan2((double)glm_vec3_norm(across), (double)glm_vec3_dot(a, b));
}

static void set_frame(struct caustics_params *params, vec3 axis) {
    glm_vec3_copy(axis, params->axis);
    glm_vec3_ortho(axis, params->right);
    vec3_unit(params->right);
    glm_vec3_cross(params->right, axis, params->up);
}

static void fit_disk(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                     const struct emitter *light, vec3 middle, struct caustics_params *params) {
    double radius = 0;
    set_frame(params, (float *)light->direction);
    for (uint32_t i = 0; i < surfaces->vertex_count; i++) {
        vec3 from, across;
        glm_vec3_sub(geometry->position[surfaces->vertices[i]], middle, from);
        glm_vec3_cross(from, params->axis, across);
        radius = fmax(radius, (double)glm_vec3_norm(across));
    }
    radius *= 1 + 2 * margin / params->side;
    params->is_disk = true;
    params->spread = (float)radius;
    params->measure = (float)(4 * radius * radius / params->side / params->side);
    glm_vec3_copy(middle, params->start);
    glm_vec3_muladds(params->axis, -4 * geometry->radius, params->start);
}

/* Half the angle of the cap around the axis that has all smooth surfaces. */
static double widest_angle(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                           const struct emitter *light, vec3 axis) {
    double widest = 0;
    for (uint32_t i = 0; i < surfaces->vertex_count; i++) {
        vec3 from;
        glm_vec3_sub(geometry->position[surfaces->vertices[i]], (float *)light->position, from);
        widest = fmax(widest, angle_between(axis, from));
    }
    return widest;
}

static bool fit_cap(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                    const struct emitter *light, vec3 box[2], vec3 middle,
                    struct caustics_params *params) {
    vec3 axis;
    glm_vec3_sub(middle, (float *)light->position, axis);
    bool is_inside = glm_aabb_point(box, (float *)light->position);
    double angle = GLM_PI, cone = light->type == EMITTER_SPOT   ? acos((double)light->cos_outer)
                                  : light->type == EMITTER_AREA ? GLM_PI_2
                                                                : GLM_PI;
    if (!is_inside) {
        vec3_unit(axis);
        angle = widest_angle(surfaces, geometry, light, axis);
        /* A wider cap is not convex: triangles reach out of it whose corners do not. */
        angle = angle > GLM_PI_2 ? GLM_PI : angle * (1 + 2 * margin / params->side);
        if (angle_between(axis, (float *)light->direction) > angle + cone && cone < GLM_PI)
            return false;
    }
    if (cone < angle || is_inside) {
        angle = fmin(cone, angle);
        glm_vec3_copy((float *)light->direction, axis);
    }
    double spread = 2 * pow(sin(angle / 2), 2);
    set_frame(params, axis);
    params->spread = (float)spread;
    params->measure = (float)(8 * spread / params->side / params->side);
    return true;
}

bool smooth_surfaces_fit(const struct smooth_surfaces *surfaces, const struct geometry *geometry,
                         const struct emitter *light, int side, struct caustics_params *params) {
    vec3 box[2], middle;
    params->side = side;
    if (surfaces->vertex_count == 0)
        return false;
    find_box(surfaces, geometry, box);
    glm_vec3_center(box[0], box[1], middle);
    if (light->type != EMITTER_DIRECTIONAL)
        return fit_cap(surfaces, geometry, light, box, middle, params);
    fit_disk(surfaces, geometry, light, middle, params);
    return true;
}
