/* The failure suite in small: every row with every technique within what it promises. */
#include "render_support.h"

#include "apps/failures.h"
#include "base/error.h"

#include <stdio.h>

/* Fewer lights, smaller maps and pictures: rows are up to so many times worse than promised. The
 * frame's blur and blocks cover a good part of so small a picture. */
static double slack_of(int technique) {
    return technique == FAILURE_FRAME ? 5 : 3;
}

static struct bench_values small_values(void) {
    static const char *const settings[] = {"vpls=256", "map-size=128", "shadow-size=512",
                                           "rsm-size=128", "near-samples=256"};
    struct bench_values values = {.size = {40, 30}, .noise = .05F, .cache = scratch("references")};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++)
        values.settings.items[values.settings.count++] = settings[i];
    return values;
}

static void check_row(const struct failure_row *row, const struct bench_values *values,
                      const struct context *context) {
    struct failure_result results[FAILURE_TECHNIQUES];
    check_ok(row->name, failure_measure(row, values, context, results));
    for (int t = 0; t < FAILURE_TECHNIQUES; t++) {
        printf("    %-18s %-40.40s %6.2f %% of %5.1f %%\n", row->name, failure_techniques[t],
               100 * results[t].relative_rmse, slack_of(t) * row->bounds[t]);
        if (!failure_holds(row, t, &results[t], slack_of(t)))
            fail_msg("%s: %d values not finite, %d messages, or an error above the bound",
                     row->name, results[t].non_finite, results[t].messages);
    }
}

static void test_rows(void **state) {
    struct bench_values values = small_values();
    for (int i = 0; i < failure_row_count; i++)
        check_row(&failure_rows[i], &values, *state);
}

/* A row that is not there is named with those that are. */
static void test_names(void **state) {
    (void)state;
    assert_null(failure_row_find("no-such-row"));
    printf("    %s\n", error_get());
    assert_non_null(failure_row_find("closed-door"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rows), cmocka_unit_test(test_names)};
    return cmocka_run_group_tests_name("failures", tests, open_group_context, close_group_context);
}
