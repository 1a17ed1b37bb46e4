/* What a machine lacks or takes away: homes, folders, locales, OpenGL, its context, the display.
 * The program goes on, or ends with 1 and one message. */
#define _GNU_SOURCE
#include "command_support.h"
#include "view_stage.h"

#include "base/file/file.h"
#include "base/file/output_file.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define RENDER                                                                                     \
    "render scenes/cornell-box.glb --size 32x24 --set vpls=64 --set map-size=32 --set vals=4 "     \
    "--set rsm-size=64 --set shadow-size=128 --set exposure=.5 -q -o "

/* Renders behind a shell's preamble, in which @ is the scratch folder; the picture is the file. */
static int render(const char *before, const char *options, const char *picture) {
    remove(scratch(picture));
    return run_line(form("%s %% " RENDER "@/%s %s", before, picture, options));
}

static bool has_opengl(void) {
    return render("", "", "machine.exr") == 0;
}

static void check_picture(const char *name) {
    struct file_bytes expected, got;
    check_ok("expected", file_read(&expected, scratch("machine.exr")));
    check_ok("got", file_read(&got, scratch(name)));
    assert_int_equal(got.size, expected.size);
    assert_memory_equal(got.data, expected.data, got.size);
    mem_free(expected.data, got.data);
}

/* One line, which says so; no file. */
static void check_refusal(int status, const char *message) {
    assert_int_equal(status, 1);
    expect_text(message);
    assert_ptr_equal(strchr(output, '\n'), output + strlen(output) - 1);
    assert_int_not_equal(access(scratch("got.exr"), F_OK), 0);
}

/* --- the environment -------------------------------------------------------------------------- */

TEST(environment) {
    static const char *const cases[] = {
        "env -u HOME",
        "env -u TMPDIR",
        "env HOME=/none TMPDIR=/none XDG_CACHE_HOME=/none XDG_RUNTIME_DIR=/none",
        "env -i",
        "umask 777;",
    };
    if (!has_opengl())
        skip();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(render(cases[i], "", "got.exr"), 0);
        assert_string_equal(output, "");
        check_ok("mode", chmod(scratch("got.exr"), 0600) == 0);
        check_picture("got.exr");
    }
}

/* A locale that writes 1,5 for 1.5. */
static bool make_comma_locale(void) {
    static const char text[] = "comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point \",\"\n"
                               "thousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n";
    check_ok("locale", output_file_write(scratch("comma"), text, sizeof text - 1));
    run_line("cd @ && localedef -c -i comma -f ANSI_X3.4-1968 ./xx_XX 2>/dev/null; "
             "LOCPATH=. LC_ALL=xx_XX env printf %.1f 1,5");
    return strcmp(output, "1,5") == 0;
}

/* What a command prints, with the locale and without. */
static void check_print(const char *arguments) {
    static char expected[sizeof output];
    expect(0, form("LOCPATH=@ LC_ALL=C %% %s", arguments));
    memcpy(expected, output, sizeof output);
    expect(0, form("LOCPATH=@ LC_ALL=xx_XX %% %s", arguments));
    assert_string_equal(output, expected);
}

TEST(comma) {
    if (!has_opengl())
        skip();
    if (!make_comma_locale()) {
        printf("    no locale can be made here: %s\n", output);
        skip();
    }
    assert_int_equal(render("LOCPATH=@ LC_ALL=xx_XX", "", "got.exr"), 0);
    check_picture("got.exr");
    check_print("info scenes/cornell-box.glb");
    check_print("compare @/got.exr @/machine.exr --json --max relative-mae=.5");
    check_print("render --help");
}

/* --- OpenGL ----------------------------------------------------------------------------------- */

/* Libraries that are there, and are none. */
static void make_bad_libraries(void) {
    static const char *const names[] = {"no-egl", "no-osmesa", "neither"};
    for (int i = 0; i < 3; i++) {
        mkdir(scratch(names[i]), 0777);
        for (int k = 0; k < 2; k++) {
            const char *path =
                form("%s/%s", scratch(names[i]), k ? "libOSMesa.so.8" : "libEGL.so.1");
            if (i == k || i == 2)
                check_ok(path, output_file_write(path, "", 0));
        }
    }
}

TEST(opengl) {
    bool osmesa = run_line("% info --gl --context osmesa") == 0; /* gone from Mesa 25.1 on */
    const struct {
        const char *before, *options, *message; /* NULL: another way is found */
    } cases[] = {
        {"MESA_GL_VERSION_OVERRIDE=3.3", "", "no OpenGL 4.5 core context: "},
        {"MESA_GL_VERSION_OVERRIDE=4.4", "", "no OpenGL 4.5 core context: "},
        {"LD_LIBRARY_PATH=@/no-egl", "",
         osmesa ? NULL : "EGL: cannot open libEGL.so.1; OSMesa: cannot open "},
        {"LD_LIBRARY_PATH=@/no-egl", "--context egl", "EGL: cannot open libEGL.so.1"},
        {"LD_LIBRARY_PATH=@/no-osmesa", "", NULL},
        {"LD_LIBRARY_PATH=@/no-osmesa", "--context osmesa", "OSMesa: cannot open libOSMesa.so.8"},
        {"LD_LIBRARY_PATH=@/neither", "", "EGL: cannot open libEGL.so.1; OSMesa: cannot open "},
    };
    if (!has_opengl())
        skip();
    make_bad_libraries();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int status = render(cases[i].before, cases[i].options, "got.exr");
        if (cases[i].message)
            check_refusal(status, cases[i].message);
        else
            check_picture("got.exr");
    }
}

/* --- the display ------------------------------------------------------------------------------ */

static void check_viewer_log(const char *message) {
    const char *path = form("%s/viewer.log", stage.folder);
    char *log = file_read_text(path);
    assert_non_null(log);
    printf("    %s\n", log);
    assert_non_null(strstr(log, message));
    free(log);
}

TEST(no_display) {
    /* libwayland has words of its own where that folder is not named. */
    expect(1, "XDG_RUNTIME_DIR=/none DISPLAY=:9999 % view scenes/cornell-box.glb");
    expect_text("no window");
    assert_ptr_equal(strchr(output, '\n'), output + strlen(output) - 1);
}

/* The server ends while the viewer shows a picture: so does the viewer. */
TEST(display_gone) {
    int status = -1;
    pid_t ended = 0;
    start_viewer("scenes/cornell-box.glb", "");
    kill(stage.server, SIGKILL);
    waitpid(stage.server, NULL, 0);
    stage.server = 0;
    for (int i = 0; i < PATIENCE_MS / 50 && ended == 0; i++, pause_ms(50))
        ended = waitpid(stage.viewer, &status, WNOHANG);
    if (ended == 0)
        fail_msg("the viewer hangs");
    stage.viewer = 0;
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 1);
    check_viewer_log(stage.display);
}

RUN_TESTS(open_view_stage, close_view_stage)
