#include "apps/export/pbrt.h"

#include "apps/export/lights.h"
#include "apps/export/meshes.h"
#include "apps/export/slides.h"
#include "apps/export/textures.h"
#include "apps/interrupt.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A side of the environment's square. */
enum { ENVIRONMENT_SIZE = 1024 };

static void print_numbers(struct text *out, const char *name, const float *numbers, int count) {
    text_print(out, "%s [", name);
    export_numbers(out, numbers, count);
    text_print(out, " ]\n");
}

/* --- camera ----------------------------------------------------------------------------------- */

/* pbrt's field of view is that of the shorter side. Its camera has x to the left of a right-handed world: Scale
 * turns the picture round. */
static void print_camera(struct text *out, const struct export_target *target) {
    const struct camera *camera = &target->stage->camera;
    float look[9], aspect = (float)target->width / (float)target->height;
    double half = tan((double)camera->fov_y / 2) * fmin(1, (double)aspect);
    glm_vec3_copy((float *)camera->eye, look);
    glm_vec3_add((float *)camera->eye, (float *)camera->forward, look + 3);
    glm_vec3_copy((float *)camera->up, look + 6);
    text_print(out, "Scale -1 1 1\nLookAt");
    export_numbers(out, look, 9);
    if (camera->orthographic) {
        float high = camera->y_extent, wide = high * aspect;
        text_print(out, "\nCamera \"orthographic\"\n");
        print_numbers(out, "  \"float screenwindow\"", (float[]){-wide, wide, -high, high}, 4);
    } else
        text_print(out, "\nCamera \"perspective\" \"float fov\" [ %.9g ]\n",
                   2 * atan(half) * 180 / GLM_PI);
}

static void print_head(struct text *out, const struct export_target *target) {
    print_camera(out, target);
    text_print(out,
               "Film \"rgb\" \"integer xresolution\" [ %d ] \"integer yresolution\" [ %d ]\n"
               "  \"string filename\" [ \"scene.exr\" ] \"bool savefp16\" [ false ]\n"
               "PixelFilter \"box\" \"float xradius\" [ 0.5 ] \"float yradius\" [ 0.5 ]\n"
               "Sampler \"independent\" \"integer pixelsamples\" [ %d ]\n"
               "Integrator \"path\" \"integer maxdepth\" [ %d ]\nWorldBegin\n",
               target->width, target->height, target->samples, target->bounces + 1);
}

/* --- materials -------------------------------------------------------------------------------- */

static void print_texture(struct export_target *target, struct text *out, int n, int texture,
                          const char *kind, const char *name, const char *file) {
    static const char *const wraps[] = {"repeat", "clamp", "repeat"};
    enum texture_wrap wrap = export_wrap(target, n, texture);
    bool is_nearest = target->stage->scene.textures[texture].nearest || kind[0] == 'f';
    if (wrap == TEXTURE_WRAP_MIRROR)
        export_note(target, "texture %d: is repeated, not mirrored", texture);
    text_print(out,
               "Texture \"%s-%d\" \"%s\" \"imagemap\" \"string filename\" [ \"%s\" ]\n"
               "  \"string wrap\" [ \"%s\" ] \"string filter\" [ \"%s\" ]\n",
               name, n, kind, file, wraps[wrap], is_nearest ? "point" : "bilinear");
}

/* The parameter of the material that is its colour. */
static bool print_color(struct export_target *target, struct text *out, int n, char *parameter,
                        size_t size) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct material *material = &target->stage->scene.materials[mesh->material];
    vec3s factor = glms_vec3_mul(
        export_vertex_color(target, mesh),
        (vec3s){{material->base_color[0], material->base_color[1], material->base_color[2]}});
    char file[64];
    if (material->base_color_texture < 0) {
        snprintf(parameter, size, "\"rgb reflectance\" [ %.9g %.9g %.9g ]", (double)factor.x,
                 (double)factor.y, (double)factor.z);
        return true;
    }
    snprintf(file, sizeof file, "color-%d.exr", n);
    snprintf(parameter, size, "\"texture reflectance\" [ \"color-%d\" ]", n);
    print_texture(target, out, n, material->base_color_texture, "spectrum", "color", file);
    return export_color_texture(target, material->base_color_texture, factor, file);
}

static bool print_material(struct export_target *target, struct text *out, int n) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct material *material = &target->stage->scene.materials[mesh->material];
    char color[256];
    if (!print_color(target, out, n, color, sizeof color))
        return false;
    if (export_is_diffuse(target, material)) {
        text_print(out, "Material \"diffuse\" %s\n", color);
        if (!material->double_sided)
            export_note(target,
                        "backs of single-sided materials reflect, and the camera sees them");
        return true;
    }
    bool metal = material->metalness >= .5F;
    export_note(target, "material %d (%s): pbrt's %s in place of glTF's BRDF", mesh->material,
                material->name, metal ? "conductor" : "coateddiffuse");
    text_print(
        out, "Material \"%s\" %s \"float roughness\" [ %.9g ] \"bool remaproughness\" [ false ]\n",
        metal ? "conductor" : "coateddiffuse", color,
        (double)(material->roughness * material->roughness));
    return true;
}

/* --- meshes ----------------------------------------------------------------------------------- */

static void print_emission(struct export_target *target, struct text *out,
                           const struct export_mesh *mesh) {
    const struct material *material = &target->stage->scene.materials[mesh->material];
    vec3s emission = export_emission(target, mesh);
    if (material->emission_texture >= 0)
        export_note(target, "material %d (%s): the mean of its emission's texture", mesh->material,
                    material->name);
    text_print(out, "AreaLightSource \"diffuse\" \"bool twosided\" [ %s ]\n",
               material->double_sided ? "true" : "false");
    print_numbers(out, "  \"rgb L\"", emission.raw, 3);
}

static bool print_mask(struct export_target *target, struct text *out, int n) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct material *material = &target->stage->scene.materials[mesh->material];
    char file[64];
    snprintf(file, sizeof file, "mask-%d.png", n);
    print_texture(target, out, n, material->base_color_texture, "float", "mask", file);
    export_note(target, "material %d (%s): its alpha mask is not interpolated", mesh->material,
                material->name);
    return export_mask(target, material, file);
}

static bool print_mesh(struct export_target *target, struct text *out, int n) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct material *material = &target->stage->scene.materials[mesh->material];
    bool masked = material->alpha_mask && material->base_color_texture >= 0;
    export_note_mesh(target, mesh);
    text_print(out, "AttributeBegin\n");
    bool ok = print_material(target, out, n) && (!masked || print_mask(target, out, n));
    if (mesh->shines)
        print_emission(target, out, mesh);
    text_print(out, "Shape \"plymesh\" \"string filename\" [ \"mesh-%d.ply\" ]", n);
    if (masked)
        text_print(out, " \"texture alpha\" [ \"mask-%d\" ]", n);
    text_print(out, "\nAttributeEnd\n");
    return ok && export_ply(target, n, &(struct ply_desc){.flips_v = true});
}

/* --- lights ----------------------------------------------------------------------------------- */

/* The columns of a matrix of rows. */
static void print_transform(struct text *out, const float matrix[16]) {
    float columns[16];
    for (int i = 0; i < 16; i++)
        columns[i] = matrix[i % 4 * 4 + i / 4];
    print_numbers(out, "ConcatTransform", columns, 16);
}

static void print_rectangle(struct text *out, const float matrix[16]) {
    static const float corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    float points[12];
    for (int i = 0; i < 4; i++)
        for (int row = 0; row < 3; row++)
            points[3 * i + row] = matrix[4 * row] * corners[i][0] +
                                  matrix[4 * row + 1] * corners[i][1] + matrix[4 * row + 3];
    print_numbers(out, "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ]\n  \"point3 P\"",
                  points, 12);
}

static void print_light_shape(struct text *out, const struct emitter *emitter) {
    float radiance[3], matrix[16];
    enum emitter_shape shape = emitter_shape(emitter);
    export_radiance(emitter, radiance);
    export_place(emitter, matrix);
    text_print(out, "AttributeBegin\nMaterial \"diffuse\" \"rgb reflectance\" [ 0 0 0 ]\n"
                    "AreaLightSource \"diffuse\"\n");
    print_numbers(out, "  \"rgb L\"", radiance, 3);
    if (shape == EMITTER_IS_RECTANGLE)
        print_rectangle(out, matrix);
    else if (shape == EMITTER_IS_DISK) {
        print_transform(out, matrix);
        text_print(out, "Shape \"disk\" \"float radius\" [ 1 ]\n");
    } else {
        text_print(out, "Translate");
        export_numbers(out, emitter->position, 3);
        text_print(out, "\nShape \"sphere\" \"float radius\" [ %.9g ]\n",
                   (double)emitter->size[0] / 2);
    }
    text_print(out, "AttributeEnd\n");
}

static void print_from_to(struct text *out, const float from[3], const float direction[3]) {
    float to[3];
    glm_vec3_add((float *)from, (float *)direction, to);
    print_numbers(out, "  \"point3 from\"", from, 3);
    print_numbers(out, "  \"point3 to\"", to, 3);
}

/* pbrt-v4's picture is right along +x, its top is +y and the light looks along +z. */
static bool print_projector(struct export_target *target, struct text *out,
                            const struct emitter *emitter) {
    float matrix[16] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    for (int row = 0; row < 3; row++) {
        matrix[4 * row] = emitter->right[row];
        matrix[4 * row + 1] = emitter->up[row];
        matrix[4 * row + 2] = emitter->direction[row];
        matrix[4 * row + 3] = emitter->position[row];
    }
    char *file = export_projector_name(emitter);
    text_print(out, "AttributeBegin\n");
    print_transform(out, matrix);
    text_print(out,
               "LightSource \"projection\" \"float fov\" [ %.9g ] \"float scale\" [ %.9g ]\n"
               "  \"string filename\" [ \"%s\" ]\nAttributeEnd\n",
               export_projector_angle(emitter), (double)export_projector_peak(emitter), file);
    free(file);
    return export_projector_picture(target, emitter, 0);
}

static bool print_light(struct export_target *target, struct text *out,
                        const struct emitter *emitter) {
    export_note_light(target, emitter);
    if (export_is_projector(emitter))
        return print_projector(target, out, emitter);
    if (export_is_shape(emitter))
        print_light_shape(out, emitter);
    else if (emitter->type == EMITTER_SPOT) {
        struct spot_cone cone = export_cone(emitter, SPOT_SMOOTHSTEP);
        text_print(
            out,
            "LightSource \"spot\" \"float coneangle\" [ %.9g ] \"float conedeltaangle\" [ %.9g ]\n",
            cone.end, cone.end - cone.full);
        print_numbers(out, "  \"rgb I\"", emitter->intensity, 3);
        print_from_to(out, emitter->position, emitter->direction);
    } else if (emitter->type == EMITTER_POINT) {
        text_print(out, "LightSource \"point\"\n");
        print_numbers(out, "  \"rgb I\"", emitter->intensity, 3);
        print_numbers(out, "  \"point3 from\"", emitter->position, 3);
    } else {
        text_print(out, "LightSource \"distant\"\n");
        print_numbers(out, "  \"rgb L\"", emitter->intensity, 3);
        print_from_to(out, (float[]){0, 0, 0}, emitter->direction);
    }
    return true;
}

static bool print_scene(struct export_target *target, struct text *out) {
    const struct emitters *emitters = &target->stage->emitters;
    bool ok = true;
    print_head(out, target);
    export_note(target, "pbrt computes with spectra: colours of several reflections differ");
    for (int i = 0; ok && i < target->mesh_count; i++)
        ok = print_mesh(target, out, i) && !interrupt_came();
    for (int i = 0; ok && i < emitters->count; i++)
        if (export_is_light(&emitters->items[i]))
            ok = print_light(target, out, &emitters->items[i]);
    if (!ok || !emitters->sky)
        return ok;
    text_print(out, "LightSource \"infinite\" \"string filename\" [ \"environment.exr\" ]\n");
    export_note(target, "environment: resampled to %d x %d texels", ENVIRONMENT_SIZE,
                ENVIRONMENT_SIZE);
    return export_equal_area(target, "environment.exr", ENVIRONMENT_SIZE);
}

bool export_pbrt(struct export_target *target) {
    struct text out = {0};
    bool ok = print_scene(target, &out) && export_write(target, "scene.pbrt", "# ", "", &out);
    free(out.data);
    return ok;
}
