/* Imperfect shadow maps: the points that they are made of, what one of them hides, how holes are
 * closed, and that they become maps of triangles. */
#include "gltf_parts.h"
#include "render_support.h"

#include "passes/frame.h"
#include "passes/visibility/vpl_views.h"
#include "scene/open.h"
#include "shared/maps.h"
#include "shared/splat.h"
#include "shared/vpl.h"
#include "techniques/imperfect-shadow-maps/fill.h"
#include "techniques/imperfect-shadow-maps/splat.h"
#include "scene/mesh/surface_points.h"

static const char name[] = "imperfect-shadow-maps";

/* --- points ----------------------------------------------------------------------------------- */

static double area_of(const struct geometry *geometry) {
    double area = 0;
    for (uint32_t k = 0; k < geometry->index_count; k += 3) {
        vec3s p[3];
        for (int i = 0; i < 3; i++)
            p[i] = to_vec3s(geometry->position[geometry->indices[k + (uint32_t)i]]);
        area += (double)glms_vec3_norm(
                    glms_vec3_cross(glms_vec3_sub(p[1], p[0]), glms_vec3_sub(p[2], p[0]))) /
                2;
    }
    return area;
}

/* All surfaces hide light, once: black ones too, of one side or of two, and metaballs. */
static void check_points(const char *path, bool black, bool double_sided) {
    struct surface_points points;
    double area = 0;
    OWNED(stage) stage = open_stage(path);
    for (int m = 0; m < stage.scene.material_count; m++) {
        stage.scene.materials[m].double_sided = double_sided;
        for (int c = 0; c < 3 && black; c++)
            stage.scene.materials[m].base_color[c] = 0;
    }
    surface_points_init(&points,
                        &FILLED(surface_points_desc, .scene = &stage.scene,
                                .geometry = &stage.geometry, .count = 4096, .first = 4096));
    for (int i = 0; i < points.count; i++)
        area += (double)surface_points_place(&points, &stage.geometry, i).area;
    check_near(path, area / area_of(&stage.geometry), 1, .01);
    surface_points_free(&points);
}

TEST(points) {
    check_points("scenes/cornell-box.glb", true, false);
    check_points("scenes/cornell-box.glb", false, true);
    check_points("scenes/metaballs.glb", false, false);
}

/* Points of the quad stand for its area, and for none of holes. */
TEST(quad) {
    enum { POINTS = 64 };
    static const struct {
        const char *materials;
        double area;
    } rows[] = {
        {"[{}]", 1},
        {"[{doubleSided: true}]", 1},
        {"[{pbrMetallicRoughness: {baseColorFactor: [0, 0, 0, 1]}}]", 1},
        {"[{alphaMode: MASK}]", 1},
        {"[{alphaMode: MASK, pbrMetallicRoughness: {baseColorFactor: [1, 1, 1, 0.25]}}]", 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(scene) scene;
        OWNED(geometry) geometry;
        struct surface_points points;
        double area = 0, lower = 0;
        const struct gltf_parts parts = {.materials = rows[i].materials};
        check_ok("open", scene_open(&scene, &geometry, write_parts("points.glb", &parts), NULL));
        surface_points_init(
            &points, &(struct surface_points_desc){
                         .scene = &scene, .geometry = &geometry, .count = POINTS, .first = 7});
        for (int p = 0; p < POINTS; p++) {
            struct surface_place place = surface_points_place(&points, &geometry, p);
            area += (double)place.area;
            lower += place.position.y < .5F ? (double)place.area : 0;
        }
        check_near(rows[i].materials, area, rows[i].area, 1e-4);
        check_near("half of it below the middle", lower, area / 2, .1 * area);
        surface_points_free(&points);
    }
}

/* In a closed scene the form factors of all that a point sees sum up to 1: sum A cos cos / (pi
 * d^2). A sphere has the same cos cos / d^2 everywhere. Checks places, normals and areas
 * at once. */
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
    check_near("area of all points, over the surface's", area / area_of(&stage->geometry), 1, .01);
    check_near("least sum of form factors", least, 1, .02);
    check_near("greatest sum of form factors", most, 1, .02);
    free(places);
    surface_points_free(&points);
}

TEST(form_factors) {
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    check_form_factors(&stage, 1024);
    check_form_factors(&stage, 16384);
}

/* A plain of two triangles, of ten thousand times the area, has no more than a fifth of
 * the points. */
TEST(plain) {
    struct surface_points points;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
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
}

/* --- what a point hides ----------------------------------------------------------------------- */

/* Inside a sphere, where 256 disks of .15 of their points' radius hardly overlap: A cos /
 * d^2 each. */
static double disks_solid_angle(const struct surface_points *points,
                                const struct geometry *geometry, const struct vpl *vpl,
                                float scale) {
    vec3s from = to_vec3s(vpl->position), axis = to_vec3s(vpl->normal);
    double sum = 0;
    for (int i = 0; i < points->count; i++) {
        struct surface_place place = surface_points_place(points, geometry, i);
        vec3s to = glms_vec3_sub(place.position, from);
        float d = glms_vec3_norm(to), radius = scale * sqrtf(place.area / GLM_PIf);
        float facing = fabsf(glms_vec3_dot(place.normal, to)) / d;
        if (d > radius && glms_vec3_dot(axis, to) > 0)
            sum += (double)(place.area * scale * scale * facing / (d * d));
    }
    return sum;
}

/* Of the texels that show something: the projection is the stereographic one. */
static double map_solid_angle(const float *depths, int size) {
    double sum = 0, side = 2. / size;
    for (int i = 0; i < size * size; i++) {
        double x = (i % size + .5) * side - 1, y = (i / size + .5) * side - 1, p2 = x * x + y * y;
        if (depths[i] < 1 && p2 < 1)
            sum += 4 / ((1 + p2) * (1 + p2)) * side * side;
    }
    return sum;
}

static float *read_depths(const struct depth_maps *maps) {
    int texels = maps->size * maps->size * maps->count;
    float *depths = mem_alloc((size_t)texels, sizeof *depths);
    gl.GetTextureImage(maps->depth.id, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                       texels * (GLsizei)sizeof *depths, depths);
    return depths;
}

TEST(solid_angle) {
    enum { VPLS = 16, POINTS = 256, SIZE = 256 };
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    OWNED(renderer) renderer;
    struct output_list outputs;
    struct surface_points points;
    struct splat_pass splat;
    struct vpl_views_pass views;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=16 interleave=4", 16, 16));
    renderer_outputs(&renderer, &outputs);
    struct splat_desc small = {
        .points = {&stage.scene, &stage.geometry, POINTS, 1},
        .size = SIZE,
        .count = VPLS,
        .scale = .15F,
        .shape = SPLAT_DISK,
    };
    check_ok("views", vpl_views_pass_init(&views, 0));
    check_ok("splat", splat_pass_init(&splat, &small));
    struct frame frame = renderer_frame(&renderer);
    vpl_views_pass_render(&views, &frame, output_vpls(&outputs), 0, VPLS);
    splat_pass_render(&splat, &frame, &views.views, 0);
    float *depths = read_depths(&splat.maps);
    struct vpl *vpls = read_vpls(&renderer);
    surface_points_init(&points, &(struct surface_points_desc){.scene = &stage.scene,
                                                               .geometry = &stage.geometry,
                                                               .count = POINTS});
    double shown = 0, exact = 0;
    for (int i = 0; i < VPLS; i++) {
        double map = map_solid_angle(&depths[i * SIZE * SIZE], SIZE);
        double disks = disks_solid_angle(&points, &stage.geometry, &vpls[i], .15f);
        check_near("solid angle of a map's disks, over their own", map / disks, 1, .2);
        shown += map;
        exact += disks;
    }
    check_near("of all maps", shown / exact, 1, .05);
    surface_points_free(&points);
    splat_pass_free(&splat);
    vpl_views_pass_free(&views);
    mem_free(depths, vpls);
}

/* --- pull and push ---------------------------------------------------------------------------- */

enum { SIDE = 32, MAPS = 2, TEXELS = SIDE * SIDE };

/* Maps that a test makes by hand, and what the pass makes of them. */
struct filling {
    struct renderer *renderer;
    float radius;
    float before[MAPS][TEXELS], after[MAPS][TEXELS];
};

static void run_filling(struct filling *filling) {
    struct fill_pass fill;
    struct texture holes;
    struct map_view views[MAP_VIEWS_MAX] = {{.z_far = 1}, {.z_far = 1}};
    struct map_views block = {.count = MAPS};
    struct depth_maps maps = {.size = SIDE, .count = MAPS};
    check_ok("fill", fill_pass_init(&fill, SIDE, MAPS));
    check_ok("holes", texture_init(&holes, &FILLED(texture_desc, .label = "holes",
                                                   .target = GL_TEXTURE_2D_ARRAY,
                                                   .format = GL_DEPTH_COMPONENT16, .width = SIDE,
                                                   .height = SIDE, .layers = MAPS)));
    check_ok("views", buffer_init(&block.buffer, "views", sizeof views, views));
    gl.TextureSubImage3D(holes.id, 0, 0, 0, 0, SIDE, SIDE, MAPS, GL_DEPTH_COMPONENT, GL_FLOAT,
                         filling->before);
    struct frame frame = renderer_frame(filling->renderer);
    maps.depth = holes;
    fill_pass_render(&fill, &frame, &maps, &block, filling->radius);
    float *depths = read_depths(&fill.maps);
    memcpy(filling->after, depths, sizeof filling->after);
    free(depths);
    buffer_free(&block.buffer);
    texture_free(&holes);
    fill_pass_free(&fill);
}

/* The greatest difference from a depth, over a map. */
static double farthest_from(const float depths[TEXELS], float depth) {
    double worst = 0;
    for (int i = 0; i < TEXELS; i++)
        worst = fmax(worst, fabs((double)(depths[i] - depth)));
    return worst;
}

/* A wall of points that reach a few texels: what is missing comes back, what is empty stays so, and
 * neither map knows of the other. */
static void check_wall(struct filling *filling) {
    srand(5);
    for (int i = 0; i < TEXELS; i++) {
        filling->before[0][i] = rand() % 5 == 0 ? 1 : .5f;
        filling->before[1][i] = 1;
    }
    filling->radius = .12F;
    run_filling(filling);
    check_at_most("a wall with holes, filled, from the wall", farthest_from(filling->after[0], .5f),
                  1e-4);
    check_at_most("an empty map, filled, from an empty one", farthest_from(filling->after[1], 1),
                  0);
    /* What shows through a hole is behind by more than points of a surface are. */
    for (int i = 0; i < TEXELS; i++)
        filling->before[0][i] = filling->before[0][i] < 1 ? .2f : .9f;
    filling->radius = .04F;
    run_filling(filling);
    check_at_most("a wall before another, from it", farthest_from(filling->after[0], .2f), 1e-4);
}

/* Points as small as texels leave no holes: what is empty is a gap. */
static void check_gaps(struct filling *filling) {
    for (int i = 0; i < TEXELS; i++)
        filling->before[0][i] = filling->before[1][i] = i % SIDE % 8 < 3 ? 1 : .5f;
    filling->radius = .01F;
    run_filling(filling);
    double worst = 0;
    for (int i = 0; i < TEXELS; i++)
        worst = fmax(worst, fabs((double)(filling->after[0][i] - filling->before[0][i])));
    check_at_most("gaps between dense points, from themselves", worst, 1e-4);
}

/* It brings nearer, but not before what is there. */
static void check_nearer(struct filling *filling) {
    for (int i = 0; i < TEXELS; i++) {
        filling->before[0][i] = .3f + .4f * (float)rand() / (float)RAND_MAX;
        filling->before[1][i] = rand() % 3 ? 1 : filling->before[0][i];
    }
    filling->radius = .1F;
    run_filling(filling);
    double farther = 0, nearest = 1;
    for (int k = 0; k < MAPS; k++)
        for (int i = 0; i < TEXELS; i++) {
            farther = fmax(farther, (double)(filling->after[k][i] - filling->before[k][i]));
            nearest = fmin(nearest, (double)filling->after[k][i]);
        }
    check_at_most("farther than before", farther, 1e-4);
    check_near("nearest of all", nearest, .3, .01);
}

TEST(filling) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=1 interleave=1", 16, 16));
    struct filling *filling = mem_alloc(1, sizeof *filling);
    filling->renderer = &renderer;
    check_wall(filling);
    check_gaps(filling);
    check_nearer(filling);
    free(filling);
}

/* --- pictures --------------------------------------------------------------------------------- */

static double error_against(const struct image *reference, const struct stage *stage,
                            const char *technique, const char *settings) {
    struct image image = render_stage(stage, technique, settings, 64);
    double error = relative_rmse(&image, reference, "indirect");
    printf("  %s %s: %.4f\n", technique, settings, error);
    image_free(&image);
    return error;
}

/* With more points and texels they become the maps of triangles; with few they are better than
 * none. */
TEST(converges) {
    struct stage stage = open_stage("scenes/cornell-box.glb");
#define PLAIN "vpls=64 interleave=1 "
#define MAP(size, points)                                                                          \
    PLAIN "imperfect-shadow-maps.size=" #size " imperfect-shadow-maps.map-points=" #points " "
    struct image reference = render_stage(&stage, "instant-radiosity", PLAIN, 64);
    double none = error_against(&reference, &stage, "unshadowed", PLAIN);
    double few = error_against(&reference, &stage, name, MAP(64, 256));
    double some = error_against(&reference, &stage, name, MAP(64, 2048));
    double many = error_against(&reference, &stage, name, MAP(256, 32768));
    double square = error_against(&reference, &stage, name, MAP(64, 2048) "shape=square");
    double filled = error_against(&reference, &stage, name, MAP(64, 2048) "shape=filled");
    check_at_most("few points, over no maps", few / none, .8);
    check_at_most("more points, over few", some / few, .6);
    check_at_most("more texels and points, over some", many / some, .7);
    check_at_most("many points", many, .02);
    check_at_most("squares, over no maps", square / none, 1);
    check_at_most("filled ones", filled / none, 1);
    image_free(&reference);
    stage_free(&stage);
}

/* Nothing is hidden from anything inside a sphere. */
TEST(sphere) {
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    OWNED(image) reference = render_stage(&stage, "unshadowed", "clamp=none", 64);
    check_at_most("inside a sphere, against no visibility",
                  error_against(&reference, &stage, name, "clamp=none"), .01);
}

/* Points of metaballs are dealt anew, and yet a frame depends on its own time alone. */
TEST(frames) {
    OWNED(stage) stage = open_stage("scenes/metaballs.glb");
    OWNED(renderer) renderer;
    OWNED(image) again;
    struct renderer_desc desc =
        desc_of(&stage, name, "vpls=64 imperfect-shadow-maps.map-points=512", 32, 32);
    OWNED(image) fresh = render_layers(&desc);
    open_renderer(&renderer, desc);
    for (int back = 0; back < 2; back++) {
        check_ok("pose", geometry_pose(&stage.geometry, &stage.scene, back ? 0 : 1.5));
        check_ok("moved", renderer_follow(&renderer, &desc));
        renderer_render(&renderer);
    }
    check_ok("layers", renderer_read_layers(&renderer, &again));
    check_at_most("there and back", relative_rmse(&again, &fresh, "indirect"), 0);
}

RUN_TESTS(open_group_context, close_group_context)
