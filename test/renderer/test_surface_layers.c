/* Layers of surfaces: a rasterised frame and rays see the same, positions lie where the pixels
 * look, ids name what the scene has, and files keep whole numbers. */
#include "command_support.h"
#include "smooth_stage.h"

#include "inspect/aov.h"
#include "reference/path_tracer.h"
#include "reference/primary.h"
#include "scene/cryptomatte.h"
#include "scene/surface_layers.h"

#include <cglm/cglm.h>

enum { WIDTH = 90, HEIGHT = 60 };

static const char all[] = "id.node,id.mesh,id.material,position,depth,uv";
static const char all_and_motion[] = "id.node,id.mesh,id.material,position,depth,uv,"
                                     "motion.next,motion.previous";

static struct image draw_layers(const struct stage *stage, const struct camera *camera) {
    struct renderer_desc desc = desc_of(stage, "unshadowed", "", WIDTH, HEIGHT);
    OWNED(renderer) renderer;
    struct image image;
    desc.camera = *camera;
    open_renderer(&renderer, desc);
    check_ok("read", renderer_read_layers(&renderer, &image));
    check_ok("append", aov_append(&renderer, all, NULL, &image));
    return image;
}

static struct image trace(const struct stage *stage, const struct camera *camera,
                          const struct surface_motion *motion) {
    struct image image;
    check_ok("trace",
             path_tracer_render(
                 &FILLED(path_tracer_desc, .scene = &stage->scene, .geometry = &stage->geometry,
                         .camera = camera, .emitters = stage->emitters, .width = WIDTH,
                         .height = HEIGHT, .samples = 1, .bounces = 0, .centers = true,
                         .surface_layers = motion ? all_and_motion : all, .motion = motion),
                 &image, NULL));
    return image;
}

/* Part of the pixels where a channel differs by more than that. */
static double off(const struct image *a, const struct image *b, const char *name, float most) {
    int of_a = image_find_channel(a, name), of_b = image_find_channel(b, name), count = 0;
    assert_true(of_a >= 0 && of_b >= 0);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            count += !(fabsf(image_at(a, x, y)[of_a] - image_at(b, x, y)[of_b]) <= most);
    return (double)count / (WIDTH * HEIGHT);
}

static float value_at(const struct image *image, int x, int y, const char *name) {
    return image_at(image, x, y)[image_find_channel(image, name)];
}

/* A position is in its pixel's centre, at the frame's own Z, as far as depth says. */
static void check_places(const struct image *image, const struct camera *camera, float radius) {
    int seen = 0, astray = 0;
    float off = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            vec3 at, from_eye;
            float place[2], z = value_at(image, x, y, "Z");
            at[0] = value_at(image, x, y, "position.X");
            at[1] = value_at(image, x, y, "position.Y");
            at[2] = value_at(image, x, y, "position.Z");
            assert_int_equal(z > 0, value_at(image, x, y, "id.node") > 0);
            if (z <= 0)
                continue;
            seen++;
            glm_vec3_sub(at, (float *)camera->eye, from_eye);
            assert_true(camera_project(camera, at, (float)WIDTH / HEIGHT, place));
            float depth = camera->orthographic ? z : glm_vec3_norm(from_eye);
            off = fmaxf(off, fmaxf(fabsf(place[0] * WIDTH - (float)x - .5F),
                                   fabsf(place[1] * HEIGHT - (float)y - .5F)));
            astray +=
                !(fabsf(glm_vec3_dot(from_eye, (float *)camera->forward) - z) < 2e-4F * radius &&
                  fabsf(depth - value_at(image, x, y, "depth")) < 1e-5F * radius);
        }
    assert_true(seen > 200);
    check_at_most("pixels off", (double)off, .01);
    check_at_most("depths astray, but for edges", (double)astray / seen, .005);
}

/* Ids name a node that has the mesh, and a mesh that has the material. */
static void check_ids(const struct image *image, const struct scene *scene) {
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            int node = (int)value_at(image, x, y, "id.node") - 1;
            int mesh = (int)value_at(image, x, y, "id.mesh") - 1;
            int material = (int)value_at(image, x, y, "id.material") - 1;
            bool known = false;
            assert_int_equal(node < 0, mesh < 0);
            assert_int_equal(node < 0, material < 0);
            if (node < 0)
                continue;
            assert_int_equal(scene->nodes[node].mesh, mesh);
            for (int i = 0; i < scene->meshes[mesh].primitive_count; i++)
                known |= scene->meshes[mesh].primitives[i].material == material;
            assert_true(known);
        }
}

/* Masked leaves, panes with a shifted lens, an orthographic camera, skins, metaballs. */
TEST(frame_and_rays) {
    static const struct {
        const char *scene;
        double time;
        float extent, shift;
        bool has_panes; /* Z of rays is that of some */
    } rows[] = {
        {.scene = "scenes/plant.glb"},
        {.scene = "scenes/pawns.glb", .shift = .3F, .has_panes = true},
        {.scene = "scenes/cornell-box.glb", .extent = 3},
        {.scene = "scenes/creatures.glb", .time = .7},
        {.scene = "scenes/metaballs.glb", .time = .3},
    };
    for (size_t i = 0; i < (is_long_run() ? sizeof rows / sizeof *rows : 3); i++) {
        printf("    %s\n", rows[i].scene);
        OWNED(stage) stage = open_stage(rows[i].scene);
        check_ok("pose", stage_pose(&stage, rows[i].time));
        struct camera camera = stage.camera;
        camera.orthographic = rows[i].extent > 0;
        camera.y_extent = rows[i].extent;
        camera.shift[0] = rows[i].shift;
        OWNED(image) frame = draw_layers(&stage, &camera), rays = trace(&stage, &camera, NULL);
        float radius = stage.geometry.radius;
        check_places(&frame, &camera, radius);
        if (!rows[i].has_panes)
            check_places(&rays, &camera, radius);
        check_ids(&frame, &stage.scene);
        check_at_most("nodes that differ", off(&frame, &rays, "id.node", 0), .004);
        check_at_most("materials that differ", off(&frame, &rays, "id.material", 0), .004);
        check_at_most("positions that differ", off(&frame, &rays, "position.Y", 1e-3F * radius),
                      .006);
        check_at_most("uvs that differ", off(&frame, &rays, "uv.U", 1e-2F), .02);
    }
}

/* --- motion --- */

/* Weights of a triangle's corners at a point in it, by areas. */
static void weights_at(float (*positions)[3], const uint32_t index[3], const float point[3],
                       float weights[3]) {
    float sum = 0;
    for (int i = 0; i < 3; i++) {
        vec3 a, b, area;
        glm_vec3_sub(positions[index[(i + 1) % 3]], (float *)point, a);
        glm_vec3_sub(positions[index[(i + 2) % 3]], (float *)point, b);
        glm_vec3_cross(a, b, area);
        sum += weights[i] = glm_vec3_norm(area);
    }
    glm_vec3_scale(weights, 1 / sum, weights);
}

/* In the other frame a ray to where a pixel moves meets the same triangle, at the point that the
 * pixel shows now. */
static void check_motion(const char *path, double time, const char *layer) {
    const double step = .04, then = layer[0] == 'n' ? time + step : time - step;
    struct surface_motion motion;
    struct rays rays;
    float(*now)[3];
    int moved = 0, met = 0, apart = 0;
    printf("    %s, %s\n", path, layer);
    OWNED(stage) stage = open_stage(path);
    check_ok("pose", stage_pose(&stage, time));
    struct camera camera = stage.camera;
    check_ok("motion", stage_find_motion(&stage, time, step, &motion));
    OWNED(image) image = trace(&stage, &camera, &motion);
    size_t bytes = stage.geometry.vertex_count * sizeof *now;
    now = malloc(bytes);
    memcpy(now, stage.geometry.position, bytes);
    check_ok("pose", stage_pose(&stage, then));
    open_rays(&rays, &stage);
    struct primary_rays primary =
        primary_rays_of(&rays.scene, &stage.camera, &stage.geometry, WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            struct hit hit;
            float weights[3], point[3] = {0}, place[2], way[2];
            for (int axis = 0; axis < 2; axis++) {
                const char *name = form("motion.%s.%c", layer, "XY"[axis]);
                way[axis] = value_at(&image, x, y, name);
            }
            if (fabsf(way[0]) + fabsf(way[1]) < .05F)
                continue;
            moved++;
            if (!primary_hit(&primary, (float)x + .5F + way[0], (float)y + .5F + way[1], 0, &hit))
                continue;
            const uint32_t *index = stage.geometry.indices + 3 * (size_t)hit.triangle;
            weights_at(stage.geometry.position, index, hit.position.raw, weights);
            for (int i = 0; i < 3; i++)
                glm_vec3_muladds(now[index[i]], weights[i], point);
            if (!camera_project(&camera, point, (float)WIDTH / HEIGHT, place))
                continue;
            float off = fmaxf(fabsf(place[0] * WIDTH - (float)x - .5F),
                              fabsf(place[1] * HEIGHT - (float)y - .5F));
            met += off < 1;
            apart += off < 1 && off > .05F;
        }
    printf("    %d pixels move, %d of them are seen\n", moved, met);
    assert_true(moved > 50 && met > .8 * moved);
    check_at_most("seen elsewhere", (double)apart / met, .02);
    close_rays(&rays);
    free(now);
    surface_motion_free(&motion);
}

/* A skin, a rigid door. */
TEST(motion) {
    check_motion("scenes/character.glb", .5, "next");
    check_motion("scenes/character.glb", .5, "previous");
    check_motion("scenes/door.glb", .5, "next");
}

/* --- mattes --- */

/* The part of a pixel that a name has; NULL: all names together. */
static double coverage_at(const struct image *image, int x, int y, const char *layer,
                          const char *name) {
    double sum = 0, last = 1;
    for (int r = 0; r < 6; r++) {
        uint32_t id, wanted = name ? cryptomatte_id(name) : 0;
        const float *rank = image_at(image, x, y) + 2 * (r % 2) +
                            image_find_channel(image, form("%s%02d.r", layer, r / 2));
        memcpy(&id, rank, sizeof id);
        assert_true((double)rank[1] <= last && (rank[1] > 0) == (id != 0));
        last = (double)rank[1];
        sum += !name || id == wanted ? last : 0;
    }
    return sum;
}

/* A square's edge is a fifth of a pixel into the seventh column and row: pixels are 1/4 m wide. */
TEST(mattes) {
    static const double tolerances[] = {1.5 / 16, .012};
    static const char names[] = "crypto.node,crypto.material";
    OWNED(stage) stage;
    OWNED(renderer) renderer;
    struct image images[2];
    open_squares(&stage, &(struct square){UP_NODE, 1, 1.1}, 1, 3);
    stage.camera.orthographic = true;
    stage.camera.y_extent = 1;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", CHEAP "samples=16", 8, 8));
    check_ok("read", renderer_read_layers(&renderer, &images[0]));
    check_ok("append", aov_append(&renderer, names, NULL, &images[0]));
    const struct path_tracer_desc desc = {.scene = &stage.scene,
                                          .geometry = &stage.geometry,
                                          .camera = &stage.camera,
                                          .emitters = stage.emitters,
                                          .width = 8,
                                          .height = 8,
                                          .samples = 256,
                                          .surface_layers = names};
    check_ok("trace", path_tracer_render(&desc, &images[1], NULL));
    for (int n = 0; n < 8; n++) {
        const struct image *image = &images[n / 4];
        int i = 4 + n % 4;
        double side = i < 6 ? 1 : i == 6 ? .2 : 0, tolerance = tolerances[n / 4];
        check_near("edge", coverage_at(image, i, 4, "crypto_node", "node 2"), side, tolerance);
        check_near("corner", coverage_at(image, i, i, "crypto_material", "material 2"), side * side,
                   tolerance);
        check_near("all", coverage_at(image, i, i, "crypto_node", NULL), 1, 1e-6);
    }
    images_free(&images[0], &images[1]);
}

/* Ids of the specification; what covers a pixel of a file is its alpha. */
TEST(matte_file) {
    OWNED(image) image;
    int partial = 0;
    assert_int_equal(cryptomatte_id("bunny"), 0x13851a76);
    assert_int_equal(cryptomatte_id("bunny_porcelain_mat"), 0xb24b26d4);
    assert_int_equal(cryptomatte_id(""), 0x00800000);
    expect(0, "% render scenes/cornell-box.glb --size 40x40 -q -o @/a.exr --aov crypto.node");
    expect(0, "grep -aq '\": \"[0-9a-f]\\{8\\}\"' @/a.exr");
    check_ok("read", image_read(&image, scratch("a.exr")));
    for (int p = 0; p < 40 * 40; p++) {
        double alpha = (double)value_at(&image, p % 40, p / 40, "A");
        double all = coverage_at(&image, p % 40, p / 40, "crypto_node", NULL);
        assert_true(fabs(alpha - all) < 1e-3);
        partial += alpha > 0 && alpha < 1;
    }
    assert_true(partial > 100);
    expect(1,
           "% render scenes/plant.glb -o @/a.exr --size 16x16 --aov crypto.mesh --set samples=1");
    expect_text("crypto.mesh is of several samples of a pixel, and picture.samples=1 has one");
    expect(2, "% reference scenes/plant.glb -o @/a.exr --spp 4 --centers --aov crypto.mesh");
}

/* --- files --- */

/* Integers of a file, and the names in its header. */
TEST(file) {
    OWNED(image) drawn, read;
    const char *path = form("%s", scratch("ids.exr"));
    expect(0, "% render scenes/pawns.glb --size 60x40 --passes 2 -q -o @/ids.exr "
              "--aov id.node,id.material");
    expect(0, "% reference scenes/pawns.glb --size 60x40 --spp 1 --centers -q -o @/rays.exr "
              "--aov id.material,uv");
    expect(0, "grep -aq 'manylight:id.material.*{\"1\": \"' @/ids.exr");
    check_ok("read", image_read(&drawn, path));
    check_ok("read", image_read(&read, scratch("rays.exr")));
    int of_drawn = image_find_channel(&drawn, "id.material");
    int of_read = image_find_channel(&read, "id.material"), other = 0, seen = 0;
    assert_true(of_drawn >= 0 && of_read >= 0);
    for (int i = 0; i < 60 * 40; i++) {
        float a = drawn.pixels[i * drawn.channel_count + of_drawn];
        other += a != read.pixels[i * read.channel_count + of_read];
        seen += a > 0;
    }
    assert_true(seen > 300);
    check_at_most("other materials", other, 12);
    images_free(&drawn, &read);
    /* Large numbers keep their last digit. */
    image_init(&drawn, 3, 1, "R G B id.node");
    for (int x = 0; x < 3; x++)
        image_at(&drawn, x, 0)[3] = (float)(16777213 + x);
    check_ok("write", image_write(&drawn, path));
    check_ok("read", image_read(&read, path));
    for (int x = 0; x < 3; x++)
        check_near("id", (double)image_at(&read, x, 0)[image_find_channel(&read, "id.node")],
                   16777213 + x, 0);
}

TEST(refusals) {
    expect(1, "% render scenes/pawns.glb -o @/a.exr --size 16x16 --aov id.nodes");
    expect_text("has no layer 'id.nodes' to add");
    expect_text("id.material");
    expect(2, "% render scenes/pawns.glb -o @/a.exr --size 16x16 --aov id.node,ao --passes 2");
    expect_text("of one pass");
    expect(2, "% reference scenes/pawns.glb -o @/a.exr --size 16x16 --aov ao");
    expect_text("no layer of surfaces is called 'ao'");
    expect(2, "% reference scenes/pawns.glb -o @/a.exr --size 16x16 --technique vpl-raytraced "
              "--aov uv");
    expect_text("--aov is for --technique path");
    expect(2, "% render scenes/pawns.glb -o @/a.png --size 16x16 --aov uv");
}

RUN_TESTS(open_group_context, close_group_context)
