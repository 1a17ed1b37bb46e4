/* VALs by importance: they lie where the camera sees their light, in each view, and nothing else
 * changes. */
#include "render_support.h"

#include "base/halton.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

enum { PIXELS = 256, VALS = 30 };

/* --- where VALs lie --------------------------------------------------------------------------- */

/* What the camera sees, here and there. */
struct seen {
    vec3 positions[PIXELS], normals[PIXELS];
};

static void see(struct seen *seen, struct renderer *renderer) {
    OWNED(image) layers;
    check_ok("layers", renderer_read_layers(renderer, &layers));
    int channel = image_find_channel(&layers, "normal.X");
    for (int i = 0; i < PIXELS; i++) {
        int x = (int)(radical_inverse(2, (uint32_t)i) * layers.width);
        int y = (int)(radical_inverse(3, (uint32_t)i) * layers.height);
        pixel_position(renderer, &layers, x, y, seen->positions[i]);
        glm_vec3_copy((float *)image_at(&layers, x, y) + channel, seen->normals[i]);
    }
}

/* What a VPL gives to these pixels where nothing is between. */
static double importance(const struct seen *seen, const struct vpl *vpl) {
    double sum = 0;
    for (int i = 0; i < PIXELS; i++) {
        vec3 to;
        glm_vec3_sub((float *)vpl->position, (float *)seen->positions[i], to);
        double d2 = (double)glm_vec3_norm2(to);
        double cosines = fmax((double)glm_vec3_dot((float *)seen->normals[i], to), 0) *
                         fmax(-(double)glm_vec3_dot((float *)vpl->normal, to), 0);
        sum += cosines / (d2 * (d2 + (double)vpl->area / GLM_PI));
    }
    return sum * (double)(vpl->flux[0] + vpl->flux[1] + vpl->flux[2]);
}

/* How far VPLs are from the middle of their VAL's, metres, as much as each matters to
 * the picture. */
static double spread(struct renderer *renderer) {
    struct seen seen;
    struct vpl *vpls = read_vpls(renderer);
    double middles[VALS][4] = {{0}}, sum = 0, all = 0;
    int count = (int)settings_number(&renderer->desc.settings, "vpls");
    double *weights = mem_alloc((size_t)count, sizeof *weights);
    see(&seen, renderer);
    for (int i = 0; i < count; i++) {
        weights[i] = vpls[i].reach > 0 ? importance(&seen, &vpls[i]) : 0;
        double *middle = middles[(int)vpls[i].val];
        for (int c = 0; c < 3; c++)
            middle[c] += weights[i] * (double)vpls[i].position[c];
        middle[3] += weights[i];
    }
    for (int i = 0; i < count; i++) {
        const double *middle = middles[(int)vpls[i].val];
        double apart2 = 0;
        for (int c = 0; c < 3; c++)
            apart2 += pow((double)vpls[i].position[c] - middle[c] / fmax(middle[3], 1e-30), 2);
        sum += weights[i] * sqrt(apart2);
        all += weights[i];
    }
    mem_free(weights, vpls);
    return sum / all;
}

static double spread_of(const struct stage *stage, const char *settings) {
    struct renderer renderer;
    open_renderer(&renderer, desc_of(stage, "clustered", settings, 64, 64));
    double metres = spread(&renderer);
    renderer_free(&renderer);
    printf("    %-24s VPLs are %.3f m from the middle of their VAL's\n", settings, metres);
    return metres;
}

TEST(places) {
    OWNED(stage) stage = open_stage("scenes/atrium.glb");
    double alike = spread_of(&stage, "path=maps vpls=1024 bounces=2 importance=off"),
           counted = spread_of(&stage, "path=maps vpls=1024 bounces=2");
    check_at_most("by importance, over where all count alike", counted / alike, .985);
}

/* --- frames ----------------------------------------------------------------------------------- */

static bool same_frames(const struct stage *stage, const char *a, const char *b) {
    OWNED(image) of_a = render_stage(stage, "clustered", a, 48),
                 of_b = render_stage(stage, "clustered", b, 48);
    bool same = same_pixels(&of_a, &of_b);
    return same;
}

/* One bounce is what it was; where rays tell all that arrives nobody asks where VALs lie. */
TEST(one_bounce) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    assert_true(same_frames(&stage, "", "importance=off"));
    assert_false(same_frames(&stage, "bounces=2 path=maps", "bounces=2 path=maps importance=off"));
    assert_true(
        same_frames(&stage, "bounces=2 path=traced", "bounces=2 path=traced importance=off"));
}

/* Lights that are kept while the camera moves are no others' than those of a frame that begins
 * there. */
TEST(kept_lights) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    OWNED(image) again;
    struct renderer_desc desc = desc_of(&stage, "clustered", "bounces=2", 48, 48);
    struct camera there = desc.camera;
    desc.keep_lights = true;
    OWNED(image) fresh = render_layers(&desc);
    desc.camera.eye[0] += .4F;
    open_renderer(&renderer, desc);
    desc.camera = there;
    check_ok("a camera elsewhere", renderer_follow(&renderer, &desc));
    renderer_render(&renderer);
    check_ok("layers", renderer_read_layers(&renderer, &again));
    assert_true(same_pixels(&fresh, &again));
}

RUN_TESTS(open_group_context, close_group_context)
