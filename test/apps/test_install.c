/* make install and uninstall into a folder of the test's, and the installed program from another working folder. */
#define _XOPEN_SOURCE 700
#include "command_support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* All but what is built: the program that lies there is installed. Other builds' tests leave it alone. */
#define MAKE "make -s -o all DESTDIR=@/dest PREFIX=/opt/here"
#define BIN "env XDG_CACHE_HOME=@/cache @/dest/opt/here/bin/manylight"

static int install_beside_others(void **state) {
    (void)state;
    if (strcmp(binary_path(), "./manylight") != 0)
        return 0;
    if (run_line(
            "rm -rf @/dest @/else && mkdir -p @/else @/dest/opt/here/bin @/dest/opt/here/share/doc"
            " @/dest/opt/here/share/manylight/scenes && cd @/dest/opt/here && touch bin/other"
            " share/manylight/scenes/mine.glb") != 0)
        return -1;
    return run_line(MAKE " install");
}

static void skip_other_builds(void) {
    if (strcmp(binary_path(), "./manylight") == 0)
        return;
    printf("    skipped: only the default build is installed\n");
    skip();
}

static void test_files(void **state) {
    (void)state;
    skip_other_builds();
    expect(0, "cmp manylight @/dest/opt/here/bin/manylight");
    expect(0, "cmp LICENSE @/dest/opt/here/share/doc/manylight/LICENSE");
    expect(0, "cd scenes && for s in *.glb *.hdr failures/*.glb; do"
              " cmp $s @/dest/opt/here/share/manylight/scenes/$s || exit; done");
}

/* From a folder that has no scenes: one of its four, which is none, is found in the installed tree. */
static void test_bench_finds_scenes(void **state) {
    (void)state;
    skip_other_builds();
    expect(0, "cd @/dest/opt/here/share/manylight/scenes && mv cornell-box.glb kept && echo no > "
              "cornell-box.glb");
    expect(1, "cd @/else && " BIN " bench times");
    expect_text("bin/../share/manylight/scenes/cornell-box.glb: not a scene");
    expect(0, "cd @/dest/opt/here/share/manylight/scenes && mv kept cornell-box.glb");
    expect(0, "cd @/else && " BIN " bench failures one-pixel --noise .5");
    expect_text("one-pixel");
}

/* scenes/ of the working folder comes first. */
static void test_bench_prefers_working_folder(void **state) {
    (void)state;
    skip_other_builds();
    expect(0, "mkdir -p @/else/scenes && echo no > @/else/scenes/cornell-box.glb");
    expect(1, "cd @/else && " BIN " bench times");
    expect_text("bench times: scenes/cornell-box.glb: not a scene");
    expect(0, "rm -r @/else/scenes");
}

/* Two installs and an uninstall leave what others put there, and nothing else. */
static void test_uninstall(void **state) {
    (void)state;
    skip_other_builds();
    expect(0, MAKE " install");
    expect(0, MAKE " uninstall");
    expect(0, "cd @/dest && (find . -type f | LC_ALL=C sort)");
    expect_text("./opt/here/bin/other\n./opt/here/share/manylight/scenes/mine.glb\n");
    assert_null(strstr(output, "LICENSE"));
    assert_null(strstr(output, "cornell"));
    expect(0, "test ! -e @/dest/opt/here/share/doc/manylight");
    expect(2, MAKE " uninstall");
    expect_text("nothing to uninstall");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_files),
        cmocka_unit_test(test_bench_finds_scenes),
        cmocka_unit_test(test_bench_prefers_working_folder),
        cmocka_unit_test(test_uninstall),
    };
    return cmocka_run_group_tests(tests, install_beside_others, NULL);
}
