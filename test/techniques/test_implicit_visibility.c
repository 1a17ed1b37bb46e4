/* Radiosity with implicit visibility: exact answers of elements, links and bounces, and what must
 * not change them. */
#include "volume_scenes.h"

#include "base/clock.h"
#include "techniques/implicit-visibility/light.h"

struct radiosity {
    struct stage stage;
    struct elements elements;
    struct tree tree;
    struct links links;
    struct element_light light;
};

/* A shape in white of that albedo; frees it. */
static void open_radiosity(struct radiosity *radiosity, struct shape *shape, double albedo,
                           int most, const struct links_desc *desc, bool two_sided) {
    open_shape(&radiosity->stage, shape, albedo, two_sided, at(0, 0, 0));
    const struct geometry *geometry = &radiosity->stage.geometry;
    elements_init(&radiosity->elements,
                  &(struct elements_desc){&radiosity->stage.scene, geometry, MATERIALS_DIFFUSE,
                                          false, most, false});
    tree_init(&radiosity->tree, &radiosity->elements, .3F * geometry->radius);
    links_init(&radiosity->links, desc, radiosity->elements.count);
    element_light_init(&radiosity->light, &radiosity->tree);
}

static void close_radiosity(struct radiosity *radiosity) {
    elements_free(&radiosity->elements);
    tree_free(&radiosity->tree);
    links_free(&radiosity->links);
    element_light_free(&radiosity->light);
    stage_free(&radiosity->stage);
}

static void set_radiance(struct radiosity *radiosity, float (*of)(const struct element *element)) {
    for (int i = 0; i < radiosity->elements.count; i++)
        for (int c = 0; c < 3; c++)
            radiosity->light.radiance[i][c] = of(&radiosity->elements.items[i]);
    tree_pull_up_values(&radiosity->tree, radiosity->light.radiance);
}

static double gathered(const struct radiosity *radiosity, int leaf) {
    return (double)links_gather(&radiosity->links, leaf,
                                (const float(*)[4])radiosity->light.radiance)
        .x;
}

static float one(const struct element *element) {
    (void)element;
    return 1;
}

static struct shape *sphere(void) {
    struct shape *shape = new_shape();
    add_bowl(shape, 1);
    return shape;
}

/* --- elements --------------------------------------------------------------------------------- */

static double area_of(const struct elements *elements) {
    double area = 0;
    for (int i = 0; i < elements->count; i++)
        area += (double)elements->items[i].area;
    return area;
}

static double triangles_area(const struct geometry *geometry) {
    double area = 0;
    for (uint32_t i = 0; i < geometry->index_count; i += 3)
        area += corners_area(geometry, &geometry->indices[i]);
    return area;
}

/* Coarse and fine meshes, of one side and of two. */
TEST(areas) {
    for (int two_sided = 0; two_sided < 2; two_sided++) {
        struct radiosity radiosity;
        struct shape *shape = sphere();
        add_rectangle(shape, at(-2, -2, -2), at(9, 0, 0), at(0, 7, 0));
        open_radiosity(&radiosity, shape, .5, 700, &(struct links_desc){.side = 4}, two_sided);
        double area = triangles_area(&radiosity.stage.geometry) * (1 + two_sided);
        printf("  %d elements, area %.5f of %.5f\n", radiosity.elements.count,
               area_of(&radiosity.elements), area);
        check_at_most("elements", radiosity.elements.count, 700);
        check_at_most("fewest elements", 350, radiosity.elements.count);
        check_near("area", area_of(&radiosity.elements) / area, 1, 1e-5);
        check_near("area of the root",
                   (double)radiosity.tree.nodes[radiosity.tree.count - 1].area / area, 1, 1e-5);
        close_radiosity(&radiosity);
    }
}

/* --- links ------------------------------------------------------------------------------------ */

struct share {
    double mean, least, worst; /* of the filled share; |E - pi filled| / pi */
    double most;               /* E / pi */
};

/* Where all nodes shine alike each leaf gets the light of its filled bins, exactly. */
static struct share share_of(struct radiosity *radiosity) {
    struct share share = {.least = 1};
    links_make(&radiosity->links, &radiosity->tree, NULL);
    set_radiance(radiosity, one);
    for (int i = 0; i < radiosity->elements.count; i++) {
        double filled = (double)radiosity->links.filled[i] - (double)radiosity->links.buried[i];
        share.worst = fmax(share.worst, fabs(gathered(radiosity, i) / GLM_PI - filled));
        share.mean += filled / radiosity->elements.count;
        share.least = fmin(share.least, filled);
        share.most = fmax(share.most, gathered(radiosity, i) / GLM_PI);
    }
    return share;
}

static double check_sphere(const struct links_desc *desc, int most, bool with_plate) {
    struct radiosity radiosity;
    struct shape *shape = sphere();
    if (with_plate) {
        add_rectangle(shape, at(-.4F, -.2F, -.3F), at(.7F, 0, 0), at(0, .3F, .6F));
        add_rectangle(shape, at(-.4F, -.2F, -.3F), at(0, .3F, .6F), at(.7F, 0, 0));
    }
    open_radiosity(&radiosity, shape, .5, most, desc, false);
    struct share share = share_of(&radiosity);
    printf("  %4d leaves, 6 x %2d^2 bins: E / pi L %.4f, least %.4f\n", radiosity.elements.count,
           desc->side, share.mean, share.least);
    check_at_most("E / pi L without the filled share", share.worst, 1e-5);
    check_at_most("E / pi L", share.most, 1 + 1e-5);
    close_radiosity(&radiosity);
    return share.mean;
}

/* E = pi L in a closed sphere, and whatever stands in it. As published a tenth of the light leaks
 * away. */
TEST(sphere) {
    for (int side = 4; side <= 12; side += 4)
        check_at_most("leak", 1 - check_sphere(&(struct links_desc){.side = side}, 1500, false),
                      .01);
    check_at_most("leak of few leaves",
                  1 - check_sphere(&(struct links_desc){.side = 12}, 300, false), .02);
    check_at_most("leak with a plate",
                  1 - check_sphere(&(struct links_desc){.side = 8}, 1500, true), .02);
    struct links_desc published = {.side = 12, .cover = LINKS_COVER_CENTER, .leaky = true};
    double leak = 1 - check_sphere(&published, 1500, false);
    check_at_most("published leak", leak, .3);
    check_at_most("published leak, at least", .015, leak);
}

struct pair_links {
    double mean, count, linked, ms; /* E / pi L; links of leaves; ends between nodes; CPU */
};

static struct pair_links links_of(int side, int most, bool pairs) {
    struct radiosity radiosity;
    struct pair_links of = {0};
    open_radiosity(&radiosity, sphere(), .5, most,
                   &(struct links_desc){
                       .side = side, .cover = LINKS_COVER_CENTER, .leaky = true, .pairs = pairs},
                   false);
    of.ms = -clock_cpu_ms();
    of.mean = share_of(&radiosity).mean;
    of.ms += clock_cpu_ms();
    for (int i = 0; i < radiosity.elements.count; i++)
        of.count += radiosity.links.counts[i];
    of.linked = (double)radiosity.links.linked;
    printf("  %4d leaves, 6 x %2d^2 bins, by %s: E / pi L %.4f, %6.0f links of leaves, %6.0f ends "
           "between nodes, %.0f ms\n",
           radiosity.elements.count, side, pairs ? "pairs " : "leaves", of.mean, of.count,
           of.linked, of.ms);
    close_radiosity(&radiosity);
    return of;
}

/* Pairs of nodes that are refined and pushed end with nearly the links of leaves that walk alone */
TEST(pairs) {
    for (int side = 8; side <= 16; side += 4) {
        struct pair_links pairs = links_of(side, 1500, true), alone = links_of(side, 1500, false);
        check_near("E by pairs", pairs.mean / alone.mean, 1, .03);
        check_near("links by pairs", pairs.count / alone.count, 1, .03);
        check_at_most("ends between nodes over links of leaves", pairs.linked / pairs.count, 1);
    }
}

static float left_square(const struct element *element) {
    return element->position.x < 0 ? 1 / GLM_PIf : 0;
}

/* Two unit squares face each other, 1 apart: form factor .19982. */
static double squares_factor(int side, int most) {
    struct radiosity radiosity;
    struct shape *shape = new_shape();
    double sum = 0, area = 0;
    add_rectangle(shape, at(-.5F, -.5F, -.5F), at(0, 1, 0), at(0, 0, 1));
    add_rectangle(shape, at(.5F, -.5F, -.5F), at(0, 0, 1), at(0, 1, 0));
    open_radiosity(&radiosity, shape, .5, most, &(struct links_desc){.side = side}, false);
    links_make(&radiosity.links, &radiosity.tree, NULL);
    set_radiance(&radiosity, left_square);
    for (int i = 0; i < radiosity.elements.count; i++) {
        const struct element *element = &radiosity.elements.items[i];
        if (element->position.x < 0)
            continue;
        sum += (double)element->area * gathered(&radiosity, i);
        area += (double)element->area;
    }
    printf("  6 x %2d^2 bins, %d leaves: form factor %.5f\n", side, radiosity.elements.count,
           sum / area);
    close_radiosity(&radiosity);
    return sum / area;
}

TEST(squares) {
    check_near("form factor", squares_factor(12, 800), .19982, .012);
    check_near("form factor", squares_factor(24, 3000), .19982, .005);
}

/* All bins of a convex body are open. */
TEST(convex) {
    struct radiosity radiosity;
    float sky[6 * 8 * 8][3];
    struct shape *shape = sphere();
    turn_inside_out(shape);
    for (size_t b = 0; b < sizeof sky / sizeof *sky; b++)
        sky[b][0] = sky[b][1] = sky[b][2] = 1;
    open_radiosity(&radiosity, shape, .5, 800, &(struct links_desc){.side = 8}, false);
    links_make(&radiosity.links, &radiosity.tree, (const float(*)[3])sky);
    double least = INFINITY, most = 0, filled = 0;
    for (int i = 0; i < radiosity.elements.count; i++) {
        least = fmin(least, (double)radiosity.links.sky[i][0]);
        most = fmax(most, (double)radiosity.links.sky[i][0]);
        filled += (double)radiosity.links.filled[i] / radiosity.elements.count;
    }
    printf("  convex body: sky %.4f to %.4f, filled %.5f\n", least, most, filled);
    check_at_most("filled bins", filled, .002);
    check_near("mean sky", (least + most) / 2, GLM_PI, .05);
    close_radiosity(&radiosity);
}

/* --- bounces ---------------------------------------------------------------------------------- */

/* 0 <= E <= pi times the greatest radiance. */
static void check_bounds(const struct radiosity *radiosity) {
    double brightest = 0, least = INFINITY, most = 0;
    for (int i = 0; i < radiosity->elements.count; i++) {
        brightest = fmax(brightest, (double)radiosity->light.radiance[i][0]);
        least = fmin(least, (double)radiosity->light.irradiance[i][0]);
        most = fmax(most, (double)radiosity->light.irradiance[i][0]);
    }
    check_at_most("negative irradiance", -least, 0);
    check_at_most("greatest irradiance over pi L", most / (GLM_PI * brightest), 1 + 1e-5);
}

/* A light in the middle of a sphere: E_d = I / R^2, and all bounces together add E_d rho / (1 -
 * rho). */
TEST(furnace) {
    struct radiosity radiosity;
    struct bvh casters, panes = {0};
    struct emitter light = emitter_new(EMITTER_POINT);
    const double albedo = .5;
    double direct = 0, indirect = 0, last = 0;
    open_radiosity(&radiosity, sphere(), albedo, 1000, &(struct links_desc){.side = 8}, false);
    const struct geometry *geometry = &radiosity.stage.geometry;
    element_light_casters(&casters, &panes, &radiosity.stage.scene, geometry);
    links_make(&radiosity.links, &radiosity.tree, NULL);
    element_light_direct(
        &radiosity.light, &radiosity.elements,
        &(struct direct_lights){&light, 1, false, &casters, &panes, geometry_clearance(geometry)},
        &radiosity.links);
    for (int bounces = 1; bounces <= 20; bounces += bounces < 3 ? 1 : 17) {
        element_light_bounce(&radiosity.light, &radiosity.elements, &radiosity.tree,
                             &radiosity.links, bounces);
        direct = indirect = 0;
        for (int i = 0; i < radiosity.elements.count; i++) {
            direct += (double)radiosity.light.direct[i][0] / radiosity.elements.count;
            indirect += (double)radiosity.light.irradiance[i][0] / radiosity.elements.count;
        }
        check_bounds(&radiosity);
        double expected = albedo * (1 - pow(albedo, bounces)) / (1 - albedo);
        printf("  %2d bounces: direct %.4f, indirect %.4f of %.4f\n", bounces, direct, indirect,
               expected);
        check_near("direct", direct, 1, .01);
        check_near("indirect over its sum", indirect / expected, 1, .015);
        check_at_most("the bounce before", last, indirect);
        last = indirect;
    }
    bvh_free(&casters);
    close_radiosity(&radiosity);
}

/* The picture of the sphere shows what its elements have: one bounce, over pi. */
TEST(picture) {
    OWNED(stage) stage;
    double least = INFINITY, most = 0;
    open_shape(&stage, sphere(), .5, false, at(0, 0, 0));
    look(&stage, at(0, 0, 0), at(0, -1, 0), at(0, 0, 1), 1);
    OWNED(image) layers =
        render_stage(&stage, "implicit-visibility", "elements=1000 radiosity.bins=8", 32);
    int channel = image_find_channel(&layers, "indirect.R");
    for (int y = 0; y < 32; y++)
        for (int x = 0; x < 32; x++) {
            least = fmin(least, (double)image_at(&layers, x, y)[channel]);
            most = fmax(most, (double)image_at(&layers, x, y)[channel]);
        }
    printf("  picture of the sphere: %.4f to %.4f of %.4f\n", least, most, .5 / GLM_PI);
    check_near("least", least * GLM_PI / .5, 1, .03);
    check_near("most", most * GLM_PI / .5, 1, .03);
}

static float half_shines(const struct element *element) {
    return element->position.z > 0 ? 1 : 0;
}

/* Lamps shine by their own lists of links as by all links, and no other link is in the lists. */
TEST(lamps) {
    struct radiosity radiosity;
    double worst = 0, lists = 0, all = 0;
    open_radiosity(&radiosity, sphere(), .5, 1000, &(struct links_desc){.side = 8}, false);
    for (int i = 0; i < radiosity.elements.count; i++) {
        struct element *element = &radiosity.elements.items[i];
        element->emission = glms_vec3_fill(half_shines(element));
    }
    element_light_emit(&radiosity.light, &radiosity.elements, &radiosity.tree);
    links_make(&radiosity.links, &radiosity.tree, NULL);
    links_sort_lamps(&radiosity.links, (const float(*)[4])radiosity.light.emission);
    element_light_direct(&radiosity.light, &radiosity.elements,
                         &(struct direct_lights){.lamps_by_links = true}, &radiosity.links);
    set_radiance(&radiosity, half_shines);
    for (int i = 0; i < radiosity.elements.count; i++) {
        double direct = (double)radiosity.light.direct[i][0];
        worst = fmax(worst, fabs(direct - gathered(&radiosity, i)));
        lists += radiosity.links.lamp_counts[i];
        all += radiosity.links.counts[i];
    }
    printf("  %.0f of %.0f links lead to the half that shines\n", lists, all);
    check_at_most("lists beside all links", worst, 1e-5);
    check_near("share of the lists", lists / all, .5, .1);
    close_radiosity(&radiosity);
}

/* --- order ------------------------------------------------------------------------------------ */

static float by_height(const struct element *element) {
    return 1 + element->position.y;
}

static struct shape *room(bool reversed) {
    struct shape *shape = sphere();
    add_rectangle(shape, at(-.5F, -.4F, -.5F), at(0, 0, 1), at(1, 0, 0));
    for (int i = 0; reversed && i < shape->index_count / 6; i++)
        for (int c = 0; c < 3; c++) {
            int a = 3 * i + c, b = shape->index_count - 3 * (i + 1) + c;
            uint32_t index = shape->indices[a];
            shape->indices[a] = shape->indices[b];
            shape->indices[b] = index;
        }
    return shape;
}

/* Irradiance of all leaves; for free(). */
static double *room_light(int threads, struct shape *shape, int *count, double *mean) {
    struct radiosity radiosity;
    open_radiosity(&radiosity, shape, .5, 900, &(struct links_desc){.side = 8, .threads = threads},
                   false);
    links_make(&radiosity.links, &radiosity.tree, NULL);
    set_radiance(&radiosity, by_height);
    double *light = mem_alloc((size_t)radiosity.elements.count, sizeof *light), area = 0;
    double least = INFINITY, most = 0;
    *count = radiosity.elements.count;
    *mean = 0;
    for (int i = 0; i < *count; i++) {
        light[i] = gathered(&radiosity, i);
        least = fmin(least, light[i]);
        most = fmax(most, light[i]);
        area += (double)radiosity.elements.items[i].area;
        *mean += (double)radiosity.elements.items[i].area * light[i];
    }
    *mean /= area;
    check_at_most("greatest irradiance over pi L", most / (2 * GLM_PI), 1 + 1e-5);
    check_at_most("negative irradiance", -least, 0);
    close_radiosity(&radiosity);
    return light;
}

TEST(order) {
    int counts[3];
    double means[3];
    double *alone = room_light(1, room(false), &counts[0], &means[0]);
    double *together = room_light(2, room(false), &counts[1], &means[1]);
    double *reversed = room_light(2, room(true), &counts[2], &means[2]);
    printf("  mean irradiance %.5f by 1 thread, %.5f by 2, %.5f of reversed triangles\n", means[0],
           means[1], means[2]);
    assert_int_equal(counts[0], counts[1]);
    assert_memory_equal(alone, together, (size_t)counts[0] * sizeof *alone);
    check_near("reversed triangles", means[2] / means[0], 1, .01);
    mem_free(alone, together, reversed);
}

/* A box with a plate in it, each triangle cut in so many: 1 or 4. */
static struct shape *box(int parts) {
    struct shape *shape = new_shape();
    add_room(shape, at(-1, -1, -1), at(1, 1, 1));
    add_rectangle(shape, at(-.5F, -.4F, -.5F), at(0, 0, 1), at(1, 0, 0));
    const int whole = parts == 4 ? shape->index_count : 0;
    for (int i = 0; i < whole; i += 3) {
        uint32_t corner[3], middle[3];
        memcpy(corner, &shape->indices[i], sizeof corner);
        for (int v = 0; v < 3; v++) {
            uint32_t next = corner[(v + 1) % 3];
            vec3s place = glms_vec3_lerp(to_vec3s(shape->position[corner[v]]),
                                         to_vec3s(shape->position[next]), .5F);
            middle[v] = add_vertex(shape, place, to_vec3s(shape->normal[next]));
        }
        memcpy(&shape->indices[i], middle, sizeof middle);
        for (int v = 0; v < 3; v++)
            memcpy(&shape->indices[(shape->index_count += 3) - 3],
                   (uint32_t[]){corner[v], middle[v], middle[(v + 2) % 3]}, sizeof middle);
    }
    return shape;
}

/* Four parts of a triangle are as much surface as the whole. */
TEST(cut) {
    int counts[2];
    double means[2];
    for (int i = 0; i < 2; i++)
        free(room_light(0, box(i == 0 ? 1 : 4), &counts[i], &means[i]));
    printf("  mean irradiance %.5f of %d elements, %.5f of %d where triangles are cut in four\n",
           means[0], counts[0], means[1], counts[1]);
    check_near("cut triangles", means[1] / means[0], 1, .01);
}

/* --- what must not change the picture --------------------------------------------------------- */

/* A frame is the same whatever pose its renderer began in. */
TEST(start) {
    struct stage stage;
    struct image layers[2];
    for (int i = 0; i < 2; i++) {
        struct renderer renderer;
        stage = open_stage("scenes/character.glb");
        if (i == 1)
            check_ok("pose", stage_pose(&stage, 1));
        open_renderer(&renderer, desc_of(&stage, "implicit-visibility",
                                         "elements=500 radiosity.bins=8", 32, 32));
        check_ok("pose", stage_pose(&stage, 1));
        check_ok("show", stage_show(&stage, &renderer));
        renderer_render(&renderer);
        check_ok("layers", renderer_read_layers(&renderer, &layers[i]));
        renderer_free(&renderer);
        stage_free(&stage);
    }
    printf("  begun at 0 s and at 1 s: relative RMSE %g\n",
           relative_rmse(&layers[0], &layers[1], "indirect"));
    assert_true(same_pixels(&layers[0], &layers[1]));
    images_free(&layers[0], &layers[1]);
}

/* A corner of two walls, and a sky that is bright at one side. */
static void open_corner(struct stage *stage) {
    struct shape *shape = new_shape();
    struct environment *sky = mem_alloc(1, sizeof *sky);
    add_rectangle(shape, at(0, 0, 0), at(0, 0, 1), at(1, 0, 0));
    add_rectangle(shape, at(0, 0, 0), at(0, 1, 0), at(0, 0, 1));
    open_shape(stage, shape, .5, false, at(.5F, .5F, .5F));
    *sky = (struct environment){.width = 16, .height = 8, .strength = 1};
    sky->texels = mem_alloc(16 * 8, sizeof *sky->texels);
    for (int i = 0; i < 16 * 8; i++)
        for (int c = 0; c < 3; c++)
            sky->texels[i][c] = i % 16 < 4 ? 1 : .1F;
    environment_free(stage->scene.environment);
    stage->scene.environment = sky;
    look(stage, at(.4F, 0, .5F), at(-1, -1, 0), at(-1, 1, 0), 2);
}

/* A sun that a user adds is no part of a sky that does not shine. */
TEST(sun) {
    static const char *const settings[] = {"elements=500 radiosity.sky=rays",
                                           "elements=500 radiosity.sky=bins"};
    OWNED(stage) stage;
    struct image layers[2];
    struct emitter sun = emitter_new(EMITTER_DIRECTIONAL);
    open_corner(&stage);
    emitter_aim(&sun, (const float[]){-.5F, -1, 0});
    for (int i = 0; i < 2; i++) {
        struct renderer_desc desc = desc_of(&stage, "implicit-visibility", settings[i], 32, 32);
        desc.emitters = (struct emitters){.items = &sun, .count = 1};
        layers[i] = render_layers(&desc);
    }
    printf("  sun alone, sky=bins beside sky=rays: relative RMSE %g\n",
           relative_rmse(&layers[1], &layers[0], "indirect"));
    assert_true(same_pixels(&layers[0], &layers[1]));
    images_free(&layers[0], &layers[1]);
}

/* A sky that turns in place. */
TEST(turned_sky) {
    OWNED(stage) stage;
    OWNED(renderer) renderer = {0};
    open_corner(&stage);
    struct renderer_desc desc =
        desc_of(&stage, "implicit-visibility", "elements=500 radiosity.sky=bins", 32, 32);
    desc.emitters = (struct emitters){.sky = stage.scene.environment};
    OWNED(image) before = follow_layers(&renderer, &desc);
    stage.scene.environment->turn = 90;
    renderer_relight(&renderer);
    check_ok("update", renderer_update(&renderer));
    OWNED(image) turned = follow_layers(&renderer, &desc), fresh = render_layers(&desc);
    double change = relative_rmse(&before, &fresh, "indirect");
    printf("  turned sky: relative RMSE %g of a new renderer's, %g unturned\n",
           relative_rmse(&turned, &fresh, "indirect"), change);
    check_at_most("change by the turn", .05, change);
    assert_true(same_pixels(&turned, &fresh));
}

/* --- limits ----------------------------------------------------------------------------------- */

/* Links that no machine has room for end with an error that says so. */
TEST(memory) {
    struct links links;
    check_refused(links_init(&links, &(struct links_desc){.side = 32}, INT32_MAX / 16),
                  "surface elements");
    links_free(&links);
}

/* A box that nearly reaches the eye covers bins up to the face's edge. */
TEST(near_window) {
    struct bins bins;
    struct bins_window window;
    bins_init(&bins, 8);
    assert_true(bins_window_of(&bins, 0, (const float[]){1, 0, 0},
                               (const float[]){1 - 0x1p-23F, 3000, 3000}, &window));
    for (int c = 0; c < 2; c++) {
        assert_int_equal(window.first[c], 0);
        assert_int_equal(window.end[c], 8);
    }
    bins_free(&bins);
}

RUN_TESTS(open_group_context, close_group_context)
