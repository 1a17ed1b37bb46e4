/* Ambient occlusion of a frame: the same of every technique, beside traced rays, and only for who
 * asks. */
#include "render_support.h"

#include "inspect/aov.h"
#include "techniques/volume.h"

enum { SIZE = 64 };

static const char small[] = "vpls=64 map-size=32 rsm-size=64 shadow-size=128 interleave=4";

/* The frame's layers with ao, which aov_append puts last. */
static struct image layers_with_ao(struct renderer *renderer) {
    struct image image;
    check_ok("layers", renderer_read_layers(renderer, &image));
    check_ok("ao", aov_append(renderer, "ao", NULL, &image));
    assert_string_equal(image.names[image.channel_count - 1], "ao.Y");
    return image;
}

static float ao_at(const struct image *image, int i) {
    return image->pixels[(size_t)(i + 1) * (size_t)image->channel_count - 1];
}

static double worst_difference(const struct image *a, const struct image *b) {
    double worst = 0;
    for (int i = 0; i < a->width * a->height; i++)
        worst = fmax(worst, fabs((double)ao_at(a, i) - (double)ao_at(b, i)));
    return worst;
}

/* The frame does not see that it is asked, before or after; and what it says is no technique's. */
TEST(every_technique) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(image) first = {0};
    for (const struct technique *const *t = techniques; *t; t++) {
        OWNED(renderer) renderer;
        open_renderer(&renderer, desc_of(&stage, (*t)->name, small, SIZE, SIZE));
        struct image before, with, after;
        check_ok("layers", renderer_read_layers(&renderer, &before));
        assert_null(renderer.ambient_occlusion);
        with = layers_with_ao(&renderer);
        renderer_render(&renderer);
        check_ok("layers", renderer_read_layers(&renderer, &after));
        assert_true(same_pixels(&before, &after));
        if (first.pixels)
            check_near((*t)->name, worst_difference(&with, &first), 0, 0);
        images_free(&before, &after, first.pixels ? &with : &(struct image){0});
        first = first.pixels ? first : with;
    }
}

static struct image trace(const struct stage *stage, float distance) {
    return TRACE(stage, .width = SIZE, .height = SIZE, .samples = 64, .ao_distance = distance,
                 .ao_alone = true);
}

/* With all samples of a pixel, and 0 beside the box. */
TEST(traced) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct renderer_desc desc = desc_of(&stage, "unshadowed", "vpls=64 samples=12", SIZE, SIZE);
    open_renderer(&renderer, desc);
    OWNED(image) drawn = layers_with_ao(&renderer);
    OWNED(image) traced = trace(&stage, volume_ao_distance(&desc.settings, &stage.geometry));
    int ao = image_find_channel(&traced, "ao.Y"), covered = 0;
    double squares = 0, sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        const float *pixel = image_at(&traced, i % SIZE, i / SIZE);
        double off = (double)ao_at(&drawn, i) - (double)pixel[ao];
        if (!(pixel[3] > 0 && image_at(&drawn, i % SIZE, i / SIZE)[3] > 0))
            continue;
        covered++;
        squares += off * off;
        sum += off;
    }
    check_at_most("RMSE", sqrt(squares / covered), .06);
    check_near("bias", sum / covered, 0, .04);
    check_near("outside", (double)ao_at(&drawn, 0), 0, 0);
}

/* After a change it is what a new renderer has. */
static void check_as_fresh(const char *what, struct renderer *renderer,
                           const struct renderer_desc *desc, const struct image *before) {
    struct renderer fresh;
    check_ok(what, renderer_follow(renderer, desc));
    renderer_render(renderer);
    open_renderer(&fresh, *desc);
    struct image changed = layers_with_ao(renderer), expected = layers_with_ao(&fresh);
    printf("  %s\n", what);
    check_near("less a new renderer's", worst_difference(&changed, &expected), 0, 0);
    if (before->width == changed.width)
        assert_true(worst_difference(&changed, before) > .01);
    images_free(&changed, &expected);
    renderer_free(&fresh);
}

TEST(changes) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct renderer_desc desc = desc_of(&stage, "unshadowed", small, SIZE, SIZE);
    open_renderer(&renderer, desc);
    OWNED(image) before = layers_with_ao(&renderer);
    desc.camera.eye[0] += .2F;
    check_as_fresh("another camera", &renderer, &desc, &before);
    check_ok("setting", settings_assign(&desc.settings, "volume.ao-distance=.1"));
    check_as_fresh("a shorter distance", &renderer, &desc, &before);
    check_ok("setting", settings_assign(&desc.settings, "volume.size=24"));
    check_as_fresh("fewer voxels", &renderer, &desc, &before);
    desc.width = SIZE / 2;
    check_as_fresh("another size", &renderer, &desc, &before);
}

/* Points move with their triangles. */
TEST(poses) {
    OWNED(stage) stage = open_stage("scenes/door.glb");
    OWNED(renderer) moved, fresh;
    struct renderer_desc desc = desc_of(&stage, "unshadowed", small, SIZE, SIZE);
    open_renderer(&moved, desc);
    OWNED(image) before = layers_with_ao(&moved);
    check_ok("pose", stage_pose(&stage, 2) && stage_show(&stage, &moved));
    renderer_render(&moved);
    desc =
        desc_of(&stage, "unshadowed", small, SIZE, SIZE); /* the lights are elsewhere in memory */
    open_renderer(&fresh, desc);
    OWNED(image) after = layers_with_ao(&moved), expected = layers_with_ao(&fresh);
    check_near("less a new renderer's", worst_difference(&after, &expected), 0, 0);
    assert_true(worst_difference(&after, &before) > .01);
}

/* The open share in the middle of the picture. */
static float shown_ao(struct renderer *renderer) {
    float texel[4];
    const struct texture *texture = &renderer_ambient_occlusion(renderer)->texture;
    assert_non_null(texture);
    gl.GetTextureSubImage(texture->id, 0, SIZE / 2, SIZE / 2, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                          sizeof texel, texel);
    return texel[0];
}

/* A texture of another value shows whether it is drawn again. */
static void mark(const struct texture *texture) {
    gl.ClearTexImage(texture->id, 0, GL_RGBA, GL_FLOAT, (const float[4]){.25F, .25F, .25F, 1});
}

/* It is drawn once of each frame, and rays are traced once of each pose. */
TEST(kept) {
    OWNED(stage) stage = open_stage("scenes/door.glb");
    OWNED(renderer) renderer;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", small, SIZE, SIZE));
    double drawn = (double)shown_ao(&renderer);
    mark(&renderer_ambient_occlusion(&renderer)->texture);
    check_near("asked again", (double)shown_ao(&renderer), .25, 0);
    renderer_render(&renderer);
    check_near("another frame", (double)shown_ao(&renderer), drawn, 0);
    const struct volume *volume = &renderer.ambient_occlusion->light.volume;
    gl.ClearTexImage(volume->coefficients[0].id, 0, GL_RGBA, GL_FLOAT, (const float[4]){0});
    renderer_render(&renderer);
    assert_true(fabs((double)shown_ao(&renderer) - drawn) > .01);
    check_ok("pose", stage_pose(&stage, 0) && stage_show(&stage, &renderer));
    renderer_render(&renderer);
    check_near("posed", (double)shown_ao(&renderer), drawn, 0);
}

/* Before a frame is drawn. */
TEST(refusal) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct renderer_desc desc = desc_of(&stage, "unshadowed", small, SIZE, SIZE);
    check_ok("setting", settings_assign(&desc.settings, "volume.size=2000"));
    open_renderer(&renderer, desc);
    check_refused(aov_check(&renderer, "ao"), "volume.size 2000: up to ");
}

RUN_TESTS(open_group_context, close_group_context)
