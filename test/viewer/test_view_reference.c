/* The reference traced in the window, and the table of speed against accuracy: what they tell is
 * what the path tracer and the renderer tell by themselves. */
#include "view_inside.h"

#include "render_support.h"

#include "metrics/layer.h"
#include "viewer/reference/tracing.h"
#include "viewer/scene/sessions.h"

#define SCENE "scenes/cornell-box.glb"

static void begin(void) {
    begin_viewer(&(struct viewer_desc){.scene = SCENE, .width = 96, .height = 96});
}

/* Against many samples of another seed. */
TEST(trace) {
    begin();
    viewer_trace(&viewer);
    turn_until(viewer.tracing.samples >= 8 || !viewer_is_tracing(&viewer));
    const struct image *traced = &viewer.shown.compare.reference.picture;
    OWNED(stage) scene = open_stage(SCENE);
    OWNED(image) other = TRACE(&scene, .width = traced->width, .height = traced->height,
                               .bounces = 1, .samples = 64, .seed = 7);
    double apart = relative_rmse(traced, &other, "indirect");
    printf("    after %d samples, which tell %.3f of noise\n", viewer.tracing.samples,
           viewer.tracing.noise);
    assert_int_equal(viewer.shown.compare.mode, COMPARE_REFERENCE);
    check_at_most("of the reference of many samples", apart, 2 * viewer.tracing.noise);
    assert_true(viewer.shown.right);
}

/* Root of the mean square over the mean, of all pixels. */
static double error_by_hand(const struct image *test, const struct image *reference) {
    int a[3], b[3];
    double squares = 0, sum = 0;
    size_t pixels = (size_t)test->width * (size_t)test->height;
    assert_true(image_find_layer(test, "indirect", a) &&
                image_find_layer(reference, "indirect", b));
    for (size_t i = 0; i < pixels; i++)
        for (int c = 0; c < 3; c++) {
            double t =
                (double)reference->pixels[i * (size_t)reference->channel_count + (size_t)b[c]];
            double v = (double)test->pixels[i * (size_t)test->channel_count + (size_t)a[c]];
            squares += (v - t) * (v - t);
            sum += t;
        }
    return sqrt(squares / (3 * (double)pixels)) / (sum / (3 * (double)pixels));
}

/* The error that is shown, by hand. */
TEST(error) {
    need_server();
    turn_until(!viewer_is_tracing(&viewer) || viewer.tracing.samples >= 32);
    reference_tracer_pause(&viewer.tracing.tracer, true);
    rest();
    struct image frame = {0};
    check_ok("layers", renderer_read_layers(&viewer.shown.renderer, &frame));
    double with_noise = error_by_hand(&frame, &viewer.shown.compare.reference.picture);
    double noise = viewer.tracing.noise;
    assert_true(viewer.tracing.has_error);
    check_near("error of indirect light", viewer.tracing.error,
               sqrt(with_noise * with_noise - noise * noise), .002);
    image_free(&frame);
    reference_tracer_pause(&viewer.tracing.tracer, false);
}

/* Another view ends the tracing; taken back, it is the traced one again. */
TEST(other_view) {
    need_server();
    rest();
    assert_true(viewer.tracing.of_view);
    orbit_turn(&viewer.placed.orbit, .1F, 0);
    viewer.placed.camera_moved = true;
    viewer_touch(&viewer);
    rest();
    assert_false(viewer.tracing.of_view);
    assert_false(viewer.tracing.has_error);
    assert_false(viewer_is_tracing(&viewer));
    viewer_undo(&viewer, -1);
    rest();
    assert_true(viewer.tracing.of_view);
    assert_true(viewer.tracing.has_error);
}

TEST(table) {
    need_server();
    viewer_measure(&viewer);
    turn_until(!viewer_is_measuring(&viewer));
    rest();
    const struct method_table *table = &viewer.tracing.table;
    for (int i = 0; i < table->count; i++) {
        const struct method_row *row = &table->rows[i];
        printf("    %-20s %8.1f ms, error %.3f\n", row->name, row->ms, row->error);
        assert_int_equal(row->state, ROW_MEASURED);
        assert_true(row->has_error && row->ms > 0);
        assert_true(row->error < .6);
    }
    assert_string_equal(table->rows[table->count - 1].name, "as it is");
    check_near("as it is, and as it is shown", table->rows[table->count - 1].error,
               viewer.tracing.error, .001);
    int cheapest = method_table_cheapest(table, .2);
    assert_true(cheapest >= 0);
    for (int i = 0; i < table->count; i++)
        assert_true(table->rows[i].error >= .2 || table->rows[i].ms >= table->rows[cheapest].ms);
}

/* What a click on a row makes is what the row measured, bit for bit. */
TEST(take) {
    need_server();
    OWNED(image) frame = {0}, indirect;
    viewer_take_row(&viewer, 0);
    rest();
    check_ok("layers", renderer_read_layers(&viewer.shown.renderer, &frame));
    check_ok("indirect", layer_extract(&indirect, &frame, "indirect"));
    assert_true(same_pixels(&indirect, &viewer.tracing.table.rows[0].indirect));
}

/* In the midst of all of it. */
TEST(end) {
    need_server();
    viewer_forget_reference(&viewer);
    rest();
    viewer_measure(&viewer);
    for (int i = 0; i < 4; i++)
        turn();
    finish_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
