/* Light of later bounces: exact answers inside a sphere, energy, and the path tracer's picture. */
#include "gltf_parts.h"
#include "render_support.h"

#include "passes/lights/bounce.h"
#include "scene/mesh/triangle_albedos.h"
#include "shared/bounce.h"
#include "shared/vpl.h"
#include "techniques/many_lights.h"

/* --- inside a diffuse sphere ------------------------------------------------------------------ */

static double mean_indirect(const struct stage *stage, const char *technique,
                            const char *settings) {
    struct image image = render_stage(stage, technique, settings, is_long_run() ? 64 : 32);
    double mean = layer_mean(&image, "indirect");
    image_free(&image);
    return mean;
}

/* Albedo 1/2, one bounce is 1/2 everywhere (test_light.c), and each after it half of the one
 * before: what paths carry is right to the last one, and what patches gain or lose is
 * given back. */
static void check_furnace(const struct stage *stage, const char *technique, int paths,
                          const char *more, double tolerance) {
    double before = 0;
    for (int bounces = 1; bounces <= 8; bounces *= 2) {
        char what[64];
        const char *settings = form("clamp=none bounces=%d paths=%d %s", bounces, paths, more);
        double mean = mean_indirect(stage, technique, settings), exact = 1 - pow(.5, bounces);
        snprintf(what, sizeof what, "%s, %d bounces", technique, bounces);
        check_near(what, mean / exact, 1, tolerance);
        if (bounces == 2)
            check_near("the second over the first", (mean - before) / before / .5, 1, .01);
        before = mean;
    }
}

TEST(furnace) {
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    check_furnace(&stage, "unshadowed", 1024, "", .005);
    check_furnace(&stage, "clustered", 1024, "", .02);
    if (is_long_run()) {
        /* Of so few paths the camera sees the light of some dozen, which tell what patches keep. */
        check_furnace(&stage, "instant-radiosity", 256, "map-size=64 vpls=256", .02);
        check_furnace(&stage, "unshadowed", 4096, "", .005);
        check_furnace(&stage, "clustered", 4096, "", .02);
        check_furnace(&stage, "clustered", 1024, "path=paper", .005);
    }
}

/* --- energy ----------------------------------------------------------------------------------- */

static double power(const struct vpl *vpl) {
    return (double)(vpl->flux[0] + vpl->flux[1] + vpl->flux[2]);
}

struct row {
    float (*texels)[4];
};

static struct row read_row(const struct texture *texture, int y) {
    int count = texture->desc.width;
    struct row row = {mem_alloc((size_t)count, sizeof *row.texels)};
    gl.GetTextureSubImage(texture->id, 0, 0, y, 0, count, 1, 1, GL_RGBA, GL_FLOAT,
                          count * (int)sizeof *row.texels, row.texels);
    return row;
}

static const struct bounce_pass *bounce_pass_of(const struct output_list *outputs) {
    const char *vpls = output_find(outputs, "bounce-vpl")->source;
    return (const struct bounce_pass *)(const void *)(vpls - offsetof(struct bounce_pass, vpls));
}

/* The caller frees them. */
static struct vpl *read_buffer(const struct vpl_buffer *buffer) {
    size_t bytes = (size_t)buffer->count * sizeof(struct vpl);
    struct vpl *vpls = mem_alloc(bytes, 1);
    buffer_read(&buffer->buffer, 0, bytes, vpls);
    return vpls;
}

/* The VPLs of later bounces; the caller frees them. */
static struct vpl *read_later(const struct stage *stage, const char *settings, int *count) {
    OWNED(renderer) renderer;
    struct output_list outputs;
    open_renderer(&renderer, desc_of(stage, "unshadowed", settings, 32, 32));
    renderer_outputs(&renderer, &outputs);
    const struct vpl_buffer *buffer = output_find(&outputs, "bounce-vpl")->source;
    struct vpl *vpls = read_buffer(buffer);
    *count = buffer->count;
    return vpls;
}

/* What paths leave of all later bounces, and the VPLs of the first one. */
static void read_fluxes(const struct stage *stage, int bounces, double *first, double *later,
                        int *black) {
    struct renderer renderer;
    struct output_list outputs;
    const char *settings = form("bounces=%d vpls=1024 vals=8 map-size=64", bounces);
    struct renderer_desc desc = desc_of(stage, "clustered", settings, 32, 32);
    open_renderer(&renderer, desc);
    renderer_outputs(&renderer, &outputs);
    const struct output *output = output_find(&outputs, "bounce-vpl");
    assert_non_null(output);
    const struct vpl_buffer *buffer = output->source;
    struct vpl *vpls = read_vpls(&renderer), *points = read_buffer(buffer);
    *first = *later = 0;
    *black = 0;
    for (int i = 0; i < (int)settings_number(&renderer.desc.settings, "vpls"); i++)
        *first += power(&vpls[i]);
    for (int i = 0; i < buffer->count; i++) {
        *later += power(&points[i]);
        *black += points[i].flux[0] == 0 && points[i].flux[1] + points[i].flux[2] > 0;
    }
    mem_free(vpls, points);
    renderer_free(&renderer);
}

/* Each bounce has at most the greatest albedo of the one before; a wall that reflects no red sends
 * none on. */
TEST(energy) {
    double first, later, last, sum = 0, most = .725; /* the white walls, red */
    int black;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    stage.scene.materials[2].base_color[0] = 0;
    read_fluxes(&stage, 2, &first, &later, &black);
    last = first;
    for (int bounces = 2; bounces <= 5; bounces++) {
        read_fluxes(&stage, bounces, &first, &later, &black);
        double own = later - sum;
        printf("  bounce %d: %.4g W, %.3f of the one before\n", bounces, own, own / last);
        check_at_most("flux over that of the bounce before", own / last, most);
        assert_true(own > 0);
        last = own;
        sum = later;
    }
    printf("  %d VPLs on the wall without red\n", black);
    assert_true(black > 20);
}

/* Inside a sphere that reflects half of it each later bounce has half of the flux of the one
 * before, to the last. */
TEST(flux) {
    int black;
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    for (int bounces = 2; bounces <= 8; bounces++) {
        double first, later;
        if (!is_tried_here((size_t)bounces, 4) && bounces != 2)
            continue;
        read_fluxes(&stage, bounces, &first, &later, &black);
        check_near("flux of later bounces", later / first / (1 - pow(.5, bounces - 1)), 1, .003);
    }
}

/* What an eighth of a sphere has over what it should have, of places and of light: adds up the
 * squares of how far that is off, and the light. */
static void add_eighths(const struct vpl *vpls, int count, double squares[2], double *light) {
    double places[8] = {0}, powers[8] = {0}, all = 0;
    for (int i = 0; i < count; i++) {
        const float *p = vpls[i].position;
        int eighth = (p[0] > 0) + 2 * (p[1] > 0) + 4 * (p[2] > 0);
        places[eighth] += 1. / count;
        powers[eighth] += power(&vpls[i]);
        all += power(&vpls[i]);
    }
    for (int k = 0; k < 8; k++) {
        squares[0] += pow(8 * places[k] - 1, 2);
        squares[1] += pow(8 * powers[k] / all - 1, 2);
    }
    *light += all;
}

/* VPLs have the light of more paths than those that left them, so that parts of a sphere have more
 * even light than numbers of VPLs. However few VPLs there are, what is too far from all of them is
 * given back. */
TEST(shared) {
    enum { SETS = 6 };
    static const int counts[] = {256, 512, 4096};
    double lights[3] = {0};
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    for (int n = 0; n < 3; n++) {
        double squares[2] = {0};
        for (int seed = 1; seed <= SETS; seed++) {
            int count;
            const char *settings = form("bounces=2 paths=%d seed=%d", counts[n], seed);
            struct vpl *vpls = read_later(&stage, settings, &count);
            add_eighths(vpls, count, squares, &lights[n]);
            free(vpls);
        }
        printf("  %d VPLs: eighths are off by %.4f of places, %.4f of light\n", counts[n],
               sqrt(squares[0] / (8 * SETS)), sqrt(squares[1] / (8 * SETS)));
        if (counts[n] >= BOUNCE_POOL)
            check_at_most("light's over places'", sqrt(squares[1] / squares[0]), .9);
        check_near("light of so many over that of 256", lights[n] / lights[0], 1, .005);
    }
}

#define PLACED(mesh, x, y, z, width, turn)                                                         \
    "{mesh: " mesh ", translation: [" x ", " y ", " z "], scale: [" width                          \
    ", 4, 1], rotation: [" turn "0.70710678, 0, 0, 0.70710678]}, "
#define MESH(material)                                                                             \
    "{primitives: [{attributes: {POSITION: 0}, indices: 1, material: " material "}]}"
#define MATERIAL(color)                                                                            \
    "{pbrMetallicRoughness: {metallicFactor: 0, baseColorFactor: [" color ", " color ", " color    \
    ", 1]}}"

/* The board lies 10 cm above the floor; or as high as the floor, behind a wall of 90 cm. */
#define HIGH_BOARD PLACED("0", "-2", "0.1", "2", "2", "-")
#define BOARD_BEHIND_WALL                                                                          \
    PLACED("0", "-2", "0", "2", "2", "-")                                                          \
    "{mesh: 0, translation: [0, 0, 2], scale: [4, 0.9, 1], rotation: [0, 0.70710678, 0, "          \
    "0.70710678]}, "

/* Below a ceiling that a spot lights a white board and beside it a dark floor. */
static void open_board(struct stage *stage, const char *board) {
    const char *nodes =
        form("[%s" PLACED("1", "0", "0", "2", "2", "-")
                 PLACED("0", "-2", "3", "-2", "4",
                        "") "{translation: [0, 1, 0], rotation: [0.70710678, 0, 0, 0.70710678], "
                            "extensions: {KHR_lights_punctual: {light: 0}}}]",
             board);
    struct gltf_parts parts = {
        .materials = "[" MATERIAL("0.8") ", " MATERIAL("0.1") "]",
        .meshes = "[" MESH("0") ", " MESH("1") "]",
        .nodes = nodes,
        .more = "extensionsUsed: [KHR_lights_punctual], extensions: {KHR_lights_punctual: {lights: "
                "[{type: spot, intensity: 100, spot: {outerConeAngle: 0.7}}]}}, "};
    *stage = open_stage(write_parts("board.glb", &parts));
}

/* 0: upon the board; 1: upon the floor; -1: elsewhere. */
static int part_at(const float position[3]) {
    return position[1] > .2F ? -1 : position[0] > 0;
}

static void add_power(const float position[3], const float flux[3], double powers[2]) {
    int part = part_at(position);
    if (part >= 0)
        powers[part] += (double)(flux[0] + flux[1] + flux[2]);
}

/* What paths leave, before it is shared out. */
static void add_left(const struct bounce_pass *pass, double powers[2]) {
    for (int y = 0; y < BOUNCE_ROWS; y++) {
        struct row places = read_row(&pass->positions, y), fluxes = read_row(&pass->fluxes, y);
        for (int i = 0; i < pass->desc.count; i++)
            add_power(places.texels[i], fluxes.texels[i], powers);
        mem_free(places.texels, fluxes.texels);
    }
}

static void add_shared(const struct vpl_buffer *buffer, double powers[2]) {
    struct vpl *vpls = read_buffer(buffer);
    for (int i = 0; i < buffer->count; i++)
        add_power(vpls[i].position, vpls[i].flux, powers);
    free(vpls);
}

static void check_shared(const char *board) {
    enum { SETS = 8 };
    double left[2] = {0}, has[2] = {0};
    OWNED(stage) stage;
    open_board(&stage, board);
    for (int seed = 1; seed <= SETS; seed++) {
        OWNED(renderer) renderer;
        struct output_list outputs;
        const char *settings = form("bounces=2 paths=4096 seed=%d", seed);
        open_renderer(&renderer, desc_of(&stage, "unshadowed", settings, 32, 32));
        renderer_outputs(&renderer, &outputs);
        const struct bounce_pass *pass = bounce_pass_of(&outputs);
        add_left(pass, left);
        add_shared(&pass->vpls, has);
    }
    for (int part = 0; part < 2; part++)
        check_near(part ? "dark floor, of what paths leave" : "white board, of what paths leave",
                   has[part] / left[part], 1, .01);
}

/* Light is shared along a plane that is seen: what a white board has does not come to the dark
 * floor beside it, which is lower, or hidden by a wall. */
TEST(shared_along_planes) {
    check_shared(HIGH_BOARD);
    check_shared(BOARD_BEHIND_WALL);
}

/* What paths take for a triangle's colour, on both of its sides. */
TEST(albedos) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    uint32_t count = stage.geometry.index_count / 3;
    struct triangle_albedo *albedos = mem_alloc(count, sizeof *albedos);
    for (int sides = 1; sides <= 2; sides++) {
        for (int m = 0; m < stage.scene.material_count; m++)
            stage.scene.materials[m].double_sided = sides == 2;
        struct surface_colors colors = {
            .scene = &stage.scene, .geometry = &stage.geometry, .materials = MATERIALS_FULL};
        texture_decode_table(colors.srgb_to_linear);
        triangle_albedos_find(albedos, &colors);
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
}

/* --- what patches keep ------------------------------------------------------------------------ */

/* By Embree: whether light from one place to another arrives on the side that the camera sees of
 * it. */
static bool camera_sees(const struct rays *rays, const struct view *view, const float from[3],
                        const float to[3]) {
    vec4s clip =
        glms_mat4_mulv(*(const mat4s *)view->world_to_clip, (vec4s){{to[0], to[1], to[2], 1}});
    if (clip.w <= 0 || fabsf(clip.x) >= clip.w || fabsf(clip.y) >= clip.w)
        return false;
    vec3s eye = to_vec3s(view->origin), way = glms_vec3_sub(to_vec3s(to), eye);
    struct hit hit;
    return ray_scene_hit(&rays->scene, eye, vec3s_unit(way), &hit) &&
           glms_vec3_distance(hit.position, to_vec3s(to)) < 1e-3F * glms_vec3_norm(way) &&
           glms_vec3_dot(glms_vec3_sub(to_vec3s(from), to_vec3s(to)), hit.geometric_normal) > 0;
}

/* Paths count for what patches keep whose light goes to what the camera sees, and no others. */
TEST(seen) {
    struct rays rays;
    struct renderer renderer;
    struct output_list outputs;
    struct view view;
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    stage.camera.fov_y *= .6F;
    open_rays(&rays, &stage);
    open_renderer(&renderer, desc_of(&stage, "unshadowed", "bounces=3 paths=1024", 32, 32));
    renderer_outputs(&renderer, &outputs);
    const struct bounce_pass *pass = bounce_pass_of(&outputs);
    struct row places = read_row(&pass->positions, 0), nexts = read_row(&pass->nexts, 0),
               seen = read_row(&pass->seen, 0), kept = read_row(&pass->kept, 0);
    view_of_camera(&view, &stage.camera, &stage.geometry, 1);
    int arrive = 0, see = 0, differ = 0;
    double as_patch[2] = {0}, as_it_is[2] = {0}; /* of the seen, of all */
    for (int i = 0; i < pass->desc.count; i++) {
        const float *own = seen.texels[i];
        if (own[3] <= 0)
            continue;
        bool sees = camera_sees(&rays, &view, places.texels[i], nexts.texels[i]);
        arrive++;
        see += sees;
        differ += sees != (own[1] > 0);
        for (int k = 0; k < 2; k++) {
            as_patch[k] += (double)own[2 * k];
            as_it_is[k] += (double)own[2 * k + 1];
        }
    }
    double of_seen = as_patch[0] / as_it_is[0], of_all = as_patch[1] / as_it_is[1];
    printf("  the light of %d of %d paths is seen, %d otherwise by Embree\n", see, arrive, differ);
    printf("  kept of it %.4f, of all %.4f, taken %.4f\n", of_seen, of_all,
           (double)kept.texels[0][0]);
    assert_true(see > arrive / 8 && see < arrive * 7 / 8);
    check_at_most("share that differs", (double)differ / arrive, .005);
    /* Few paths say little: what is kept lies between them and 1. */
    assert_true((double)kept.texels[0][0] >= fmin(fmin(of_seen, of_all), 1) - 1e-4 &&
                (double)kept.texels[0][0] <= fmax(fmax(of_seen, of_all), 1) + 1e-4);
    mem_free(places.texels, nexts.texels, seen.texels, kept.texels);
    renderer_free(&renderer);
    close_rays(&rays);
}

/* --- starts by importance --------------------------------------------------------------------- */

struct powers {
    double sum, largest;
    int count;
};

static struct powers powers_of(const struct vpl_buffer *buffer) {
    struct powers powers = {.count = buffer->count};
    struct vpl *vpls = read_buffer(buffer);
    for (int i = 0; i < buffer->count; i++) {
        powers.sum += power(&vpls[i]);
        powers.largest = fmax(powers.largest, power(&vpls[i]));
    }
    free(vpls);
    return powers;
}

static double path_power(const struct bounce_pass *pass) {
    double sum = 0;
    for (int y = 0; y < BOUNCE_ROWS; y++) {
        struct row fluxes = read_row(&pass->fluxes, y);
        for (int i = 0; i < pass->desc.count; i++)
            sum += (double)(fluxes.texels[i][0] + fluxes.texels[i][1] + fluxes.texels[i][2]);
        free(fluxes.texels);
    }
    return sum;
}

/* Returns the powers of starts and of later VPLs, whose sum is that of paths; without importance
 * those of the first bounce's VPLs in place of starts. */
static void read_powers(struct stage *stage, const char *settings, struct powers *starts,
                        struct powers *later) {
    struct renderer renderer;
    struct output_list outputs;
    struct renderer_desc desc = desc_of(stage, "unshadowed", settings, 32, 32);
    open_renderer(&renderer, desc);
    renderer_outputs(&renderer, &outputs);
    const char *bounce = (const void *)bounce_pass_of(&outputs);
    const struct many_lights *lights =
        (const void *)(bounce - offsetof(struct many_lights, bounce));
    bool has_starts = lights->path_starts.vpls.count > 0;
    *starts = powers_of(has_starts ? &lights->path_starts.vpls : &lights->vpls);
    *later = powers_of(&lights->bounce.vpls);
    later->sum = path_power(&lights->bounce);
    renderer_free(&renderer);
}

/* Starts have the light of the first bounce, none more than twice an even share, and no VPL a large
 * share of later light. */
TEST(starts) {
    static const char *const paths[] = {"scenes/hall.glb", "scenes/door.glb", "scenes/window.glb"};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        struct powers even, even_later, starts, later;
        if (!is_tried_here(i, 3))
            continue;
        struct stage stage = open_stage(paths[i]);
        read_powers(&stage, "bounces=4 vpls=16384 importance=off", &even, &even_later);
        read_powers(&stage, "bounces=4 importance=on", &starts, &later);
        printf("  %s: %d starts\n", paths[i], starts.count);
        check_near("light of starts over that of VPLs by flux", starts.sum / even.sum, 1, .01);
        check_at_most("largest start over the largest even share",
                      starts.largest * starts.count / (even.largest * even.count), 2.001);
        check_at_most("largest share of one later VPL", later.largest / later.sum, .02);
        check_near("later light over that by flux", later.sum / even_later.sum, 1, .05);
        stage_free(&stage);
    }
}

/* --- frames ----------------------------------------------------------------------------------- */

/* One bounce is what it was whatever paths there would be; and a frame of several depends on its
 * own time alone. */
TEST(frames) {
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    struct image one = render_stage(&stage, "clustered", "", 48);
    struct image other = render_stage(&stage, "clustered", "bounces=1 paths=300", 48);
    assert_true(same_pixels(&one, &other));
    images_free(&one, &other);
    static const char *const techniques[] = {"clustered", "unshadowed"};
    for (int t = 0; t < (is_long_run() ? 2 : 1); t++) {
        OWNED(renderer) renderer;
        struct renderer_desc desc = desc_of(&stage, techniques[t], "bounces=3", 48, 48);
        struct emitter light = stage.emitters.items[0];
        OWNED(image) fresh = render_layers(&desc), again;
        open_renderer(&renderer, desc);
        stage.emitters.items[0].position[0] += .5F;
        check_ok("a light elsewhere", renderer_follow(&renderer, &desc));
        renderer_render(&renderer);
        stage.emitters.items[0] = light;
        check_ok("and back", renderer_follow(&renderer, &desc));
        renderer_render(&renderer);
        check_ok("layers", renderer_read_layers(&renderer, &again));
        assert_true(same_pixels(&fresh, &again));
    }
}

/* --- the reference ---------------------------------------------------------------------------- */

/* In the box two bounces lack a sixth of the light of eight, and one two fifths. */
TEST(reference) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(image) reference = TRACE(&stage, .width = 64, .height = 64, .bounces = 8, .samples = 16);
    double whole = layer_mean(&reference, "indirect");
    printf("  one bounce: %.3f of eight\n", mean_indirect(&stage, "clustered", "") / whole);
    check_near("clustered, over the reference",
               mean_indirect(&stage, "clustered", "bounces=8") / whole, 1, .045);
    check_near("instant radiosity", mean_indirect(&stage, "instant-radiosity", "bounces=8") / whole,
               1, .06);
}

RUN_TESTS(open_group_context, close_group_context)
