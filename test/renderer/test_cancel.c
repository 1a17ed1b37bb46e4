/* Frames that end early: no further draw once the frame is not wanted, and no trace in later
 * frames. */
#include "render_support.h"

#include "gl/cancel.h"
#include "techniques/technique.h"

struct count {
    int asked, wanted; /* the question that is answered by yes */
};

static bool answer(void *user) {
    struct count *count = user;
    return ++count->asked >= count->wanted;
}

static bool render_until(struct renderer *renderer, int wanted, int *asked) {
    struct count count = {0, wanted};
    cancel_begin(answer, &count, 0);
    renderer_render(renderer);
    bool cancelled = cancel_end();
    *asked = count.asked;
    if (cancelled)
        renderer_forget_frame(renderer);
    return cancelled;
}

static struct image read_frame(struct renderer *renderer) {
    struct image image;
    renderer_render(renderer);
    check_ok("layers", renderer_read_layers(renderer, &image));
    return image;
}

/* Cancels one frame after another, the first of all too, at later and later draws, then lets one be
 * drawn. */
static void check_technique(const struct stage *stage, const char *name, bool keeps) {
    OWNED(renderer) renderer;
    struct renderer_desc desc = desc_of(stage, name, "vpls=64", 24, 24);
    int asked = 0, all;
    desc.keep_lights = keeps;
    OWNED(image) expected = render_layers(&desc);
    open_renderer(&renderer, desc);
    assert_true(render_until(&renderer, 2, &asked));
    assert_false(render_until(&renderer, 1 << 20, &all));
    renderer_forget_frame(&renderer);
    assert_false(render_until(&renderer, 1 << 20, &all));
    printf("    %s%s: %d questions\n", name, keeps ? ", kept lights" : "", all);
    assert_true(all >= 4);
    for (int at = 1; at < all; at += 1 + all / (is_long_run() ? 40 : 3)) {
        assert_true(render_until(&renderer, at, &asked));
        assert_int_equal(asked, at);
    }
    OWNED(image) after = read_frame(&renderer);
    assert_true(same_pixels(&expected, &after));
}

TEST(cancelled_frames) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    for (size_t i = 0; techniques[i]; i++)
        if (is_tried_here(i, 5) || strcmp(techniques[i]->name, "implicit-visibility") == 0)
            check_technique(&stage, techniques[i]->name, i % 2);
}

/* A watch that nobody cancels changes no bit. */
TEST(watched_frame) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    int asked;
    open_renderer(&renderer, desc_of(&stage, "instant-radiosity", "vpls=64", 24, 24));
    OWNED(image) expected = read_frame(&renderer), watched;
    assert_false(render_until(&renderer, 1 << 20, &asked));
    check_ok("layers", renderer_read_layers(&renderer, &watched));
    assert_true(same_pixels(&expected, &watched));
}

RUN_TESTS(open_group_context, close_group_context)
