#include "lab/export/target.h"

#include "apps/interrupt.h"
#include "lab/export/lights.h"
#include "lab/export/meshes.h"
#include "lab/export/textures.h"

#include <cglm/cglm.h>
#include <stdio.h>
#include <stdlib.h>

static void print_numbers(struct text *xml, const char *before, const float *numbers, int count,
                          const char *after) {
    text_print(xml, "%s", before);
    for (int i = 0; i < count; i++)
        text_print(xml, "%s%.9g", i ? " " : "", (double)numbers[i] + 0.0); /* no "-0" */
    text_print(xml, "%s", after);
}

static void print_rgb(struct text *xml, const char *name, const float rgb[3]) {
    text_print(xml, "<rgb name=\"%s\" value=\"", name);
    print_numbers(xml, "", rgb, 3, "\"/>\n");
}

static void print_target(struct text *xml, const char *element, const float origin[3],
                         const float forward[3], const float up[3]) {
    float target[3];
    glm_vec3_add((float *)origin, (float *)forward, target);
    text_print(xml, "<transform name=\"to_world\"><%s", element);
    print_numbers(xml, " origin=\"", origin, 3, "\"");
    print_numbers(xml, " target=\"", target, 3, "\"");
    print_numbers(xml, " up=\"", up, 3, "\"/></transform>\n");
}

/* --- camera ----------------------------------------------------------------------------------- */

static void print_film(struct text *xml, const struct export_target *target) {
    text_print(xml,
               "<film type=\"hdrfilm\">\n<integer name=\"width\" value=\"%d\"/>\n"
               "<integer name=\"height\" value=\"%d\"/>\n"
               "<string name=\"pixel_format\" value=\"rgb\"/>\n"
               "<string name=\"component_format\" value=\"float32\"/>\n"
               "<rfilter type=\"box\"/>\n</film>\n"
               "<sampler type=\"independent\"><integer name=\"sample_count\" value=\"%d\"/>"
               "</sampler>\n",
               target->width, target->height, target->samples);
}

static void print_camera(struct text *xml, const struct export_target *target) {
    const struct stage *stage = target->stage;
    const struct camera *camera = &stage->camera;
    float radius = stage->geometry.radius;
    float far =
        4 * radius + glm_vec3_distance((float *)camera->eye, (float *)stage->geometry.center);
    text_print(xml, "<sensor type=\"%s\">\n",
               camera->orthographic ? "orthographic" : "perspective");
    if (!camera->orthographic)
        text_print(
            xml, "<string name=\"fov_axis\" value=\"y\"/>\n<float name=\"fov\" value=\"%.9g\"/>\n",
            (double)glm_deg(camera->fov_y));
    text_print(
        xml,
        "<float name=\"near_clip\" value=\"%.9g\"/>\n<float name=\"far_clip\" value=\"%.9g\"/>\n",
        (double)(camera->near > 0 ? camera->near : 1e-4F * radius),
        (double)(camera->far > 0 ? camera->far : far));
    if (camera->orthographic) {
        float aspect = (float)target->width / (float)target->height;
        float half = camera->y_extent * aspect; /* of the width */
        float matrix[16] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
        for (int row = 0; row < 3; row++) {
            matrix[4 * row] = -camera->right[row] * half;
            matrix[4 * row + 1] = camera->up[row] * half;
            matrix[4 * row + 2] = camera->forward[row];
            matrix[4 * row + 3] = camera->eye[row];
        }
        print_numbers(xml, "<transform name=\"to_world\"><matrix value=\"", matrix, 16,
                      "\"/></transform>\n");
    } else
        print_target(xml, "lookat", camera->eye, camera->forward, camera->up);
    print_film(xml, target);
    text_print(xml, "</sensor>\n");
}

/* --- materials -------------------------------------------------------------------------------- */

static void print_texture(struct export_target *target, struct text *xml, int n, int texture,
                          const char *name, const char *file, bool is_data) {
    static const char *const wraps[] = {"repeat", "clamp", "mirror"};
    bool is_nearest = target->stage->scene.textures[texture].nearest || is_data;
    text_print(xml,
               "<texture type=\"bitmap\" name=\"%s\">\n<string name=\"filename\" value=\"%s\"/>\n"
               "<string name=\"wrap_mode\" value=\"%s\"/>\n"
               "<string name=\"filter_type\" value=\"%s\"/>\n"
               "<boolean name=\"raw\" value=\"%s\"/>\n</texture>\n",
               name, file, wraps[export_wrap(target, n, texture)],
               is_nearest ? "nearest" : "bilinear", is_data ? "true" : "false");
}

static bool print_color(struct export_target *target, struct text *xml, int n, const char *name) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct scene *scene = &target->stage->scene;
    const struct material *material = &scene->materials[mesh->material];
    vec3s factor = glms_vec3_mul(
        export_vertex_color(target, mesh),
        (vec3s){{material->base_color[0], material->base_color[1], material->base_color[2]}});
    char file[64];
    if (material->base_color_texture < 0) {
        print_rgb(xml, name, factor.raw);
        return true;
    }
    snprintf(file, sizeof file, "color-%d.exr", n);
    print_texture(target, xml, n, material->base_color_texture, name, file, false);
    return export_color_texture(target, material->base_color_texture, factor, file);
}

static bool print_reflection(struct export_target *target, struct text *xml, int n) {
    const struct material *material = &target->stage->scene.materials[target->meshes[n].material];
    if (export_is_diffuse(target, material)) {
        text_print(xml, "<bsdf type=\"diffuse\">\n");
        bool ok = print_color(target, xml, n, "reflectance");
        text_print(xml, "</bsdf>\n");
        return ok;
    }
    export_note(target, "material %d (%s): Mitsuba's principled BSDF in place of glTF's",
                target->meshes[n].material, material->name);
    text_print(xml, "<bsdf type=\"principled\">\n");
    bool ok = print_color(target, xml, n, "base_color");
    text_print(xml,
               "<float name=\"metallic\" value=\"%.9g\"/>\n"
               "<float name=\"roughness\" value=\"%.9g\"/>\n"
               "<float name=\"specular\" value=\"%.9g\"/>\n</bsdf>\n",
               (double)material->metalness, (double)material->roughness,
               (double)fminf(material->specular_f0[1] / .08F, 1));
    return ok;
}

static bool print_bsdf(struct export_target *target, struct text *xml, int n) {
    const struct scene *scene = &target->stage->scene;
    const struct material *material = &scene->materials[target->meshes[n].material];
    bool masked = material->alpha_mask && material->base_color_texture >= 0, ok = true;
    char file[64];
    if (masked) {
        snprintf(file, sizeof file, "mask-%d.png", n);
        text_print(xml, "<bsdf type=\"mask\">\n");
        print_texture(target, xml, n, material->base_color_texture, "opacity", file, true);
        ok = export_mask(target, material, file);
        export_note(target, "material %d (%s): its alpha mask is not interpolated",
                    target->meshes[n].material, material->name);
    }
    text_print(xml, material->double_sided ? "<bsdf type=\"twosided\">\n" : "");
    if (!material->double_sided)
        export_note(target, "the camera sees the backs of single-sided materials, black");
    ok = ok && print_reflection(target, xml, n);
    text_print(xml, "%s%s", material->double_sided ? "</bsdf>\n" : "", masked ? "</bsdf>\n" : "");
    return ok;
}

/* --- meshes ----------------------------------------------------------------------------------- */

static bool print_emission(struct export_target *target, struct text *xml, int n) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct scene *scene = &target->stage->scene;
    const struct material *material = &scene->materials[mesh->material];
    bool textured = material->emission_texture >= 0 &&
                    material->emission_mapping == export_mapping(target, mesh),
         ok = true;
    vec3s emission = export_emission(target, mesh);
    char file[64];
    snprintf(file, sizeof file, "emission-%d.exr", n);
    text_print(xml, "<emitter type=\"area\">\n");
    if (textured) {
        vec3s factor = {{material->emission[0], material->emission[1], material->emission[2]}};
        print_texture(target, xml, n, material->emission_texture, "radiance", file, false);
        ok = export_color_texture(target, material->emission_texture, factor, file);
    } else
        print_rgb(xml, "radiance", emission.raw);
    text_print(xml, "</emitter>\n");
    if (material->emission_texture >= 0 && !textured)
        export_note(target, "material %d (%s): the mean of its emission's texture", mesh->material,
                    material->name);
    return ok;
}

static bool print_shape(struct export_target *target, struct text *xml, int n, bool back) {
    text_print(xml, "<shape type=\"ply\">\n<string name=\"filename\" value=\"mesh-%d%s.ply\"/>\n",
               n, back ? "-back" : "");
    bool ok = print_bsdf(target, xml, n) &&
              (!target->meshes[n].shines || print_emission(target, xml, n)) &&
              export_ply(target, n, back);
    text_print(xml, "</shape>\n");
    return ok;
}

static bool print_mesh(struct export_target *target, struct text *xml, int n) {
    const struct export_mesh *mesh = &target->meshes[n];
    const struct material *material = &target->stage->scene.materials[mesh->material];
    export_note_mesh(target, mesh);
    if (!print_shape(target, xml, n, false))
        return false;
    if (!mesh->shines || !material->double_sided)
        return true;
    export_note(target, "material %d (%s): its back shines as a second mesh, a little behind",
                mesh->material, material->name);
    return print_shape(target, xml, n, true);
}

/* --- lights ----------------------------------------------------------------------------------- */

static const char black[] =
    "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0 0 0\"/></bsdf>\n";

static void print_light_shape(struct text *xml, const struct emitter *emitter) {
    float radiance[3], matrix[16];
    export_radiance(emitter, radiance);
    enum emitter_shape shape = emitter_shape(emitter);
    if (shape == EMITTER_IS_SPHERE) {
        text_print(xml, "<shape type=\"sphere\">\n<float name=\"radius\" value=\"%.9g\"/>\n",
                   (double)emitter->size[0] / 2);
        print_numbers(xml, "<transform name=\"to_world\"><translate value=\"", emitter->position, 3,
                      "\"/></transform>\n");
    } else {
        export_place(emitter, matrix);
        text_print(xml, "<shape type=\"%s\">\n", shape == EMITTER_IS_DISK ? "disk" : "rectangle");
        print_numbers(xml, "<transform name=\"to_world\"><matrix value=\"", matrix, 16,
                      "\"/></transform>\n");
    }
    text_print(xml, "%s<emitter type=\"area\">", black);
    print_rgb(xml, "radiance", radiance);
    text_print(xml, "</emitter>\n</shape>\n");
}

static void print_spot(struct text *xml, const struct emitter *emitter) {
    struct spot_cone cone = export_cone(emitter);
    text_print(xml, "<emitter type=\"spot\">\n");
    print_target(xml, "lookat", emitter->position, emitter->direction, emitter->up);
    print_rgb(xml, "intensity", emitter->intensity);
    text_print(xml,
               "<float name=\"beam_width\" value=\"%.9g\"/>\n"
               "<float name=\"cutoff_angle\" value=\"%.9g\"/>\n</emitter>\n",
               cone.full, cone.end);
}

static void print_light(struct export_target *target, struct text *xml,
                        const struct emitter *emitter) {
    export_note_light(target, emitter);
    if (export_is_shape(emitter))
        print_light_shape(xml, emitter);
    else if (emitter->type == EMITTER_SPOT)
        print_spot(xml, emitter);
    else if (emitter->type == EMITTER_POINT) {
        print_numbers(xml, "<emitter type=\"point\">\n<point name=\"position\" value=\"",
                      emitter->position, 3, "\"/>\n");
        print_rgb(xml, "intensity", emitter->intensity);
        text_print(xml, "</emitter>\n");
    } else {
        print_numbers(xml, "<emitter type=\"directional\">\n<vector name=\"direction\" value=\"",
                      emitter->direction, 3, "\"/>\n");
        print_rgb(xml, "irradiance", emitter->intensity);
        text_print(xml, "</emitter>\n");
    }
}

/* Mitsuba's panorama begins at -Z and goes to +X: a quarter turn before ours. */
static bool print_environment(struct export_target *target, struct text *xml) {
    const struct environment *sky = target->stage->emitters.sky;
    export_note(target, "environment: texels are interpolated, each as %d x %d of them",
                export_panorama_repeats(sky), export_panorama_repeats(sky));
    text_print(xml,
               "<emitter type=\"envmap\">\n"
               "<string name=\"filename\" value=\"environment.exr\"/>\n"
               "<float name=\"scale\" value=\"%.9g\"/>\n"
               "<transform name=\"to_world\"><rotate y=\"1\" angle=\"%.9g\"/></transform>\n"
               "</emitter>\n",
               (double)sky->strength, 90 + (double)sky->turn);
    return export_repeated_panorama(target, "environment.exr");
}

static bool print_scene(struct export_target *target, struct text *xml) {
    const struct emitters *emitters = &target->stage->emitters;
    bool ok = true;
    text_print(xml,
               "<scene version=\"3.0.0\">\n<integrator type=\"path\">\n"
               "<integer name=\"max_depth\" value=\"%d\"/>\n"
               "<integer name=\"rr_depth\" value=\"1000\"/>\n</integrator>\n",
               target->bounces + 2);
    print_camera(xml, target);
    for (int i = 0; ok && i < target->mesh_count; i++)
        ok = print_mesh(target, xml, i) && !interrupt_came();
    for (int i = 0; i < emitters->count; i++)
        if (export_is_light(&emitters->items[i]))
            print_light(target, xml, &emitters->items[i]);
    ok = ok && (!emitters->sky || print_environment(target, xml));
    text_print(xml, "</scene>\n");
    return ok;
}

bool export_mitsuba(struct export_target *target) {
    struct text xml = {0};
    bool ok = print_scene(target, &xml) && export_write(target, "scene.xml", "<!-- ", " -->", &xml);
    free(xml.data);
    return ok;
}
