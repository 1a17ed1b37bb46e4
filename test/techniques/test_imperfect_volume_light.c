/* Indirect light of volumes: spherical harmonics, energy, and what must not change it. */
#include "volume_scenes.h"

#include "inspect/aov.h"
#include "shared/vpl.h"

/* --- spherical harmonics ---------------------------------------------------------------------- */

struct question {
    float axis[4], slope[4], normal[4];
};

static void ask(const struct question *question, float answer[4]) {
    ask_shader(&FILLED(questions, .shader = "sh.comp", .asked = question,
                       .asked_bytes = sizeof *question, .answers = answer,
                       .answer_bytes = 4 * sizeof *answer, .groups = {1}));
}

/* A hole of half angle a over the normal lets in sin^2 a; order 2 knows (1 - cos a) / 2 + sin^2 a /
 * 2 of it, and order 3 adds 5/16 cos a sin^2 a. A sky above a plane tilted by b gives (1 + cos b) /
 * 2, and a slope v of the light 1 + 2/3 v.n, at any order; all over pi. */
TEST(harmonics) {
    float answer[4];
    for (int degrees = 30; degrees <= 60; degrees += 15) {
        double a = degrees * GLM_PI / 180, c = cos(a), s2 = sin(a) * sin(a);
        const struct question hole = {.axis = {.36F, .48F, .8F, (float)c},
                                      .normal = {.36F, .48F, .8F}};
        ask(&hole, answer);
        printf("  hole of %d degrees: %.4f\n", degrees, s2);
        check_near("order 2", (double)answer[0] / GLM_PI, (1 - c) / 2 + s2 / 2, 2e-3);
        check_near("order 3", (double)answer[1] / GLM_PI, (1 - c) / 2 + s2 / 2 + 5. / 16 * c * s2,
                   2e-3);
    }
    for (int degrees = 0; degrees <= 180; degrees += 45) {
        double b = degrees * GLM_PI / 180;
        const struct question sky = {.axis = {0, 1, 0, 0},
                                     .normal = {(float)sin(b), (float)cos(b), 0}};
        ask(&sky, answer);
        check_near("tilted under a sky, order 2", (double)answer[0] / GLM_PI, (1 + cos(b)) / 2,
                   2e-3);
        check_near("order 3", (double)answer[1] / GLM_PI, (1 + cos(b)) / 2, 2e-3);
    }
    const struct question slope = {
        .axis = {0, 1, 0, -2}, .slope = {.2F, .3F, -.5F}, .normal = {.6F, 0, .8F}};
    ask(&slope, answer);
    check_near("slope", (double)answer[1] / GLM_PI, 1 + 2. / 3 * (.2 * .6 - .5 * .8), 2e-3);
}

/* --- what points leave ------------------------------------------------------------------------ */

/* A square of 4 m in so many by so many squares: 59 voxels wide at volume.size=64, in the middle of
 * its voxels. */
static double filled_share(const char *settings, int squares) {
    OWNED(stage) stage;
    struct lit lit;
    struct shape *shape = new_shape();
    int count, filled = 0;
    float side = 4 / (float)squares;
    for (int i = 0; i < squares * squares; i++)
        add_rectangle(shape,
                      at(-2 + side * (float)(i % squares), 0, 2 - side * (float)(i / squares)),
                      at(side, 0, 0), at(0, 0, -side));
    open_shape(&stage, shape, .5, false, at(0, 3, 0));
    open_lit(&lit, &stage, settings, 1);
    float(*texels)[4] = read_atlas(&lit.light.volume.surfaces, &count);
    for (int t = 0; t < count; t++)
        filled += texels[t][3] > 0;
    free(texels);
    close_lit(&lit);
    return filled / (60. * 60);
}

/* Of k random points a voxel, of 60 x 60: those at the sides have half of the square's area in
 * them, the corners a quarter. */
static double random_share(double k) {
    return 1 - (58 * 58 * exp(-k) + 4 * 58 * exp(-k / 2) + 4 * exp(-k / 4)) / (60 * 60);
}

static double sigma_of(double share) {
    return sqrt(share * (1 - share) / (60 * 60));
}

/* Of random points each voxel of a plane stays empty with probability e^-k. */
TEST(random_occupancy) {
    static const struct {
        int squares, points; /* of each triangle */
    } cases[] = {{4, 25}, {4, 100}, {8, 50}, {8, 100}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int triangles = 2 * cases[i].squares * cases[i].squares;
        double k = triangles * cases[i].points / (59. * 59), expected = random_share(k);
        const char *settings = form("volume.size=64 published=on voxel-points=%d", cases[i].points);
        printf("  k = %.3f\n", k);
        check_near("filled", filled_share(settings, cases[i].squares), expected,
                   3 * sigma_of(expected));
    }
}

/* Points by area are even: they leave fewer voxels empty. */
TEST(occupancy) {
    static const double means[] = {1, 3};
    for (size_t i = 0; i < sizeof means / sizeof *means; i++) {
        double expected = random_share(means[i]);
        const char *settings = form("volume.size=64 voxel-points=%g", means[i]);
        double filled = filled_share(settings, 1);
        printf("  k = %g: %.4f filled, random points %.4f\n", means[i], filled, expected);
        check_at_most("random points over these", expected - 3 * sigma_of(expected), filled);
        check_at_most("filled", filled, 1);
    }
}

static double sum_of(const struct texture *texture) {
    int count;
    double sum = 0;
    float(*texels)[4] = read_atlas(texture, &count);
    for (int t = 0; t < count; t++)
        sum += (double)(texels[t][0] + texels[t][1] + texels[t][2]);
    free(texels);
    return sum;
}

static double area_of(const struct geometry *geometry) {
    double area = 0;
    for (uint32_t i = 0; i < geometry->index_count; i += 3)
        area += corners_area(geometry, &geometry->indices[i]);
    return area;
}

/* Points reflect the light that VPLs carry. */
TEST(flux) {
    struct lit lit;
    double flux = 0;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    open_lit(&lit, &stage, "voxel-points=20", 1);
    struct renderer renderer;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=4096", 32, 32));
    struct vpl *vpls = read_vpls(&renderer);
    for (int i = 0; i < 4096; i++)
        flux += (double)(vpls[i].flux[0] + vpls[i].flux[1] + vpls[i].flux[2]);
    free(vpls);
    double point_area = area_of(&stage.geometry) / lit.light.points.points.count;
    double sum = sum_of(&lit.light.volume.radiosity) * point_area;
    check_near("flux of points over that of VPLs", sum / (double)lit.frame.irradiance_scale / flux,
               1, .02);
    renderer_free(&renderer);
    close_lit(&lit);
}

/* Each bounce has at most the greatest albedo of the one before. */
TEST(bounces) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    double before = 0, own_before = 0;
    for (int bounces = 1; bounces <= (is_long_run() ? 5 : 3); bounces++) {
        struct lit lit;
        open_lit(&lit, &stage, "order=3", bounces);
        const struct volume_light *light = &lit.light;
        double sum = sum_of(bounces == 1 ? &light->volume.radiosity : &light->reflect.radiosity);
        double own = sum - before;
        if (bounces > 1) {
            printf("  reflection %d: %.3f of the one before\n", bounces, own / own_before);
            check_at_most("flux over that of the bounce before", own / own_before, .725);
            assert_true(own > 0);
        }
        own_before = own;
        before = sum;
        close_lit(&lit);
    }
}

/* Inside a sphere of albedo 1/2 the direct layer is 1 everywhere, and so many bounces add 1 -
 * 1/2^b. */
static double furnace_error(const struct stage *stage, const char *size, int bounces) {
    const char *settings = form("%s lights.bounces=%d", size, bounces);
    OWNED(image) image = render_stage(stage, "imperfect-volume", settings, 48);
    double mean = layer_mean(&image, "indirect"), exact = 1 - pow(.5, bounces);
    printf("  %s: %.4f, exact %.4f\n", settings, mean, exact);
    return fabs(mean / exact - 1);
}

TEST(furnace) {
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    for (int bounces = 1; bounces <= 4; bounces++)
        if (is_tried_here((size_t)bounces, 4))
            check_at_most("relative error at 64^3",
                          furnace_error(&stage, "volume.size=64", bounces), .1);
    if (is_long_run())
        check_at_most("at 128^3", furnace_error(&stage, "volume.size=128", 1), .05);
}

/* --- what must not change it ------------------------------------------------------------------ */

static bool same_atlas(const struct texture *a, const struct texture *b) {
    int count, other;
    float(*x)[4] = read_atlas(a, &count), (*y)[4] = read_atlas(b, &other);
    bool same = count == other && memcmp(x, y, (size_t)count * sizeof *x) == 0;
    mem_free(x, y);
    return same;
}

/* The light that lies in the volume depends on no camera. */
TEST(camera) {
    struct lit a, b;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    open_lit(&a, &stage, "volume.size=32", 2);
    stage.camera.eye[0] += .3F;
    stage.camera.fov_y *= .5F;
    open_lit(&b, &stage, "volume.size=32", 2);
    for (int i = 0; i < a.light.volume.coefficient_count; i++)
        assert_true(same_atlas(&a.light.volume.coefficients[i], &b.light.volume.coefficients[i]));
    close_lit(&a);
    close_lit(&b);
}

/* The order in which points are drawn changes nothing but rounding. */
TEST(permutation) {
    struct lit lit;
    int count;
    double worst = 0;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    open_lit(&lit, &stage, "volume.size=32", 1);
    float(*before)[4] = read_atlas(&lit.light.volume.coefficients[0], &count);
    const struct buffer *buffer = &lit.light.points.buffer;
    size_t points = (size_t)lit.light.points.points.count, bytes = buffer->size / points;
    char *all = mem_alloc(points, bytes), *turned = mem_alloc(points, bytes);
    buffer_read(buffer, 0, buffer->size, all);
    for (size_t i = 0; i < points; i++)
        memcpy(turned + i * bytes, all + (points - 1 - i) * bytes, bytes);
    buffer_write(buffer, 0, buffer->size, turned);
    light_volume(&lit);
    float(*after)[4] = read_atlas(&lit.light.volume.coefficients[0], &count);
    double most = 0;
    for (int t = 0; t < count; t++)
        for (int c = 0; c < 4; c++) {
            worst = fmax(worst, fabs((double)(after[t][c] - before[t][c])));
            most = fmax(most, fabs((double)before[t][c]));
        }
    check_at_most("greatest difference over the greatest value", worst / most, 1e-3);
    assert_true(most > 0);
    mem_free(all, turned, before, after);
    close_lit(&lit);
}

/* A light twice as strong gives twice the light. */
TEST(linear) {
    OWNED(stage) stage = open_stage("scenes/three-lights.glb");
    OWNED(image) once = render_stage(&stage, "imperfect-volume", "volume.size=32", 48);
    for (int i = 0; i < stage.emitters.count; i++)
        for (int c = 0; c < 3; c++)
            stage.emitters.items[i].intensity[c] *= 2;
    OWNED(image) twice = render_stage(&stage, "imperfect-volume", "volume.size=32", 48);
    check_near("mean over that of half the light",
               layer_mean(&twice, "indirect") / layer_mean(&once, "indirect"), 2, 1e-4);
}

/* A corner at a place in a box that two small triangles hold. Lengths that floats have exactly: a
 * voxel is 1/16 m. */
static void open_corner(struct stage *stage, float x) {
    struct shape *shape = new_shape();
    const float size = .0625F;
    add_rectangle(shape, at(x + 1, 1, 3), at(2, 0, 0), at(0, 0, -2));
    add_rectangle(shape, at(x + 1, 1, 3), at(0, 0, -2), at(0, 1, 0));
    for (int i = 0; i < 2; i++) {
        float corner = i ? 4 - size : 0;
        add_rectangle(shape, at(corner, corner, corner), at(size, 0, 0), at(0, size, -0));
        add_rectangle(shape, at(corner, corner, corner), at(0, size, 0), at(0, 0, size));
    }
    open_shape(stage, shape, .5, false, at(x + 2, 2, 2));
    look(stage, at(x + 1.75F, 1, 2), at(0, -1, 0), at(0, 0, -1), 1.25F);
}

static double corner_difference(float shift) {
    struct stage stage;
    struct seen here, there;
    double sum = 0;
    int count = 0;
    open_corner(&stage, 0);
    see_occlusion(&here, &stage, "volume.size=69", 64);
    stage_free(&stage);
    open_corner(&stage, shift);
    see_occlusion(&there, &stage, "volume.size=69", 64);
    stage_free(&stage);
    for (int i = 0; i < 64 * 64; i++)
        if (here.texels[i][3] > 0 && there.texels[i][3] > 0) {
            sum += pow((double)(here.texels[i][0] - there.texels[i][0]), 2);
            count++;
        }
    assert_true(count > 3000);
    free_seen(&here);
    free_seen(&there);
    return sqrt(sum / count);
}

/* 27 neighbours have other rays, so that three voxels are the same again. */
TEST(shift) {
    check_at_most("RMS difference, three voxels on", corner_difference(3 * .0625F), 1e-3);
    check_at_most("a voxel on", corner_difference(.0625F), .01);
    check_at_most("a third of a voxel on", corner_difference(.0625F / 3), .03);
}

/* --- voxels before the camera ----------------------------------------------------------------- */

/* The top of a cube of 1 m, of albedo 1/2, under a light of 1 W/sr at 2.5 m: albedo times
 * irradiance, and nothing beside the cube. Places of a voxel differ by less than 1 % of
 * the light. */
TEST(voxels) {
    OWNED(stage) stage;
    OWNED(renderer) renderer;
    OWNED(image) image;
    struct shape *shape = new_shape();
    double worst = 0, beside = 0;
    int inside = 0, outside = 0;
    add_room(shape, at(.5F, .5F, .5F), at(-.5F, -.5F, -.5F)); /* seen from without */
    open_shape(&stage, shape, .5, false, at(0, 3, 0));
    look(&stage, at(0, .5F, 0), at(0, -1, 0), at(0, 0, -1), 2);
    open_renderer(&renderer, desc_of(&stage, "imperfect-volume", "volume.size=32", 64, 64));
    check_ok("layers", renderer_read_layers(&renderer, &image));
    check_ok("voxels", aov_append(&renderer, "voxels", NULL, &image));
    int channel = image_find_channel(&image, "voxels.R");
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++) {
            double across = ((double)x - 31.5) / 32, along = ((double)y - 31.5) / 32;
            double off = fmax(fabs(across), fabs(along));
            double radiosity = (double)image_at(&image, x, y)[channel];
            double distance2 = across * across + along * along + 2.5 * 2.5;
            double exact = .5 * 2.5 / pow(distance2, 1.5);
            if (off < .45) { /* not in a voxel of two faces */
                worst = fmax(worst, fabs(radiosity / exact - 1));
                inside++;
            } else if (off > .55) {
                beside = fmax(beside, fabs(radiosity));
                outside++;
            }
        }
    assert_true(inside > 700 && outside > 2500);
    check_at_most("relative error of the radiosity", worst, .015);
    check_near("beside the cube", beside, 0, 0);
}

/* --- leaks ------------------------------------------------------------------------------------ */

static double mean_on_floor(struct stage *stage, float x) {
    look(stage, at(x, 0, .5F), at(0, -1, 0), at(0, 0, -1), .9F);
    OWNED(image) image = render_stage(stage, "imperfect-volume", "volume.size=65", 48);
    double mean = layer_mean(&image, "indirect");
    return mean;
}

/* Two rooms of 1 m side by side, the light in one: 60 voxels are 2 m and the wall, whose middle is
 * that of voxels. */
static double leak(double wall) {
    OWNED(stage) stage;
    struct shape *shape = new_shape();
    float width = (float)(wall * 2 / (60 - wall));
    add_room(shape, at(0, 0, 0), at(1, 1, 1));
    add_room(shape, at(1 + width, 0, 0), at(2 + width, 1, 1));
    open_shape(&stage, shape, .7, false, at(.5F, .7F, .5F));
    double lit = mean_on_floor(&stage, .5F), dark = mean_on_floor(&stage, 1.5F + width);
    printf("  wall of %g voxels: %.4f of the light leaks\n", wall, dark / lit);
    assert_true(lit > 0);
    return dark / lit;
}

TEST(leaks) {
    check_at_most("through a wall of half a voxel", leak(.5), .02);
    check_at_most("of a voxel", leak(1), .02);
    check_at_most("of two voxels", leak(2), .02);
    check_at_most("of four voxels", leak(4), .02);
}

/* --- memory ----------------------------------------------------------------------------------- */

static bool opens(const struct stage *stage, const char *settings) {
    struct renderer renderer;
    struct renderer_desc desc = desc_of(stage, "imperfect-volume", settings, 16, 16);
    bool ok = renderer_init(&renderer, &desc);
    if (ok)
        renderer_free(&renderer);
    return ok;
}

/* What counts is the box that the volume holds: a thin plate of 400 voxels takes less than a cube
 * of 280, and the main part of a plain is a cube. */
TEST(memory) {
    OWNED(stage) plate, cube, plain;
    struct shape *shape = new_shape(), *other = new_shape();
    add_rectangle(shape, at(-2, 0, 2), at(4, 0, 0), at(0, 0, -4));
    open_shape(&plate, shape, .5, false, at(0, 3, 0));
    add_room(other, at(0, 0, 0), at(1, 1, 1));
    open_shape(&cube, other, .5, false, at(.5F, .5F, .5F));
    check_ok("a plate of 400 voxels", opens(&plate, "volume.size=400"));
    check_refused(opens(&cube, "volume.size=400"), "volume.size 400: up to ");
    plain = open_stage("scenes/failures/plain.glb");
    check_refused(opens(&plain, "volume.size=400"), "volume.size 400: up to ");
}

/* A line has no points to make voxels of, and a single triangle has. */
TEST(few_triangles) {
    OWNED(stage) stage;
    struct shape *line = new_shape(), *triangle = new_shape();
    add_rectangle(line, at(0, 0, 0), at(1, 0, 0), at(1, 0, 0));
    open_shape(&stage, line, .5, false, at(.5F, 1, 0));
    check_refused(opens(&stage, ""), "volume: the scene's 2 triangles have no area");
    stage_free(&stage);
    add_rectangle(triangle, at(0, 0, 0), at(1, 0, 0), at(0, 0, -1));
    triangle->index_count = 3;
    open_shape(&stage, triangle, .5, false, at(.5F, 1, 0));
    OWNED(image) image = render_stage(&stage, "imperfect-volume", "volume.size=16", 32);
    check_near("light of a plane on itself", layer_mean(&image, "indirect"), 0, .01);
}

RUN_TESTS(open_group_context, close_group_context)
