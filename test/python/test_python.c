/* The Python module: pictures of the program's bits, refusals in its words, threads, the notebook
 * and the wheel. */
#define _XOPEN_SOURCE 700
#include "command_support.h"

/* Runs a script of test/python with the module of a folder. */
static void run_script_of(const char *folder, const char *script) {
    need_module();
    expect(0, form(WITH_MODULE("%s") "$PYTHON test/python/%s", folder, folder, script));
}

static void run_script(const char *script) {
    run_script_of(BUILD "/python", script);
}

TEST(bits) {
    run_script("check_bits.py % @");
}

TEST(arguments) {
    run_script("check_arguments.py % @");
}

TEST(cameras) {
    run_script("check_cameras.py % @");
}

TEST(changes) {
    run_script("check_changes.py");
}

TEST(score) {
    run_script("check_score.py % @");
}

TEST(life) {
    run_script("check_life.py");
}

LONG_TEST(notebook) {
    run_script("run_notebook.py examples/python.ipynb");
}

TEST(examples) {
    run_script("../../examples/dataset.py scenes/cornell-box.glb @/set --views 2 --size 16");
    expect(0, "ls @/set");
    expect_text("0000.exr\n0001.exr\nviews.json\n");
    run_script("../../examples/noise.py scenes/cornell-box.glb --size 8 --samples 2 4");
    expect_text("samples  relative RMSE  estimated\n");
}

/* pip's wheel is for any later Python, carries the library and makes the same bits, from wherever
 * it lies. */
LONG_TEST(wheel) {
    need_module();
    need_command(
        "/usr/bin/python3 -c 'import mesonpy, pip; mesonpy.__version__ >= \"0.14\" or exit(1)'");
    expect(0, "rm -rf @/wheel @/site && BUILD=" BUILD " /usr/bin/python3 -m pip wheel -q -w @/wheel"
              " --no-deps --no-build-isolation . && /usr/bin/python3 -m zipfile -e @/wheel/*.whl"
              " @/site && ls @/wheel @/site/manylight && git status --short");
    expect_text("-abi3-linux_");
    expect_text("libmanylight-openimageio.so\nlibmanylight.so.0\n");
    assert_null(strstr(output, ".mesonpy"));
    run_script_of("@/site", "check_bits.py % @");
}

RUN_TESTS(build_module, NULL)
