/* What `make bundle` has packed: libraries of its own, few enough bytes, and a check that answers.
 * Skipped where it was not built. */
#define _POSIX_C_SOURCE 200809L
#include "command_support.h"

#include <sys/stat.h>

#define BUNDLE "build/bundle"

/* Each line of ldd names a file of the bundle, or the C library. */
TEST(libraries) {
    static const char *const of_machine[] = {"linux-vdso.so", "ld-linux",   "libc.so.6",
                                             "libm.so.6",     "libdl.so.2", "libpthread.so.0"};
    int ours = 0, others = 0;
    need_file(BUNDLE);
    expect(0, "for f in " BUNDLE "/bin/* " BUNDLE "/lib/*.so* " BUNDLE "/build/test/test_gl " BUNDLE
              "/build/test/guests/manylight " BUNDLE "/build/scenes/make_scenes; do "
              "ldd $f | grep -v statically || exit; done | sed 's/ (0x.*//' | sort -u");
    for (char *rest = NULL, *line = strtok_r(output, "\n", &rest); line;
         line = strtok_r(NULL, "\n", &rest)) {
        bool is_ours = strstr(line, BUNDLE "/"), is_machine = false;
        for (size_t i = 0; i < sizeof of_machine / sizeof *of_machine; i++)
            is_machine = is_machine || strstr(line, of_machine[i]);
        if (!is_ours && !is_machine)
            fail_msg("from outside the bundle: %s", line);
        ours += is_ours;
        others += !is_ours;
    }
    printf("    libraries of the bundle %d, of the machine %d\n", ours, others);
    assert_true(ours > 5);
}

TEST(size) {
    struct stat archive;
    need_file(BUNDLE ".tar.gz");
    assert_int_equal(stat(BUNDLE ".tar.gz", &archive), 0);
    check_at_most("MB packed", (double)archive.st_size / 1e6, 60);
    expect(0, "tar tzf " BUNDLE ".tar.gz");
    static const char *const files[] = {
        "bundle/manylight\n",         "bundle/check\n",
        "bundle/bin/manylight\n",     "bundle/build/test/test_gl\n",
        "bundle/scenes/atrium.glb\n", "bundle/licences/manylight\n"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        expect_text(files[i]);
    static const char *const drivers[] = {"libGL", "libEGL", "libc.so", "libm.so", "libX11"};
    for (size_t i = 0; i < sizeof drivers / sizeof *drivers; i++)
        assert_null(strstr(output, drivers[i]));
}

/* Options of check, which is a script: mistakes are told before anything is done. */
TEST(check_options) {
    const char *folder = scratch("not-a-report");
    need_file("bundle/check");
    expect(0, "bundle/check --help");
    expect_text("--minutes N");
    expect(2, "bundle/check --minutes x");
    expect_text("'x' is no number of minutes");
    expect(2, "bundle/check --parts tests,all");
    expect_text("there is no part 'all'");
    expect(2, "bundle/check --device");
    expect_text("--device needs a value");
    expect(2, form("mkdir -p %s && touch %s/mine && bundle/check -o %s; s=$?; ls %s; exit $s",
                   folder, folder, folder, folder));
    expect_text("is not empty, and no earlier report");
    expect_text("mine");
}

/* A test that passes, one that fails and one that lacks: each has its row, and the report is
 * packed. */
TEST(check_report) {
    need_file(BUNDLE);
    const char *folder = form("%s", scratch("report"));
    expect(0,
           form("rm -rf %s && " BUNDLE "/check --minutes 2 --tests test_options,test_nothing -o %s",
                folder, folder));
    expect_text("test_options passed");
    expect_text("test_nothing cannot start");
    expect(0, form("cat %s/tests.csv && tar tzf %s.tar.gz", folder, folder));
    expect_text("\ntest_options,passed,");
    expect_text("\ntest_nothing,cannot start,0,0,0,");
    expect_text("report/summary.txt\n");
}

/* Without the viewer's window the program says so. */
TEST(view) {
    need_file(BUNDLE);
    expect(1, BUNDLE "/manylight view scenes/sphere.glb");
    expect_text("this build is without it");
}

RUN_TESTS(NULL, NULL)
