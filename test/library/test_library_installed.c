/* The library as others get it: installed, found by pkg-config and CMake, with the symbols of its
 * header and no other. */
#include "command_support.h"

#define PREFIX "@/prefix"
#define ENVIRONMENT "PKG_CONFIG_PATH=" PREFIX "/lib/pkgconfig LD_LIBRARY_PATH=" PREFIX "/lib"
#define BOX "scenes/cornell-box.glb"

/* The installed prefix is where the files lie, so that nothing needs to be moved. */
static int install_library(void **state) {
    (void)state;
    if (strcmp(binary_path(), "./manylight") != 0)
        return 0;
    return run_line("rm -rf " PREFIX " && make -s -o all install PREFIX=$(realpath -m " PREFIX ")");
}

static void check_same_layers(const char *file) {
    static const char *const layers[] = {"beauty", "direct", "indirect", "albedo", "normal", "Z"};
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++) {
        expect(0, form("%% compare %s @/program.exr --layer %s -m rmse --max rmse=0", file,
                       layers[i]));
    }
}

TEST(pkg_config) {
    need_default_build();
    need_command("pkg-config --version");
    expect(
        0, ENVIRONMENT
        " && export PKG_CONFIG_PATH && cc -std=c99 -Wall -Wextra -Werror -pedantic " PREFIX
        "/share/doc/manylight/examples/tiny.c -o @/tiny $(pkg-config --cflags --libs manylight)");
    expect(0, ENVIRONMENT " @/tiny " BOX " @/tiny.exr 64 48");
    expect_text("indirect   3 channels, mean");
    expect(0, "% render " BOX " -o @/program.exr --size 64x48");
    check_same_layers("@/tiny.exr");
    expect(0, ENVIRONMENT " @/tiny " BOX " @/tiny.tif 64 48");
    expect(0, "% render " BOX " -o @/program.pfm --size 64x48");
    expect(0, "% compare @/tiny.tif @/program.pfm -m rmse --max rmse=0");
    expect(1, ENVIRONMENT " @/tiny nowhere.glb @/no.exr");
    expect_text("tiny: cannot open nowhere.glb: No such file or directory");
}

/* Of C++, too. */
TEST(cmake) {
    need_default_build();
    need_command("cmake --version");
    write_text(scratch("CMakeLists.txt"),
               "cmake_minimum_required(VERSION 3.13)\n"
               "project(tiny C)\n"
               "find_package(manylight 0.1 REQUIRED)\n"
               "add_executable(tiny prefix/share/doc/manylight/examples/tiny.c)\n"
               "target_link_libraries(tiny manylight::manylight)\n");
    expect(0,
           "rm -rf @/cmake && cmake -S @ -B @/cmake -DCMAKE_PREFIX_PATH=$(realpath " PREFIX ") && "
           "cmake --build @/cmake");
    expect(0, "@/cmake/tiny " BOX " @/cmake.exr 16 16");
    expect(0, "sed -i 's/manylight 0.1/manylight 1.0/' @/CMakeLists.txt");
    expect(1, "cmake -S @ -B @/cmake-1 -DCMAKE_PREFIX_PATH=$(realpath " PREFIX ")");
    expect_text("0.1");
}

TEST(cxx_reads_header) {
    need_default_build();
    expect(0, "echo '#include <manylight.h>' | c++ -x c++ -std=c++11 -Wall -Wextra -Werror "
              "-pedantic -I" PREFIX "/include -fsyntax-only -");
}

/* A header of another ABI asks for functions that this library does not have. */
TEST(other_header) {
    need_default_build();
    expect(0,
           "mkdir -p @/other && sed -E 's/(_create|_open|_read)_0$/\\1_1/; s/ABI 0/ABI 1/' " PREFIX
           "/include/manylight.h > @/other/manylight.h");
    expect(1, "cc -I@/other examples/tiny.c -o @/tiny-1 -L" PREFIX "/lib -lmanylight");
    expect_text("undefined reference to `manylight_device_create_1'");
    expect_text("undefined reference to `manylight_scene_open_1'");
}

/* What the header declares, by its own names. */
TEST(symbols) {
    need_default_build();
    expect(0, "nm -D --defined-only " PREFIX
              "/lib/libmanylight.so | sed 's/.* //; s/[^A-Za-z0-9_].*//' |"
              " grep -v '^MANYLIGHT_0$' | LC_ALL=C sort > @/exported");
    expect(0, "cc -E -P " PREFIX "/include/manylight.h | grep -v '^typedef' | tr '\n' ' ' |"
              " grep -oE 'manylight_[a-z_0-9]+ *\\(' | tr -d '( ' | LC_ALL=C sort -u > @/declared");
    expect(0, "diff @/exported @/declared && wc -l < @/declared");
    expect(0, "readelf -d " PREFIX "/lib/libmanylight.so");
    expect_text("Library soname: [libmanylight.so.0]");
    assert_null(strstr(output, "TEXTREL"));
    assert_null(strstr(output, "libGL.so"));
    assert_null(strstr(output, "libEGL"));
    assert_null(strstr(output, "libglfw"));
}

/* What would change the process for others. */
TEST(process_stays) {
    need_default_build();
    expect(0, "nm -D --undefined-only " PREFIX
              "/lib/libmanylight.so | sed 's/.* //; s/[^A-Za-z0-9_].*//' > @/needed");
    expect(0, "grep -x dlopen @/needed");
    expect(1, "grep -xE 'exit|signal|setlocale|putenv|chdir|system|popen|atexit' @/needed");
}

TEST(window) {
    need_default_build();
    need_command("xvfb-run --help");
    need_command("pkg-config --exists glfw3 gl");
    expect(0, "PKG_CONFIG_PATH=" PREFIX
              "/lib/pkgconfig sh -c 'cc -Wall -Werror examples/window.c -o @/window "
              "$(pkg-config --cflags --libs manylight glfw3 gl) -lm'");
    expect(0, "LD_LIBRARY_PATH=" PREFIX "/lib xvfb-run -a @/window " BOX " 3");
    expect(1, "LD_LIBRARY_PATH=" PREFIX "/lib xvfb-run -a @/window nowhere.glb 3");
    expect_text("window: cannot open nowhere.glb");
}

TEST(uninstall) {
    need_default_build();
    expect(0, "make -s uninstall PREFIX=$(realpath " PREFIX ") && find " PREFIX
              " -name '*manylight*'");
    assert_null(strstr(output, "/lib/"));
    assert_null(strstr(output, "/include/"));
}

RUN_TESTS(install_library, NULL)
