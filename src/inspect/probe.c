#include "inspect/probe.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "inspect/lights.h"
#include "metrics/colour.h"
#include "passes/maps.h"
#include "shared/inspect.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

#include <math.h>
#include <string.h>

/* --- the surface --- */

static void copy_layer(const struct image *image, const float *pixel, const char *first,
                       float values[3]) {
    int channel = image_find_channel(image, first);
    memcpy(values, pixel + channel, 3 * sizeof *values);
}

/* The point that the pixel's centre sees at that distance along the axis. */
static void place_point(const struct renderer *renderer, int x, int y, float depth,
                        float point[3]) {
    const struct renderer_desc *desc = &renderer->desc;
    vec3 origin, direction;
    camera_ray(&desc->camera, ((float)x + .5F) / (float)desc->width,
               ((float)y + .5F) / (float)desc->height, (float)desc->width / (float)desc->height,
               origin, direction);
    glm_vec3_copy(origin, point);
    glm_vec3_muladds(direction, depth / glm_vec3_dot(direction, (float *)desc->camera.forward),
                     point);
}

static bool read_surface(struct pick *pick, struct renderer *renderer, float x, float y) {
    int width = renderer->desc.width, height = renderer->desc.height;
    int column = (int)glm_clamp(x * (float)width, 0, (float)width - 1);
    int row = (int)glm_clamp(y * (float)height, 0, (float)height - 1);
    struct image image;
    if (!renderer_read_pixel(renderer, column, row, &image))
        return false;
    const float *pixel = image.pixels;
    pick->present = pixel[image_find_channel(&image, "Z")] > 0;
    copy_layer(&image, pixel, "R", pick->radiance);
    copy_layer(&image, pixel, "direct.R", pick->direct);
    copy_layer(&image, pixel, "indirect.R", pick->indirect);
    copy_layer(&image, pixel, "albedo.R", pick->albedo);
    copy_layer(&image, pixel, "normal.X", pick->normal);
    place_point(renderer, column, row, pixel[image_find_channel(&image, "Z")], pick->position);
    image_free(&image);
    return true;
}

bool probe_point(struct renderer *renderer, float x, float y, float point[3]) {
    struct pick pick;
    if (!read_surface(&pick, renderer, x, y) || !pick.present)
        return false;
    memcpy(point, pick.position, sizeof pick.position);
    return true;
}

/* --- visibility of each VAL at the point --- */

void probe_free(struct probe *probe) {
    lookup_free(&probe->lookup);
    framebuffer_free(&probe->framebuffer);
    texture_free(&probe->lit);
    buffer_free(&probe->params);
    *probe = (struct probe){0};
}

/* A pixel for each VAL. */
static bool fit(struct probe *probe, const struct val_output *vals) {
    int count = vals->maps.views->count;
    if (probe->framebuffer && probe->lit.desc.width == count)
        return lookup_fit(&probe->lookup, "inspect/probe.frag", vals->visibility);
    probe_free(probe);
    return lookup_fit(&probe->lookup, "inspect/probe.frag", vals->visibility) &&
           framebuffer_init_target(
               &probe->lit, &probe->framebuffer,
               &(struct texture_desc){.label = "probe", .format = GL_R32F, .width = count}) &&
           buffer_init(&probe->params, "probe parameters", sizeof(struct probe_params), NULL);
}

static void read_visibility(const struct probe *probe, const struct pick *pick,
                            const struct val_output *vals, float *lit) {
    struct probe_params params = {.position = {0}};
    int count = probe->lit.desc.width;
    memcpy(params.position, pick->position, sizeof pick->position);
    memcpy(params.normal, pick->normal, sizeof pick->normal);
    buffer_write(&probe->params, 0, sizeof params, &params);
    struct pass_state state = {
        .name = "probe",
        .program = probe->lookup.program,
        .framebuffer = probe->framebuffer,
        .width = count,
        .height = 1,
        .blocks = {{BLOCK_PASS, &probe->params}},
    };
    visibility_add(&state, vals->visibility, &probe->lookup.params, &vals->maps);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    gl.GetTextureImage(probe->lit.id, 0, GL_RED, GL_FLOAT, count * (GLsizei)sizeof *lit, lit);
}

/* --- what each VAL brings --- */

/* Luminance of the irradiance from one VPL, without shadow: Phi / pi cos cos / d^2 with the form
 * factor of a disk of the VPL's area. */
static float irradiance_from(const struct vpl *vpl, const struct pick *pick) {
    vec3 to_vpl;
    glm_vec3_sub((float *)vpl->position, (float *)pick->position, to_vpl);
    float distance2 = glm_vec3_norm2(to_vpl);
    float cosines = fmaxf(glm_vec3_dot(to_vpl, (float *)pick->normal), 0) *
                    fmaxf(-glm_vec3_dot(to_vpl, (float *)vpl->normal), 0);
    if (cosines <= 0)
        return 0;
    return rgb_luminance(vpl->flux) * cosines /
           (GLM_PIf * distance2 * (distance2 + vpl->area / GLM_PIf));
}

static int brightest_first(const void *a, const void *b) {
    const struct pick_val *x = a, *y = b;
    return (x->share < y->share) - (x->share > y->share);
}

static void sum_vals(struct pick *pick, const struct lights *lights, const float *lit) {
    int count = lights->val_count;
    struct pick_val *vals = mem_alloc((size_t)count, sizeof *vals);
    float total = 0;
    for (int k = 0; k < count; k++)
        vals[k] = (struct pick_val){.val = k, .visibility = lit[k]};
    for (int i = 0; i < lights->vpl_count; i++) {
        const struct vpl *vpl = &lights->vpls[i];
        if (vpl->reach <= 0)
            continue;
        struct pick_val *val = &vals[(int)vpl->val];
        float brought = irradiance_from(vpl, pick) * val->visibility;
        val->vpl_count++;
        val->share += brought;
        total += brought;
    }
    qsort(vals, (size_t)count, sizeof *vals, brightest_first);
    for (int k = 0; k < count && k < PICK_VALS_MAX && vals[k].share > 0; k++) {
        pick->vals[k] = vals[k];
        pick->vals[k].share /= total;
        pick->val_count = k + 1;
    }
    free(vals);
}

bool probe_pick(struct probe *probe, struct renderer *renderer, float x, float y,
                struct pick *pick) {
    struct output_list outputs;
    struct lights lights;
    renderer_outputs(renderer, &outputs);
    const struct val_output *vals = output_vals(&outputs);
    *pick = (struct pick){0};
    if (!read_surface(pick, renderer, x, y))
        return false;
    if (!pick->present || !vals)
        return true;
    if (!fit(probe, vals) || !lights_read(&lights, renderer))
        return false;
    float *lit = mem_alloc((size_t)lights.val_count, sizeof *lit);
    read_visibility(probe, pick, vals, lit);
    sum_vals(pick, &lights, lit);
    free(lit);
    lights_free(&lights);
    return true;
}

int probe_nearest_val(struct renderer *renderer, float x, float y) {
    struct lights lights;
    int nearest = -1;
    float aspect = (float)renderer->desc.width / (float)renderer->desc.height, least = .05F;
    lights_read(&lights, renderer);
    for (int k = 0; k < lights.val_count; k++) {
        const float *center = lights.centers[k];
        float at[2];
        if (center[3] <= 0 || !camera_project(&renderer->desc.camera, center, aspect, at))
            continue;
        float away = hypotf((at[0] - x) * aspect, at[1] - y);
        if (away < least) {
            least = away;
            nearest = k;
        }
    }
    lights_free(&lights);
    return nearest;
}
