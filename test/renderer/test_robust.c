/* Every scene, every technique, the ends of every option: finite numbers, no word from OpenGL,
 * nothing left in memory. */
#include "render_support.h"

#include <unistd.h>

/* A stage, and the renderer that follows from one picture of it to the next. */
struct scene_view {
    struct stage stage;
    struct renderer renderer;
};

static void open_view(struct scene_view *view, const char *path) {
    view->renderer = (struct renderer){0};
    view->stage = open_stage(path);
}

static void close_view(struct scene_view *view) {
    renderer_free(&view->renderer);
    stage_free(&view->stage);
}

/* Finite in all channels. */
static void check_picture(const char *what, struct scene_view *view, const char *technique,
                          const char *settings, int width, int height) {
    struct renderer_desc desc = desc_of(&view->stage, technique, settings, width, height);
    struct image image = follow_layers(&view->renderer, &desc);
    printf("  %s %s %dx%d %s\n", what, technique, width, height, settings);
    check_finite(what, &image);
    assert_int_equal(image.width, width);
    assert_int_equal(image.height, height);
    image_free(&image);
}

/* --- scenes ----------------------------------------------------------------------------------- */

/* A map per VPL of a hundred thousand faces costs: few VPLs will do. */
static void check_scene(const char *path, int size) {
    struct scene_view view;
    open_view(&view, path);
    check_picture(path, &view, "clustered", "vpls=256 vals=12 map-size=128", size, size);
    check_picture(path, &view, "clustered", "path=paper vpls=256 vals=6 map-size=64", size, size);
    check_picture(path, &view, "instant-radiosity", "vpls=8 map-size=128 interleave=2", size, size);
    check_picture(path, &view, "unshadowed", "", size, size);
    struct renderer_desc desc = desc_of(&view.stage, "clustered", "vals=8 map-size=64", size, size);
    struct image image = follow_layers(&view.renderer, &desc);
    assert_true(layer_mean(&image, "direct") > 0);
    assert_true(layer_mean(&image, "indirect") > 0);
    image_free(&image);
    close_view(&view);
}

TEST(own_scenes) {
    static const char *const names[] = {"cornell-box", "cornell-animal", "sphere", "metaballs",
                                        "atrium"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const char *path = form("scenes/%s.glb", names[i]);
        if (is_tried_here(i, 4))
            check_scene(path, 100);
    }
}

TEST(shared_scenes) {
    static const char *const names[] = {"cornell-box", "cornell-horse", "sponza-98k", "sponza"};
    if (!shared_path())
        skip();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const char *path = form("%s/scenes/%s.glb", shared_path(), names[i]);
        if (is_tried_here(i, 2) && access(path, R_OK) == 0)
            check_scene(path, 100);
    }
}

/* --- options ---------------------------------------------------------------------------------- */

/* Small maps and few lights, so that what is extreme is one thing at a time. */
#define SMALL "vpls=64 vals=4 map-size=64 rsm-size=64 shadow-size=256 interleave=2 "

TEST(extremes) {
    static const char *const settings[] = {
        "vpls=1 vals=1 interleave=1",
        SMALL "vals=1",
        SMALL "vals=64",
        SMALL "vals=100",
        SMALL "vpls=256 interleave=16",
        SMALL "vpls=257 interleave=16 blur-radius=64",
        SMALL "interleave=8 blur-radius=0",
        SMALL "interleave=7 vpls=50",
        SMALL "vpls=65536 interleave=16 vals=1024 map-size=16 iterations=1",
        SMALL "visibility=cssm terms=1",
        SMALL "visibility=cssm terms=5",
        SMALL "visibility=cssm terms=16",
        SMALL "map-size=16 terms=16 rsm-size=16 shadow-size=16",
        SMALL "visibility=hard map-size=16",
        SMALL "clamp=none",
        SMALL "clamp=value",
        SMALL "clamp=disk",
        SMALL "clamp=near near-samples=1",
        SMALL "clamp=near near-samples=1024 interleave=1",
        SMALL "weight-position=0 weight-normal=0",
        SMALL "weight-position=1000 weight-normal=0 iterations=64",
        SMALL "blur-distance=0",
        SMALL "blur-distance=10 blur-cosine=-1",
        SMALL "blur-cosine=1",
        SMALL "caster-long=0",
        SMALL "caster-long=100000",
        SMALL "path=paper",
        SMALL "path=paper terms=16 interleave=1",
        SMALL "visibility=pcss visibility-block=64",
        SMALL "visibility-block=1 vals=64",
        SMALL "caster-error=0",
        SMALL "caster-error=1",
        SMALL "blur-separable=off blur-radius=16",
        SMALL "start=warm",
        SMALL "start=reseed vals=64",
        SMALL "exposure=-32 tone-map=filmic",
        SMALL "exposure=32 tone-map=filmic seed=1000000000",
    };
    struct scene_view view;
    open_view(&view, "scenes/cornell-box.glb");
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        if (is_tried_here(i, 3))
            check_picture("", &view, "clustered", settings[i], 40, 40);
        /* All that maps of VPLs do differently; not 65536 of them. */
        if (is_tried_here(i + 1, 6) && strstr(settings[i], "65536") == NULL)
            check_picture("", &view, "instant-radiosity", settings[i], 40, 40);
    }
    close_view(&view);
}

TEST(sizes) {
    static const int sizes[][2] = {{1, 1}, {2, 1}, {1, 7}, {16, 400}, {400, 16}, {9, 9}, {17, 31}};
    struct scene_view view;
    open_view(&view, "scenes/cornell-box.glb");
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (size_t t = 0; techniques[t]; t++)
            if (is_tried_here(i + t, 4))
                check_picture("", &view, techniques[t]->name,
                              "vpls=64 vals=8 map-size=64 interleave=8", sizes[i][0], sizes[i][1]);
    close_view(&view);
}

/* --- scale ------------------------------------------------------------------------------------ */

/* What rounding of other numbers does to shadows' edges; and to surface elements, of which ties
 * decide some, and to the partner in each of their bins. */
static double rounding_of(const struct technique *technique) {
    return strcmp(technique->name, "implicit-visibility") == 0 ? .015 : .002;
}

TEST(scale) {
    const int rgb[] = {0, 1, 2};
    static const float scales[] = {1e-3f, 1e4f};
    int size = is_long_run() ? 64 : 32;
    for (const struct technique *const *t = techniques; *t; t++) {
        const char *settings = strcmp((*t)->name, "instant-radiosity") == 0
                                   ? "vpls=32 map-size=64 interleave=1"
                                   : "vpls=256 vals=8 map-size=64 interleave=4";
        struct stage stage = open_stage("scenes/cornell-box.glb");
        struct image plain = render_stage(&stage, (*t)->name, settings, size);
        stage_free(&stage);
        for (size_t i = 0; i < 2; i++) {
            if (!is_tried_here(i + (size_t)(t - techniques), 2))
                continue;
            stage = open_stage("scenes/cornell-box.glb");
            scale_scene(&stage.scene, scales[i]);
            pose_stage(&stage);
            OWNED(image) scaled = render_stage(&stage, (*t)->name, settings, size);
            printf("  %s times %g\n", (*t)->name, (double)scales[i]);
            check_finite("scaled", &scaled);
            check_at_most("the scene at another scale, relative RMSE",
                          relative_rmse(&scaled, &plain, ""), rounding_of(*t));
            check_near("mean", image_mean(&scaled, rgb) / image_mean(&plain, rgb), 1,
                       rounding_of(*t) / 2);
            stage_free(&stage);
        }
        image_free(&plain);
    }
}

/* --- light ------------------------------------------------------------------------------------ */

/* A light that is off, dim, bright, and one that meets nothing. */
TEST(odd_lights) {
    static const float intensities[] = {0, 1e-20f, 1e15f};
    for (int i = 0; i < 4; i++) {
        struct scene_view view;
        open_view(&view, "scenes/cornell-box.glb");
        for (int c = 0; c < 3 && i < 3; c++)
            view.stage.emitters.items[0].intensity[c] = intensities[i];
        if (i == 3)
            view.stage.emitters.items[0].position[1] =
                1e3f; /* far above the ceiling, which has its back to it */
        for (size_t t = 0; techniques[t]; t++)
            if (is_tried_here((size_t)i + t, 2))
                check_picture(i == 3 ? "light outside" : "intensity", &view, techniques[t]->name,
                              "vpls=64 vals=8 map-size=64 interleave=4", 40, 40);
        close_view(&view);
    }
}

RUN_TESTS(open_group_context, close_group_context)
