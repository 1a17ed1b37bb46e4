/* manylight report: a page that is whole in itself, with the errors that bench measures. */
#include "command_support.h"

#include "base/file/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define REPORT                                                                                     \
    "% report scenes/cornell-box.glb --size 64x48 --variant fast --variant \"a<b:technique="       \
    "unshadowed\" --frames 1 --noise 20% --cache @/cache -q -o @/"

static void test_page(void **state) {
    (void)state;
    static const char *const tags[] = {"figure", "div", "table", "details", "svg", "dl", "h2"};
    expect(0, REPORT "page.html --max-error 20%");
    char *page = file_read_text(scratch("page.html"));
    assert_non_null(page);
    assert_int_equal(count_text(page, "src=\"data:image/png;base64,"), 5);
    assert_int_equal(count_text(page, "src="), 5);
    assert_int_equal(count_text(page, "<script") + count_text(page, "http"), 0);
    assert_int_equal(count_text(page, "a<b"), 0); /* names are escaped */
    assert_true(count_text(page, "a&lt;b") >= 4);
    for (size_t i = 0; i < sizeof tags / sizeof *tags; i++) {
        char open[16], close[16];
        snprintf(open, sizeof open, "<%s", tags[i]);
        snprintf(close, sizeof close, "</%s>", tags[i]);
        printf("    %-10s %d\n", tags[i], count_text(page, open));
        assert_true(count_text(page, open) > 0);
        assert_int_equal(count_text(page, open), count_text(page, close));
    }
    expect_in(page, "What --max-error 20% chooses");
    expect_in(page, "<td>frame/gbuffer</td>");
    assert_int_equal(count_text(page, "<circle"), 2);
    free(page);
}

/* Both read the reference of one cache. */
static void test_errors_are_those_of_bench(void **state) {
    (void)state;
    expect(0, REPORT "errors.html --max-error 0");
    expect(0,
           "% bench sweep scenes/cornell-box.glb --size 64x48 --variant fast --frames 1 --noise 20%"
           " --cache @/cache --reference path --restart --csv @/sweep.csv -q > @/sweep.txt;"
           " grep ',relative-rmse,path,' @/sweep.csv | grep -o 'relative-rmse,path,%,[0-9.]*'");
    char *page = file_read_text(scratch("errors.html")), cell[64];
    double error = strtod(strrchr(output, ',') + 1, NULL);
    snprintf(cell, sizeof cell, "<td>%.2f</td>", error);
    printf("    relative RMSE of bench: %s\n", cell);
    assert_true(error > 0);
    expect_in(page, cell);
    assert_int_equal(count_text(page, "--max-error"), 0);
    free(page);
}

/* The door is closed at the start: the reference's indirect light is black. */
static void test_moving_and_black(void **state) {
    (void)state;
    expect(0, "% report scenes/door.glb --size 48x36 --variant unshadowed --frames 1 --noise 50%"
              " --flicker 2 --max-error 0 --cache @/cache -q -o @/door.html");
    char *page = file_read_text(scratch("door.html"));
    expect_in(page, "<th>flicker %</th>");
    expect_in(page, "mean over 2 frames");
    expect_in(page, "The reference has no indirect light");
    assert_int_equal(count_text(page, "inf<") + count_text(page, "nan<") + count_text(page, "<svg"),
                     0);
    free(page);
}

static void test_refusals(void **state) {
    (void)state;
    expect(2, "% report");
    expect(2, "% report scenes/cornell-box.glb --variant nonsense");
    expect_text("nonsense");
    expect(2, "% report scenes/cornell-box.glb --set lights.vpls=-1");
    expect(1, "% report no-such-scene.glb -o @/none.html");
    expect_text("no-such-scene.glb: No such file");
    expect(1, "% report scenes/cornell-box.glb -o @/no/such/folder/page.html");
    expect(1, "% report scenes/cornell-box.glb -o scenes/cornell-box.glb");
    expect(1, "test -e @/none.html");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_page),
        cmocka_unit_test(test_errors_are_those_of_bench),
        cmocka_unit_test(test_moving_and_black),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests_name("report", tests, NULL, NULL);
}
