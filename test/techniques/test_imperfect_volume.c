/* Ambient occlusion of volumes against closed forms, and the exact answers of its parts. */
#include "volume_scenes.h"

/* --- ambient occlusion ------------------------------------------------------------------------ */

enum { SIZE = 96 };

static void print_spread(const char *what, const struct spread *spread) {
    printf("  %s: %.3f to %.3f, mean %.3f, RMSE %.4f, %d of %d unknown\n", what, spread->least,
           spread->most, spread->mean, spread->rmse, spread->unknown, spread->count);
}

/* Closed forms hold far from the ends of what is not endless. */
struct truth {
    float reach;  /* metres */
    float half;   /* of the sides, metres */
    vec3s across; /* away from the wall */
    double share; /* of a bowl's sphere */
    float bottom; /* of what is looked at of a bowl */
    float margin; /* from a wall, where closed forms are compared from, m */
};

static double plane_truth(const float place[3], void *context) {
    (void)place;
    (void)context;
    return 1;
}

static double check_plane(float angle, const char *settings) {
    OWNED(stage) stage;
    struct seen seen;
    struct shape *shape = new_shape();
    vec3s axis = vec3s_unit(at(1, .3F, .7F));
    vec3s up = glms_vec3_rotate(at(0, 1, 0), angle, axis),
          side = glms_vec3_rotate(at(0, 0, 1), angle, axis);
    add_rectangle(shape, at(-2, 0, 2), at(4, 0, 0), at(0, 0, -4));
    turn_shape(shape, angle, axis);
    open_shape(&stage, shape, .5, false, at(0, 3, 0));
    look(&stage, at(0, 0, 0), glms_vec3_negate(up), side, 2);
    see_occlusion(&seen, &stage, settings, SIZE);
    struct spread spread = spread_about(&seen, plane_truth, NULL);
    print_spread(angle > 0 ? "tilted plane" : "plane", &spread);
    free_seen(&seen);
    return spread.rmse;
}

TEST(plane) {
    check_at_most("RMSE of a plane", check_plane(0, "order=2"), .03);
    check_at_most("RMSE of a plane", check_plane(0, "order=3"), .03);
    check_at_most("RMSE of a tilted plane", check_plane(.5F, "order=2"), .03);
    check_at_most("RMSE of a tilted plane", check_plane(1, "order=3"), .03);
}

static double corner_truth(const float place[3], void *context) {
    const struct truth *truth = context;
    double x = (double)glms_vec3_dot(to_vec3s(place), truth->across);
    double u = x / (double)truth->reach;
    if (x < (double)truth->margin || u > 1)
        return NAN;
    return 1 - (acos(u) - u * sqrt(1 - u * u)) / GLM_PI;
}

static double check_corner(float angle, const char *settings) {
    OWNED(stage) stage;
    struct seen seen;
    struct truth truth = {.across = at(1, 0, 0)};
    struct shape *shape = new_shape();
    vec3s axis = vec3s_unit(at(.2F, 1, .1F));
    add_rectangle(shape, at(0, 0, 2), at(4, 0, 0), at(0, 0, -4));
    add_rectangle(shape, at(0, 0, 2), at(0, 0, -4), at(0, 2, 0));
    turn_shape(shape, angle, axis);
    truth.across = glms_vec3_rotate(truth.across, angle, axis);
    open_shape(&stage, shape, .5, false, at(1, 3, 0));
    vec3s down = glms_vec3_rotate(at(0, -1, 0), angle, axis);
    look(&stage, glms_vec3_scale(truth.across, .75F), down,
         glms_vec3_rotate(at(0, 0, 1), angle, axis), 1.5F);
    see_occlusion(&seen, &stage, settings, SIZE);
    struct volume_settings own =
        *settings_of(struct volume_settings, &seen.renderer.desc.settings, &volume_part);
    truth.reach = volume_ao_distance(&seen.renderer.desc.settings, &stage.geometry);
    truth.margin = 3 * truth.reach / 16;
    (void)own;
    struct spread spread = spread_about(&seen, corner_truth, &truth);
    print_spread("corner", &spread);
    free_seen(&seen);
    return spread.rmse;
}

TEST(corner) {
    check_at_most("RMSE of a corner", check_corner(0, "order=2"), .05);
    check_at_most("RMSE of a corner", check_corner(0, "order=3"), .05);
    check_at_most("RMSE of a turned corner", check_corner(.5F, "order=2"), .05);
    check_at_most("RMSE of a turned corner", check_corner(.5F, "order=3"), .05);
}

/* Away from the rim. */
static double bowl_truth(const float place[3], void *context) {
    const struct truth *truth = context;
    return place[1] < truth->bottom ? 1 - truth->share : NAN;
}

/* Rays go as far as there is bowl. */
static double check_bowl(double height, const char *settings) {
    OWNED(stage) stage;
    struct seen seen;
    struct shape *shape = new_shape();
    struct truth truth = {.share = (1 + height) / 2, .bottom = (float)height - .15F};
    add_bowl(shape, height);
    open_shape(&stage, shape, .5, false, at(0, 3, 0));
    look(&stage, at(0, 0, 0), at(0, -1, 0), at(0, 0, 1), 2);
    see_occlusion(&seen, &stage, settings, SIZE);
    struct spread spread = spread_about(&seen, bowl_truth, &truth);
    print_spread("bowl", &spread);
    check_near("mean of a bowl", spread.mean, 1 - truth.share, .08);
    free_seen(&seen);
    return spread.rmse;
}

TEST(bowl) {
    check_at_most("RMSE of a hemisphere", check_bowl(0, "order=2 ao-distance=9"), .08);
    check_at_most("RMSE of a hemisphere", check_bowl(0, "order=3 ao-distance=9"), .08);
    check_at_most("RMSE of a shallow bowl", check_bowl(-.5, "order=3 ao-distance=9"), .08);
}

RUN_TESTS(open_group_context, close_group_context)
