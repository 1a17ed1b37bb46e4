#include "lab/export/meshes.h"

#include "base/file/output_file.h"
#include "base/halton.h"
#include "base/memory.h"
#include "scene/lights/emissive.h"
#include "scene/mesh/corners.h"

#include <string.h>

/* Where a textured triangle is looked at for its mean. */
enum { PLACES = 16 };

/* --- which triangles -------------------------------------------------------------------------- */

static bool lamp_shines(const struct emitters *emitters, int lamp) {
    for (int i = 0; i < emitters->count; i++)
        if (emitters->items[i].lamp == lamp)
            return true;
    return false;
}

/* Marks the triangles of lamps that shine. */
static bool *find_shining(const struct stage *stage) {
    const struct geometry *geometry = &stage->geometry;
    bool *shines = mem_alloc(geometry->index_count / 3, sizeof *shines);
    for (int s = 0; s < stage->scene.surface_count; s++) {
        const struct emissive_surface *surface = &stage->scene.surfaces[s];
        struct emissive_span span = emissive_find(geometry, surface);
        if (lamp_shines(&stage->emitters, surface->lamp))
            memset(shines + span.first, true, span.end - span.first);
    }
    return shines;
}

static bool is_point(const uint32_t index[3]) {
    return index[0] == index[1] || index[1] == index[2] || index[2] == index[0];
}

static void add_mesh(struct export_target *target, const struct geometry_batch *batch,
                     const bool *are_shining, bool shines) {
    struct export_mesh mesh = {batch->material, shines, NULL, 0};
    uint32_t first = batch->first_index / 3, count = batch->index_count / 3;
    mesh.triangles = mem_alloc(count, sizeof *mesh.triangles);
    for (uint32_t i = first; i < first + count; i++)
        if (are_shining[i] == shines && !is_point(&target->stage->geometry.indices[3 * (size_t)i]))
            mesh.triangles[mesh.count++] = i;
    if (mesh.count > 0)
        target->meshes[target->mesh_count++] = mesh;
    else
        free(mesh.triangles);
}

void export_meshes_find(struct export_target *target) {
    const struct geometry *geometry = &target->stage->geometry;
    bool *shining = find_shining(target->stage);
    target->meshes = mem_alloc(2 * (size_t)geometry->batch_count, sizeof *target->meshes);
    for (int b = 0; b < geometry->batch_count; b++) {
        add_mesh(target, &geometry->batches[b], shining, false);
        add_mesh(target, &geometry->batches[b], shining, true);
    }
    free(shining);
}

void export_meshes_free(struct export_target *target) {
    for (int i = 0; i < target->mesh_count; i++)
        free(target->meshes[i].triangles);
    free(target->meshes);
    target->meshes = NULL;
    target->mesh_count = 0;
}

static const struct material *material_of(const struct export_target *target,
                                          const struct export_mesh *mesh) {
    return &target->stage->scene.materials[mesh->material];
}

int export_mapping(const struct export_target *target, const struct export_mesh *mesh) {
    const struct material *material = material_of(target, mesh);
    if (material->base_color_texture >= 0)
        return 0;
    return mesh->shines && material->emission_texture >= 0 ? material->emission_mapping : -1;
}

/* Whether the mesh's coordinates on that axis, 0 or 1, lie within one copy of the texture. */
static bool is_within_texture(const struct export_target *target, const struct export_mesh *mesh,
                              int axis) {
    const struct geometry *geometry = &target->stage->geometry;
    int mapping = export_mapping(target, mesh);
    for (uint32_t i = 0; i < 3 * mesh->count; i++) {
        uint32_t vertex = geometry->indices[3 * (size_t)mesh->triangles[i / 3] + i % 3];
        float at = geometry->uv[mapping][vertex][axis];
        if (!(at >= 0 && at <= 1))
            return false;
    }
    return true;
}

enum texture_wrap export_wrap(struct export_target *target, int n, int texture) {
    const struct scene_texture *from = &target->stage->scene.textures[texture];
    if (from->wrap_u == from->wrap_v || is_within_texture(target, &target->meshes[n], 1))
        return from->wrap_u;
    if (is_within_texture(target, &target->meshes[n], 0))
        return from->wrap_v;
    export_note(target, "texture %d: wraps down as it does across", texture);
    return from->wrap_u;
}

/* --- PLY -------------------------------------------------------------------------------------- */

struct ply {
    const struct export_target *target;
    const struct export_mesh *mesh;
    bool back;
    int mapping;
    uint32_t *number_of; /* in the file, + 1, of each of the geometry's vertices; 0 = none */
    struct text vertices, faces;
    uint32_t vertex_count;
};

static void put_vertex(struct ply *ply, uint32_t vertex) {
    const struct geometry *geometry = &ply->target->stage->geometry;
    float row[8], side = ply->back ? -1 : 1;
    float behind = ply->back ? geometry_clearance(geometry) : 0;
    int count = 6;
    for (int c = 0; c < 3; c++) {
        row[c] = geometry->position[vertex][c] - behind * geometry->normal[vertex][c];
        row[3 + c] = side * geometry->normal[vertex][c];
    }
    if (ply->mapping >= 0) {
        const float *uv = geometry->uv[ply->mapping][vertex];
        row[6] = uv[0];
        row[7] = uv[1];
        count = 8;
    }
    text_append(&ply->vertices, row, (size_t)count * sizeof *row);
    ply->number_of[vertex] = ++ply->vertex_count;
}

static void put_triangle(struct ply *ply, uint32_t triangle) {
    const uint32_t *index = &ply->target->stage->geometry.indices[3 * (size_t)triangle];
    const unsigned char corners = 3;
    text_append(&ply->faces, &corners, 1);
    for (int k = 0; k < 3; k++) {
        uint32_t vertex = index[ply->back ? 2 - k : k];
        if (!ply->number_of[vertex])
            put_vertex(ply, vertex);
        uint32_t number = ply->number_of[vertex] - 1;
        text_append(&ply->faces, &number, sizeof number);
    }
}

/* Bytes are this machine's, which is little-endian wherever the program runs. */
static void put_head(const struct ply *ply, struct text *file) {
    text_print(file,
               "ply\nformat binary_little_endian 1.0\nelement vertex %u\n"
               "property float x\nproperty float y\nproperty float z\n"
               "property float nx\nproperty float ny\nproperty float nz\n%s"
               "element face %u\nproperty list uchar int vertex_indices\nend_header\n",
               ply->vertex_count, ply->mapping >= 0 ? "property float u\nproperty float v\n" : "",
               ply->mesh->count);
}

bool export_ply(const struct export_target *target, int n, bool back) {
    struct ply ply = {.target = target, .mesh = &target->meshes[n], .back = back};
    struct text file = {0};
    char name[64];
    ply.mapping = export_mapping(target, ply.mesh);
    ply.number_of = mem_alloc(target->stage->geometry.vertex_count, sizeof *ply.number_of);
    for (uint32_t i = 0; i < ply.mesh->count; i++)
        put_triangle(&ply, ply.mesh->triangles[i]);
    put_head(&ply, &file);
    text_append(&file, ply.vertices.data, ply.vertices.length);
    text_append(&file, ply.faces.data, ply.faces.length);
    snprintf(name, sizeof name, back ? "mesh-%d-back.ply" : "mesh-%d.ply", n);
    char *path = export_path(target, name);
    bool ok = output_file_write(path, file.data, file.length);
    mem_free(path, file.data, ply.vertices.data, ply.faces.data, ply.number_of);
    return ok;
}

/* --- means ------------------------------------------------------------------------------------ */

/* What a mesh has at one place of a triangle. */
typedef vec3s (*color_at)(const struct export_target *target, const struct export_mesh *mesh,
                          const struct corners *corners);

static vec3s mean_over(const struct export_target *target, const struct export_mesh *mesh,
                       color_at at) {
    const struct geometry *geometry = &target->stage->geometry;
    double sum[3] = {0}, area = 0;
    for (uint32_t i = 0; i < mesh->count; i++) {
        const uint32_t *index = &geometry->indices[3 * (size_t)mesh->triangles[i]];
        struct corners corners = {{index[0], index[1], index[2]}, {0}};
        double weight = corners_area(geometry, index) / PLACES;
        for (uint32_t p = 0; p < PLACES; p++) {
            corners_spread(corners.weight, (p + .5) / PLACES, radical_inverse(2, p));
            vec3s color = at(target, mesh, &corners);
            for (int c = 0; c < 3; c++)
                sum[c] += weight * (double)color.raw[c];
            area += weight;
        }
    }
    area = area > 0 ? area : 1;
    return (vec3s){{(float)(sum[0] / area), (float)(sum[1] / area), (float)(sum[2] / area)}};
}

static vec3s vertex_color_at(const struct export_target *target, const struct export_mesh *mesh,
                             const struct corners *corners) {
    (void)mesh;
    vec3s sum = glms_vec3_zero();
    for (int k = 0; k < 3; k++) {
        const float *color = geometry_color(&target->stage->geometry, corners->index[k]);
        sum = glms_vec3_muladds((vec3s){{color[0], color[1], color[2]}}, corners->weight[k], sum);
    }
    return sum;
}

static vec3s emission_at(const struct export_target *target, const struct export_mesh *mesh,
                         const struct corners *corners) {
    const struct material *material = material_of(target, mesh);
    vec4s texel = corners_texel(
        corners, &target->stage->scene, &target->stage->geometry, target->srgb_to_linear,
        &(struct corners_texture){material->emission_texture, material->emission_mapping});
    return glms_vec3_mul(glms_vec3(texel), (vec3s){{material->emission[0], material->emission[1],
                                                    material->emission[2]}});
}

vec3s export_vertex_color(const struct export_target *target, const struct export_mesh *mesh) {
    return mean_over(target, mesh, vertex_color_at);
}

vec3s export_emission(const struct export_target *target, const struct export_mesh *mesh) {
    const struct material *material = material_of(target, mesh);
    if (material->emission_texture < 0)
        return (vec3s){{material->emission[0], material->emission[1], material->emission[2]}};
    return mean_over(target, mesh, emission_at);
}

/* --- notes ------------------------------------------------------------------------------------ */

static bool has_one_color(const struct export_target *target, const struct export_mesh *mesh) {
    const struct geometry *geometry = &target->stage->geometry;
    const float *first =
        geometry_color(geometry, geometry->indices[3 * (size_t)mesh->triangles[0]]);
    for (uint32_t i = 0; i < mesh->count; i++)
        for (int k = 0; k < 3; k++) {
            uint32_t vertex = geometry->indices[3 * (size_t)mesh->triangles[i] + (size_t)k];
            if (memcmp(geometry_color(geometry, vertex), first, 3 * sizeof *first) != 0)
                return false;
        }
    return true;
}

void export_note_mesh(struct export_target *target, const struct export_mesh *mesh) {
    const struct material *material = material_of(target, mesh);
    bool full = target->materials == MATERIALS_FULL;
    const struct {
        bool is_so;
        const char *text;
    } notes[] = {
        {!has_one_color(target, mesh), "the mean of its vertices' colours"},
        {full && material->normal_texture >= 0, "its normal map is left out"},
        {full && material->unlit, "unlit, is lit"},
        {!export_is_diffuse(target, material) && material->metal_roughness_texture >= 0,
         "its texture of metalness and roughness is left out"},
        {full && material->transmission > 0, "its transmission is left out"},
    };
    for (size_t i = 0; i < sizeof notes / sizeof *notes; i++)
        if (notes[i].is_so)
            export_note(target, "material %d (%s): %s", mesh->material, material->name,
                        notes[i].text);
}
