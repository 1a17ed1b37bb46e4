/* The Python module: pictures of the program's bits, refusals in its words, threads, the notebook
 * and the wheel. */
#define _XOPEN_SOURCE 700
#include "command_support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sets PYTHON to one that has what the module needs: the first of the path, or the system's. */
#define FIND_PYTHON                                                                                \
    "for PYTHON in python3 /usr/bin/python3 false; do $PYTHON -c 'import numpy, cffi, os, "        \
    "sysconfig; os.stat(sysconfig.get_path(\"include\") + \"/Python.h\")' 2>/dev/null && break;"   \
    " done; "
#define BUILD "${MANYLIGHT_BUILD:-build}"

static bool has_python;

/* Builds the module for the library that is there. */
static int build_module(void **state) {
    (void)state;
    has_python = run_line(FIND_PYTHON "test $PYTHON != false && test -e Makefile") == 0;
    return !has_python || run_line(FIND_PYTHON "make -s python PYTHON=$PYTHON BUILD=" BUILD
                                               " -o " BUILD "/lib/libmanylight.so.*.* -o " BUILD
                                               "/openimageio/libmanylight-openimageio.so") == 0
               ? 0
               : -1;
}

static void need_python(void) {
    if (has_python)
        return;
    printf("    skipped: python3-dev, python3-cffi, python3-numpy or the source is not here\n");
    skip();
}

/* A library of AddressSanitizer wants to be loaded first, and Python leaves memory at its end. */
#define WITH_SANITIZER                                                                             \
    "export LD_PRELOAD=$(ldd %s/manylight/libmanylight.so.0 | awk '/libasan/ { print $3 }') "      \
    "ASAN_OPTIONS=detect_leaks=0; "

/* Runs a script of test/python with the module of a folder. */
static void run_script_of(const char *folder, const char *script) {
    need_python();
    expect(0, form(FIND_PYTHON WITH_SANITIZER "PYTHONPATH=%s $PYTHON test/python/%s", folder,
                   folder, script));
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
    need_python();
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
