/* Light of further bounces: exact answers inside a sphere, energy, and the path tracer's picture; and points of
 * surfaces. */
#include "render_support.h"

#include "base/memory.h"
#include "reference/path_tracer.h"
#include "scene/mesh/surface_points.h"
#include "scene/mesh/triangle_albedos.h"
#include "shared/vpl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* --- points of surfaces ----------------------------------------------------------------------- */

static double triangle_area(const struct geometry *geometry, const uint32_t index[3]) {
    vec3s p[3];
    for (int k = 0; k < 3; k++)
        p[k] = to_vec3s(geometry->position[index[k]]);
    return (double)glms_vec3_norm(
               glms_vec3_cross(glms_vec3_sub(p[1], p[0]), glms_vec3_sub(p[2], p[0]))) /
           2;
}

static double surface_area(const struct geometry *geometry) {
    double area = 0;
    for (uint32_t k = 0; k < geometry->index_count; k += 3)
        area += triangle_area(geometry, &geometry->indices[k]);
    return area;
}

/* In a closed scene the form factors of all that a point sees sum up to 1: sum A cos cos / (pi d^2). A
 * sphere has the same cos cos / d^2 everywhere. Checks places, normals and areas at once. */
static void check_form_factors(const struct stage *stage, int count) {
    struct surface_points points;
    double area = 0, least = INFINITY, most = 0;
    surface_points_init(&points, &(struct surface_points_desc){.scene = &stage->scene,
                                                               .geometry = &stage->geometry,
                                                               .count = count});
    struct surface_place *places = mem_alloc((size_t)count, sizeof *places);
    for (int i = 0; i < count; i++) {
        places[i] = surface_points_place(&points, &stage->geometry, i);
        area += (double)places[i].area;
    }
    for (int x = 0; x < 32; x++) {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            vec3s to = glms_vec3_sub(places[i].position, places[x].position);
            float d2 = glms_vec3_norm2(to), cos_x = glms_vec3_dot(places[x].normal, to),
                  cos_i = -glms_vec3_dot(places[i].normal, to);
            if (cos_x > 0 && cos_i > 0)
                sum += (double)(places[i].area * cos_x * cos_i / (d2 * d2)) / (double)GLM_PIf;
        }
        least = fmin(least, sum);
        most = fmax(most, sum);
    }
    printf("  %d points: form factors from %.4f to %.4f\n", count, least, most);
    check_near("area of all points, over the surface's", area / surface_area(&stage->geometry), 1,
               .01);
    check_near("least sum of form factors", least, 1, .02);
    check_near("greatest sum of form factors", most, 1, .02);
    free(places);
    surface_points_free(&points);
}

static void test_form_factors(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/sphere.glb");
    check_form_factors(&stage, 1024);
    check_form_factors(&stage, 16384);
    stage_free(&stage);
}

/* How much area there is of one side, by the points' share; and how many of them. */
static double area_of(const struct surface_points *points, const struct geometry *geometry,
                      bool back, int *number) {
    double area = 0;
    *number = 0;
    for (int i = 0; i < points->count; i++)
        if (points->items[i].back == back) {
            area += (double)surface_points_place(points, geometry, i).area;
            ++*number;
        }
    return area;
}

/* Both sides of double-sided surfaces have points, of single-sided ones the front; black surfaces have
 * none; a part of the sequence is as even as the whole. */
static void test_sides(void **state) {
    (void)state;
    struct stage stage;
    struct surface_points points;
    int fronts, backs;
    open_stage(&stage, "scenes/cornell-box.glb");
    double whole = surface_area(&stage.geometry);
    for (int sides = 1; sides <= 2; sides++) {
        for (int m = 0; m < stage.scene.material_count; m++)
            stage.scene.materials[m].double_sided = sides == 2;
        surface_points_init(&points, &(struct surface_points_desc){.scene = &stage.scene,
                                                                   .geometry = &stage.geometry,
                                                                   .count = 4096,
                                                                   .first = 4096});
        double front = area_of(&points, &stage.geometry, false, &fronts);
        double back = area_of(&points, &stage.geometry, true, &backs);
        printf("  %d sides: %d points in front, %d behind\n", sides, fronts, backs);
        check_near("area in front, over the surface's", front / whole, 1, .02);
        check_near("area behind", back / whole, sides - 1, .02);
        surface_points_free(&points);
    }
    for (int m = 0; m < stage.scene.material_count; m++)
        for (int c = 0; c < 3; c++)
            stage.scene.materials[m].base_color[c] = 0;
    surface_points_init(&points, &(struct surface_points_desc){.scene = &stage.scene,
                                                               .geometry = &stage.geometry,
                                                               .count = 256});
    check_near("area of a black scene", area_of(&points, &stage.geometry, false, &fronts), 0, 0);
    surface_points_free(&points);
    stage_free(&stage);
}

/* A plain of two triangles, of ten thousand times the area, has no more than a fifth of the points. */
static void test_plain(void **state) {
    (void)state;
    struct stage stage;
    struct surface_points points;
    open_stage(&stage, "scenes/cornell-box.glb");
    struct geometry *geometry = &stage.geometry;
    const struct geometry_part *floor = &geometry->parts[0];
    for (uint32_t i = 0; i < floor->vertex_count; i++)
        for (int c = 0; c < 3; c++)
            geometry->position[floor->first_vertex + i][c] *= 100;
    surface_points_init(&points, &(struct surface_points_desc){
                                     .scene = &stage.scene, .geometry = geometry, .count = 4096});
    int on_plain = 0;
    for (int i = 0; i < points.count; i++)
        on_plain += points.items[i].part == 0;
    printf("  %d of %d points on a part of %u triangles\n", on_plain, points.count,
           floor->index_count / 3);
    check_at_most("share of the points on the plain", (double)on_plain / points.count,
                  .15 * floor->index_count / 3);
    surface_points_free(&points);
    stage_free(&stage);
}

/* --- inside a diffuse sphere ------------------------------------------------------------------ */

static double mean_indirect(const struct stage *stage, const char *technique,
                            const char *settings) {
    struct image image = render_stage(stage, technique, settings, 64);
    double mean = layer_mean(&image, "indirect");
    image_free(&image);
    return mean;
}

/* Albedo 1/2, one bounce is 1/2 everywhere (test_light.c), and each after it half of the one before: what paths carry
 * is right to the last one, and what patches gain or lose is given back. */
static void check_furnace(const struct stage *stage, const char *technique, int points,
                          const char *more, double tolerance) {
    double before = 0;
    for (int bounces = 1; bounces <= 8; bounces *= 2) {
        char settings[160], what[64];
        snprintf(settings, sizeof settings, "clamp=none bounces=%d paths=%d %s", bounces,
                 points, more);
        double mean = mean_indirect(stage, technique, settings), exact = 1 - pow(.5, bounces);
        snprintf(what, sizeof what, "%s, %d bounces", technique, bounces);
        check_near(what, mean / exact, 1, tolerance);
        if (bounces == 2)
            check_near("the second over the first", (mean - before) / before / .5, 1, .01);
        before = mean;
    }
}

static void test_furnace(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/sphere.glb");
    check_furnace(&stage, "unshadowed", 4096, "", .005);
    check_furnace(&stage, "unshadowed", 1024, "", .005);
    check_furnace(&stage, "clustered", 4096, "", .02);
    check_furnace(&stage, "clustered", 1024, "", .02);
    check_furnace(&stage, "clustered", 1024, "path=paper", .005);
    check_furnace(&stage, "instant-radiosity", 256, "map-size=64 vpls=256", .005);
    stage_free(&stage);
}

/* --- energy ----------------------------------------------------------------------------------- */

static double power(const struct vpl *vpl) {
    return (double)(vpl->flux[0] + vpl->flux[1] + vpl->flux[2]);
}

/* What paths leave of all further bounces, and the VPLs of the first one. */
static void read_fluxes(const struct stage *stage, int bounces, double *first, double *further,
                        int *black) {
    char settings[64];
    struct renderer renderer;
    struct output_list outputs;
    snprintf(settings, sizeof settings, "bounces=%d", bounces);
    struct renderer_desc desc = desc_of(stage, "clustered", settings, 32, 32);
    open_renderer(&renderer, &desc);
    renderer_outputs(&renderer, &outputs);
    const struct output *output = output_find(&outputs, "bounce-vpl");
    assert_non_null(output);
    const struct vpl_buffer *buffer = output->source;
    size_t bytes = (size_t)buffer->count * sizeof(struct vpl);
    struct vpl *vpls = read_vpls(&renderer), *points = mem_alloc(bytes, 1);
    buffer_read(&buffer->buffer, 0, bytes, points);
    *first = *further = 0;
    *black = 0;
    for (int i = 0; i < (int)settings_number(&renderer.desc.settings, "vpls"); i++)
        *first += power(&vpls[i]);
    for (int i = 0; i < buffer->count; i++) {
        *further += power(&points[i]);
        *black += points[i].flux[0] == 0 && points[i].flux[1] + points[i].flux[2] > 0;
    }
    free(vpls);
    free(points);
    renderer_free(&renderer);
}

/* Each bounce has at most the greatest albedo of the one before; a wall that reflects no red sends
 * none on. */
static void test_energy(void **state) {
    (void)state;
    struct stage stage;
    double first, further, last, sum = 0, most = .725; /* the white walls, red */
    int black;
    open_stage(&stage, "scenes/cornell-box.glb");
    stage.scene.materials[2].base_color[0] = 0;
    read_fluxes(&stage, 2, &first, &further, &black);
    last = first;
    for (int bounces = 2; bounces <= 5; bounces++) {
        read_fluxes(&stage, bounces, &first, &further, &black);
        double own = further - sum;
        printf("  bounce %d: %.4g W, %.3f of the one before\n", bounces, own, own / last);
        check_at_most("flux over that of the bounce before", own / last, most);
        assert_true(own > 0);
        last = own;
        sum = further;
    }
    printf("  %d VPLs on the wall without red\n", black);
    assert_true(black > 20);
    stage_free(&stage);
}

/* Inside a sphere that reflects half of it each further bounce has half of the flux of the one before, to the last. */
static void test_flux(void **state) {
    (void)state;
    struct stage stage;
    int black;
    open_stage(&stage, "scenes/sphere.glb");
    for (int bounces = 2; bounces <= 8; bounces++) {
        double first, further;
        read_fluxes(&stage, bounces, &first, &further, &black);
        check_near("flux of further bounces", further / first / (1 - pow(.5, bounces - 1)), 1,
                   .003);
    }
    stage_free(&stage);
}

/* What paths take for a triangle's colour, on both of its sides. */
static void test_albedos(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/cornell-box.glb");
    uint32_t count = stage.geometry.index_count / 3;
    struct triangle_albedo *albedos = mem_alloc(count, sizeof *albedos);
    for (int sides = 1; sides <= 2; sides++) {
        for (int m = 0; m < stage.scene.material_count; m++)
            stage.scene.materials[m].double_sided = sides == 2;
        triangle_albedos_find(albedos, &stage.scene, &stage.geometry);
        for (int b = 0; b < stage.geometry.batch_count; b++) {
            const struct geometry_batch *batch = &stage.geometry.batches[b];
            const struct triangle_albedo *albedo = &albedos[batch->first_index / 3];
            const float *color = stage.scene.materials[batch->material].base_color;
            for (int c = 0; c < 3; c++)
                assert_true(albedo->color[c] == color[c]);
            assert_true(albedo->backs == (float)(sides - 1));
        }
    }
    free(albedos);
    stage_free(&stage);
}

/* --- frames ----------------------------------------------------------------------------------- */

/* One bounce is what it was whatever points there would be; and a frame of several depends on its own
 * time alone. */
static void test_frames(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/cornell-animal.glb");
    struct image one = render_stage(&stage, "clustered", "", 48);
    struct image other = render_stage(&stage, "clustered", "bounces=1 paths=300", 48);
    assert_true(same_pixels(&one, &other));
    image_free(&one);
    image_free(&other);
    static const char *const techniques[] = {"clustered", "unshadowed"};
    for (int t = 0; t < 2; t++) {
        struct renderer renderer;
        struct renderer_desc desc = desc_of(&stage, techniques[t], "bounces=3", 48, 48);
        struct emitter light = stage.emitters.items[0];
        struct image fresh = render_layers(&desc), again;
        open_renderer(&renderer, &desc);
        stage.emitters.items[0].position[0] += .5F;
        check_ok("a light elsewhere", renderer_follow(&renderer, &desc));
        renderer_render(&renderer);
        stage.emitters.items[0] = light;
        check_ok("and back", renderer_follow(&renderer, &desc));
        renderer_render(&renderer);
        check_ok("layers", renderer_read_layers(&renderer, &again));
        assert_true(same_pixels(&fresh, &again));
        image_free(&fresh);
        image_free(&again);
        renderer_free(&renderer);
    }
    stage_free(&stage);
}

/* Metaballs come and go: what they leave has all points, and these stay where they are. */
static void test_metaballs(void **state) {
    (void)state;
    struct stage stage;
    struct surface_points points;
    double still = 0, area = 0;
    open_stage(&stage, "scenes/metaballs.glb");
    surface_points_init(&points, &(struct surface_points_desc){.scene = &stage.scene,
                                                               .geometry = &stage.geometry,
                                                               .count = 4096});
    for (int p = 0; p < stage.geometry.part_count; p++) {
        const struct geometry_part *part = &stage.geometry.parts[p];
        for (uint32_t k = 0; !part->dynamic && k < part->index_count; k += 3)
            still += triangle_area(&stage.geometry, &stage.geometry.indices[part->first_index + k]);
    }
    struct surface_place *before = mem_alloc(4096, sizeof *before);
    for (int i = 0; i < points.count; i++) {
        before[i] = surface_points_place(&points, &stage.geometry, i);
        area += (double)before[i].area;
    }
    check_near("area of the points, over that of all but metaballs", area / still, 1, .01);
    check_ok("pose", geometry_pose(&stage.geometry, &stage.scene, 3));
    for (int i = 0; i < points.count; i++) {
        struct surface_place now = surface_points_place(&points, &stage.geometry, i);
        assert_memory_equal(&now, &before[i], sizeof now);
    }
    free(before);
    surface_points_free(&points);
    stage_free(&stage);
}

/* --- the truth -------------------------------------------------------------------------------- */

/* In the box two bounces lack a sixth of the light of eight, and one two fifths. */
static void test_truth(void **state) {
    (void)state;
    struct stage stage;
    struct image truth;
    open_stage(&stage, "scenes/cornell-box.glb");
    check_ok("truth", path_tracer_render(&(struct path_tracer_desc){.scene = &stage.scene,
                                                                    .geometry = &stage.geometry,
                                                                    .camera = &stage.camera,
                                                                    .emitters = stage.emitters,
                                                                    .width = 64,
                                                                    .height = 64,
                                                                    .bounces = 8,
                                                                    .samples = 16},
                                         &truth, NULL));
    double whole = layer_mean(&truth, "indirect");
    printf("  one bounce: %.3f of eight\n", mean_indirect(&stage, "clustered", "") / whole);
    check_near("clustered, over the truth", mean_indirect(&stage, "clustered", "bounces=8") / whole,
               1, .045);
    check_near("instant radiosity", mean_indirect(&stage, "instant-radiosity", "bounces=8") / whole,
               1, .06);
    image_free(&truth);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_form_factors), cmocka_unit_test(test_sides),
        cmocka_unit_test(test_plain),        cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_energy),       cmocka_unit_test(test_frames),
        cmocka_unit_test(test_flux),         cmocka_unit_test(test_albedos),
        cmocka_unit_test(test_metaballs),    cmocka_unit_test(test_truth),
    };
    return cmocka_run_group_tests_name("bounces", tests, open_group_context, close_group_context);
}
