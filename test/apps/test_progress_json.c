/* --progress json: each line of standard error is an event, whatever happens;
 * test/apps/check_progress.py reads them. */
#include "command_support.h"

#define CHECKED " 2>&1 >/dev/null | test/apps/check_progress.py"

static int need_python(void **state) {
    (void)state;
    return run_line("python3 -c 'import json'") == 0 ? 0 : -1;
}

/* A frame's end is always told, and each file. */
TEST(render) {
    expect(0,
           "% render scenes/cornell-box.glb -o @/a.##.png -o @/b.##.exr --frames 3..5 --size 32x32 "
           "--quality draft --progress json" CHECKED);
    expect_text("file=6 note=1 done=1 a.03.png b.03.exr a.04.png b.04.exr a.05.png b.05.exr");
    expect_text("progress=3 ");
}

/* A name that is no UTF-8, with a quote, a backslash and a line feed. */
TEST(odd_name) {
    expect(0, "% render scenes/cornell-box.glb -o \"$(printf '@/odd\\377\\303\"\\\\\\n.png')\" "
              "--size 16x16 --quality draft --progress json" CHECKED);
    expect_text("file=1 ");
    expect_text("done=1 odd\xef\xbf\xbd\xef\xbf\xbd\"\\\n.png");
}

/* Also after -q, of which notes are silent. */
TEST(passes) {
    expect(0, "% render scenes/cornell-box.glb -o @/passes.png --size 32x32 --quality draft "
              "--passes 6 -q --progress json >/dev/null 2>@/events");
    expect(0, "test/apps/check_progress.py <@/events");
    expect_text("file=1 done=1 passes.png");
    expect(0, "grep -c '\"pass\": [0-9]*, \"passes\": 6' @/events");
}

TEST(video) {
    need_command("command -v ffmpeg");
    expect(0, "% render scenes/cornell-box.glb -o @/clip.mp4 --frames 0..1 --size 32x32 "
              "--quality draft --progress json" CHECKED);
    expect_text("progress=2 file=1 note=1 done=1 clip.mp4");
}

TEST(reference) {
    expect(0, "% reference scenes/cornell-box.glb -o @/reference.exr --size 48x48 --spp 64 "
              "--progress json" CHECKED);
    expect_text("file=1 note=1 done=1 reference.exr");
}

TEST(bench) {
    expect(0, "% bench times scenes/cornell-box.glb --size 32x32 --frames 1 --variant fast "
              "--progress json" CHECKED);
    expect_text(" done=1");
}

/* Errors are the last event; what is wrong before the options are known is text. */
TEST(errors) {
    expect(1, "% render @/none.glb -o @/a.png --progress json 2>@/events");
    expect(0, "test/apps/check_progress.py <@/events");
    expect_text("error=1");
    expect(0, "cat @/events");
    expect_text("none.glb: No such file or directory\"}");
    expect(1, "ulimit -d 100000; % render scenes/sphere.glb -o @/a.png --progress json 2>@/events");
    expect(0, "test/apps/check_progress.py <@/events");
    expect_text("error=1");
    expect(2, "% render scenes/cornell-box.glb -o @/a.png --progress loud");
    expect_text("progress: 'loud' is not one of text, json");
}

RUN_TESTS(need_python, NULL)
