/* What is larger than memory is refused before it is allocated: one message that names the file,
 * the object, what is wanted and what is free; exit 1, no abort, no file. */
#include "command_support.h"

#include "base/file/output_file.h"
#include "base/image.h"

#include <sys/resource.h>
#include <unistd.h>

/* Heads of pictures of 2^28 pixels; no reader comes to what follows. */
static void write_pictures(void) {
    static const unsigned char tga[64] = {[2] = 2, [13] = 64, [15] = 64, [16] = 24};
    write_text(scratch("huge.ppm"), "P6\n16384 16384\n255\nxxx");
    write_text(scratch("huge.pfm"), "PF\n16384 16384\n-1.0\nxxx");
    check_ok("tga", output_file_write(scratch("huge.tga"), tga, sizeof tga));
}

#define TRIANGLE "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
#define HEAD "{asset:{version:'2.0'},scene:0,scenes:[{nodes:[0,1]}],"

/* A triangle with such a texture; twice 30 million vertices, of which the file gives three. */
static void write_scenes(void) {
    write_json(scratch("huge-texture.gltf"),
               HEAD "nodes:[{mesh:0},{}],meshes:[{primitives:[{attributes:{POSITION:0},material:0}]"
                    "}],materials:[{name:wall,pbrMetallicRoughness:{baseColorTexture:{index:0}}}],"
                    "textures:[{source:0}],images:[{uri:\"huge.tga\"}],buffers:[{byteLength:36,uri:"
                    "\"data:application/octet-stream;base64," TRIANGLE
                    "\"}],bufferViews:[{buffer:0,byteLength:36}],accessors:[{bufferView:0,"
                    "componentType:5126,count:3,type:VEC3,min:[0,0,0],max:[1,1,0]}]}");
    write_json(
        scratch("huge-mesh.gltf"), HEAD
        "nodes:[{mesh:0},{mesh:0}],meshes:[{primitives:[{attributes:{POSITION:0}}]}],accessors:[{"
        "componentType:5126,count:30000000,type:VEC3,min:[0,0,0],max:[1,1,1],sparse:{count:1,"
        "indices:{bufferView:0,byteOffset:0,componentType:5125},values:{bufferView:0,byteOffset:12}"
        "}}],buffers:[{byteLength:36,uri:\"data:application/octet-stream;base64," TRIANGLE
        "\"}],bufferViews:[{buffer:0,byteLength:36}]}");
}

TEST(refusals) {
#ifdef __SANITIZE_ADDRESS__
    skip(); /* needs more address space than any limit leaves */
#endif
    static const struct {
        const char *limit, *arguments, *message; /* KiB of address space */
    } cases[] = {
        {"2500000", "compare @/huge.ppm scenes/none.exr",
         "huge.ppm: a picture of 16384x16384 with 3 channels: 3.07 GiB of memory are wanted, and "},
        {"2500000", "compare @/huge.pfm scenes/none.exr",
         "huge.pfm: a picture of 16384x16384 with 3 channels: 3.11 GiB of memory are wanted, and "},
        {"1500000", "info @/huge-texture.gltf",
         "material 0 'wall': image 0: huge.tga: 2.33 GiB of memory are wanted, and "},
        {"2000000", "info @/huge-mesh.gltf",
         "60000000 vertices and 60000000 indices: 1.56 GiB of memory are wanted, and "},
        {"8000000", "reference scenes/cornell-box.glb --size 16384x16384 --spp 4 -o none.exr",
         "a reference of 16384x16384: 70.00 GiB of memory are wanted, and "},
    };
    write_pictures();
    write_scenes();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char arguments[512];
        bool other = strstr(cases[i].arguments, ".ppm") || strstr(cases[i].arguments, "texture");
        if (other && !knows_format("tga"))
            continue;
        in_scratch(arguments, sizeof arguments, cases[i].arguments);
        const char *command =
            form("ulimit -v %s; exec %s %s", cases[i].limit, binary_path(), arguments);
        int status = run_command(command, output, sizeof output);
        printf("    %s -> %d %s", cases[i].arguments, status, output);
        assert_int_equal(status, 1);
        expect_text(cases[i].message);
        assert_null(strstr(output, "Aborted"));
    }
    assert_int_not_equal(access("none.exr", F_OK), 0);
}

/* Products of three sizes do not wrap. */
TEST(sums) {
    assert_true(mem_check(0));
    assert_true(mem_check(1 << 20));
    check_refused(mem_check(UINT64_MAX / 2), "");
    assert_true(image_fits(16, 16, 4));
    check_refused(image_fits(2000000000, 1000000000, 1),
                  "a picture of 2000000000x1000000000 with 1 channels: ");
    assert_false(image_fits(1 << 30, 1 << 30, 16)); /* 2^66 bytes */
}

/* What nobody has is refused. */
TEST(limits) {
    check_refused(mem_check(UINT64_MAX - 1), "");
    assert_true(mem_check(1));
    double resident = mem_resident(); /* before the most there was: telling takes some, too */
    assert_true(resident > 0 && mem_most_resident() >= resident);
    void *nothing = mem_alloc(0, 8);
    assert_non_null(nothing);
    nothing = mem_resize(nothing, 0, 0);
    assert_non_null(nothing);
    free(nothing);
}

/* A low ulimit ends each run with one message and status 1, whatever the OpenGL driver does. */
TEST(low_limits) {
#ifdef __SANITIZE_ADDRESS__
    skip(); /* the sanitizer's own memory counts, terabytes */
#endif
    static const struct {
        const char *limit, *arguments, *message; /* NULL: it works */
    } cases[] = {
        {"ulimit -v 150000", "info scenes/sphere.glb", NULL},
        {"ulimit -v 500000", "render scenes/sphere.glb -o @/low.exr --size 16x16",
         "render: too little memory: ulimit -v leaves "},
        {"ulimit -v 800000", "bench times scenes/sphere.glb --size 16x16",
         "bench times: too little memory: ulimit -v leaves "},
        {"ulimit -v 1000000", "render scenes/sphere.glb -o @/low.exr --size 16x16",
         "render: too little memory: ulimit -v leaves "},
        {"ulimit -d 100000", "render scenes/sphere.glb -o @/low.exr --size 16x16",
         "render: too little memory: ulimit -d leaves "},
        {"ulimit -d 150000", "bench times scenes/sphere.glb --size 16x16",
         "bench times: too little memory: ulimit -d leaves "},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char arguments[512];
        in_scratch(arguments, sizeof arguments, cases[i].arguments);
        const char *command = form("(ulimit -c 0; %s; exec %s %s 2>&1 >/dev/null)", cases[i].limit,
                                   binary_path(), arguments);
        int status = run_command(command, output, sizeof output);
        printf("    %s -> %d %s\n", cases[i].limit, status, output);
        assert_int_equal(status, cases[i].message != NULL);
        expect_text(cases[i].message ? cases[i].message : "");
        assert_true(!cases[i].message || strchr(output, '\n')[1] == '\0');
    }
}

/* Pages that the system had to hand out while 128 MiB were allocated piece by piece, written to and
 * freed. */
static long pages_of_pieces(void) {
    enum { PIECES = 2048, PIECE = 64 << 10 };
    static void *pieces[PIECES];
    struct rusage before, after;
    getrusage(RUSAGE_SELF, &before);
    for (int i = 0; i < PIECES; i++)
        memset(pieces[i] = mem_alloc(PIECE, 1), i, PIECE);
    for (int i = PIECES - 1; i >= 0; i--)
        free(pieces[i]);
    getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
}

/* A software rasteriser asks for as much each frame. */
TEST(keep_freed) {
#ifdef __SANITIZE_ADDRESS__
    skip(); /* which has an allocator of its own */
#endif
    mem_keep_freed();
    long first = pages_of_pieces(), second = pages_of_pieces();
    printf("    pages: at first %ld, then %ld\n", first, second);
    check_at_most("pages anew, over those at first", (double)second / (double)first, .1);
}

RUN_TESTS(NULL, NULL)
