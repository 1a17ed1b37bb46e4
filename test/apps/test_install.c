/* make install and uninstall into a folder of the test's, and the installed program from another
 * working folder. */
#define _XOPEN_SOURCE 700
#include "command_support.h"

#include <unistd.h>

/* All but what is built: the program that lies there is installed. Other builds' tests leave it
 * alone. */
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

TEST(files) {
    need_default_build();
    expect(0, "cmp manylight @/dest/opt/here/bin/manylight");
    expect(0, "cmp LICENSE @/dest/opt/here/share/doc/manylight/LICENSE");
    expect(0, "cd scenes && for s in *.glb *.hdr failures/*.glb; do"
              " cmp $s @/dest/opt/here/share/manylight/scenes/$s || exit; done");
}

/* Of docs/manual, and of desktop/. */
TEST(shares) {
    need_default_build();
    expect(0, "cd @/dest/opt/here/share && ls man/man1/manylight.1 man/man1/manylight-render.1 "
              "bash-completion/completions/manylight "
              "icons/hicolor/scalable/apps/org.manylight.manylight.svg "
              "applications/org.manylight.manylight.desktop");
    expect(0, "cd @/dest/opt/here && ./bin/manylight --help | sed -n 's,^  \\([a-z]*\\) .*,\\1,p' |"
              " while read c; do test -s share/man/man1/manylight-$c.1 || exit; done");
}

TEST(desktop_files) {
    need_default_build();
    need_command("command -v desktop-file-validate");
    expect(0, "desktop-file-validate @/dest/opt/here/share/applications/*.desktop");
    assert_string_equal(output, "");
    need_command("command -v appstreamcli");
    expect(0, "XDG_CACHE_HOME=@/cache appstreamcli validate --no-net "
              "@/dest/opt/here/share/metainfo/*.xml");
}

/* The command of the file, with the names that a file manager puts in: a space in the scene's, no
 * extension in the picture's. */
TEST(thumbnailer) {
    need_default_build();
    static const int sizes[] = {128, 512};
    for (size_t i = 0; i < 2; i++) {
        int size[2] = {0};
        if (!is_tried_here(i, 2))
            continue;
        expect(
            0,
            form("cp scenes/cornell-box.glb '@/a scene.glb' && PATH=@/dest/opt/here/bin:$PATH && "
                 "command=$(sed -n 's,^Exec=,,p' @/dest/opt/here/share/thumbnailers/*) && "
                 "eval \"$(echo \"$command\" | sed \"s,%%i,'@/a scene.glb',;s,%%s,%d,;"
                 "s,%%o,@/thumbnail,\")\"",
                 sizes[i]));
        assert_string_equal(output, "");
        check_ok("thumbnail", image_size(scratch("thumbnail"), size));
        check_near("width", size[0], sizes[i], 0);
        check_near("height", size[1], sizes[i], 0);
    }
}

/* The installed program finds the installed bridge to OpenImageIO. */
TEST(bridge) {
    need_default_build();
    expect(0, "cd @/else && " BIN " render @/dest/opt/here/share/manylight/scenes/cornell-box.glb "
              "--size 8x8 --technique unshadowed -o picture.tif");
    expect(0, "cd @/else && " BIN " compare picture.tif picture.tif -m rmse --max rmse=0");
    expect(0, "cd @/else && ! " BIN " render nowhere.glb -o picture.xyz 2> told; cat told; rm *");
    expect_text("(known: .exr .tif ");
}

/* From a folder that has no scenes: one of its four, which is none, is found in the
 * installed tree. */
TEST(bench_finds_scenes) {
    need_default_build();
    expect(0, "cd @/dest/opt/here/share/manylight/scenes && mv cornell-box.glb kept && echo no > "
              "cornell-box.glb");
    expect(1, "cd @/else && " BIN " bench times");
    expect_text("bin/../share/manylight/scenes/cornell-box.glb: not a scene");
    expect(0, "cd @/dest/opt/here/share/manylight/scenes && mv kept cornell-box.glb");
    expect(0, "cd @/else && " BIN " bench failures one-pixel --noise .5");
    expect_text("one-pixel");
}

/* scenes/ of the working folder comes first. */
TEST(bench_prefers_working_folder) {
    need_default_build();
    expect(0, "mkdir -p @/else/scenes && echo no > @/else/scenes/cornell-box.glb");
    expect(1, "cd @/else && " BIN " bench times");
    expect_text("bench times: scenes/cornell-box.glb: not a scene");
    expect(0, "rm -r @/else/scenes");
}

/* Two installs and an uninstall leave what others put there, and nothing else. */
TEST(uninstall) {
    need_default_build();
    expect(0, MAKE " install");
    expect(0, MAKE " uninstall");
    expect(0, "cd @/dest && (find . -type f | LC_ALL=C sort)");
    expect_text("./opt/here/bin/other\n./opt/here/share/manylight/scenes/mine.glb\n");
    assert_null(strstr(output, "LICENSE"));
    assert_null(strstr(output, "cornell"));
    expect(0, "test ! -e @/dest/opt/here/share/doc/manylight");
    expect(0, "test ! -e @/dest/opt/here/lib/manylight");
    expect(2, MAKE " uninstall");
    expect_text("nothing to uninstall");
}

RUN_TESTS(install_beside_others, NULL)
