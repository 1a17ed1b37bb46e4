/* Small files that name a great deal: each is read or refused with one message, in a time and a
 * memory that its size bounds. Prints CPU seconds and peak memory of each. */
#define _GNU_SOURCE
#include "support.h"

#include "base/file/output_file.h"
#include "base/text.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* --- files ------------------------------------------------------------------------------------ */

/* The JSON of a scene; NULL = what a triangle has. Each begins with a comma where a list is gone on
 * with. */
struct parts {
    const char *primitive;
    const char *buffers, *accessors, *views; /* after the triangle's own */
    const char *nodes;                       /* and scenes */
    const char *more;                        /* members of the top level */
};

static const char *given(const char *part, const char *otherwise) {
    return part ? part : otherwise;
}

static char *scene_text(const struct parts *parts) {
    struct text text = {0};
    text_print(&text,
               "{asset:{version:'2.0'},scene:0,meshes:[{primitives:[%s]}],buffers:[{byteLength:36,"
               "uri:'data:application/"
               "octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA'}%s],"
               "bufferViews:[{buffer:0,byteLength:36}%s],accessors:[{bufferView:0,componentType:"
               "5126,count:3,type:VEC3,min:[0,0,0],max:[1,1,0]}%s],%s%s}",
               given(parts->primitive, "{attributes:{POSITION:0}}"), given(parts->buffers, ""),
               given(parts->views, ""), given(parts->accessors, ""),
               given(parts->nodes, "nodes:[{mesh:0}],scenes:[{nodes:[0]}]"),
               given(parts->more, ""));
    char *json = mem_alloc(2 * text.length, 1);
    quote_words(text.data, json, 2 * text.length);
    free(text.data);
    return json;
}

/* begin, then so many times what, in which %d is the number, with commas; then end. */
__attribute__((format(printf, 3, 0))) static char *list(const char *begin, int count,
                                                        const char *what, const char *end) {
    struct text text = {0};
    text_print(&text, "%s", begin);
    for (int i = 0; i < count; i++) {
        text_append(&text, ",", i > 0);
        text_print(&text, what, i);
    }
    text_print(&text, "%s", end);
    return text.data;
}

/* A node with the mesh and so many others, side by side. */
static char *nodes(int count, const char *node) {
    char *all = list("nodes:[{mesh:0},", count, node, "],");
    char *scene = list("scenes:[{nodes:[", count + 1, "%d", "]}]");
    struct text text = {0};
    text_print(&text, "%s%s", all, scene);
    mem_free(all, scene);
    return text.data;
}

static char *many_targets(void) {
    char *primitive = list("{attributes:{POSITION:0},targets:[", 100000, "{POSITION:0}", "]}");
    char *text = scene_text(&(struct parts){.primitive = primitive});
    free(primitive);
    return text;
}

#define VECTORS(count) ",{componentType:5126,count:" #count ",type:VEC3,min:[0,0,0],max:[0,0,0]}"

/* Of an accessor without bytes: 7 GB of zeros. */
static char *targets_of_zeros(void) {
    char *primitive = list("{attributes:{POSITION:1},targets:[", 20000, "{POSITION:1}", "]}");
    char *text = scene_text(&(struct parts){.primitive = primitive, .accessors = VECTORS(30000)});
    free(primitive);
    return text;
}

static char *many_elements(void) {
    return scene_text(&(struct parts){.primitive = "{attributes:{POSITION:1}}",
                                      .accessors = VECTORS(2000000000)});
}

static char *many_joints(void) {
    char *tree = nodes(70000, "{}"), *skin = list(",skins:[{joints:[", 70000, "%d", "]}]");
    char *text = scene_text(&(struct parts){.nodes = tree, .more = skin});
    mem_free(tree, skin);
    return text;
}

/* Node i is the child of node i + 1. */
static char *long_chain(void) {
    char *tree = list("nodes:[{mesh:0},", 70000, "{children:[%d]}", "],scenes:[{nodes:[70000]}]");
    char *text = scene_text(&(struct parts){.nodes = tree});
    free(tree);
    return text;
}

static char *many_instances(void) {
    char *tree = nodes(300000, "{mesh:0}"), *text = scene_text(&(struct parts){.nodes = tree});
    free(tree);
    return text;
}

static char *many_lights(void) {
    char *tree = nodes(100000, "{extensions:{KHR_lights_punctual:{light:0}}}");
    char *text =
        scene_text(&(struct parts){.nodes = tree,
                                   .more = ",extensionsUsed:[KHR_lights_punctual],extensions:{KHR_"
                                           "lights_punctual:{lights:[{type:point}]}}"});
    free(tree);
    return text;
}

static char *many_cameras(void) {
    char *tree = nodes(100000, "{camera:0}");
    char *text =
        scene_text(&FILLED(parts, .nodes = tree,
                           .more = ",cameras:[{type:perspective,perspective:{yfov:1,znear:1}}]"));
    free(tree);
    return text;
}

static char *many_extras(void) {
    char *extras = list(",extras:[", 250000, "{b:%d}", "]");
    char *text = scene_text(&(struct parts){.more = extras});
    free(extras);
    return text;
}

/* Vertices 0 1 2, and again. */
static char *same_triangle(void) {
    struct text indices = {0};
    text_print(&indices, ",{byteLength:1800000,uri:\"data:application/octet-stream;base64,");
    for (int i = 0; i < 300000; i++)
        text_print(&indices, "AAABAAIA");
    text_print(&indices, "\"}");
    char *text = scene_text(
        &FILLED(parts, .primitive = "{attributes:{POSITION:0},indices:1}", .buffers = indices.data,
                .views = ",{buffer:1,byteLength:1800000}",
                .accessors = ",{bufferView:1,componentType:5123,count:900000,type:SCALAR}"));
    free(indices.data);
    return text;
}

/* Four textures of 8192x8192, black: .2 MB of files, 1 GB of texels. */
static char *many_pictures(void) {
    struct bitmap black = {8192, 8192, calloc((size_t)8192 * 8192, 4)};
    check_ok("a black picture", bitmap_write(&black, scratch("black.png")));
    free(black.rgba);
    struct text all = {0};
    const char *const lists[][2] = {
        {",images:[", "{uri:'black.png'}"},
        {",textures:[", "{source:%d}"},
        {",materials:[", "{pbrMetallicRoughness:{baseColorTexture:{index:%d}}}"},
    };
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        char *one = list(lists[i][0], 4, lists[i][1], "]");
        text_print(&all, "%s", one);
        free(one);
    }
    char *text = scene_text(&(struct parts){.more = all.data});
    free(all.data);
    return text;
}

/* --- runs ------------------------------------------------------------------------------------- */

struct cost {
    int status; /* exit status, or minus the signal */
    double cpu; /* seconds */
    double mib; /* of memory at the peak */
};

/* A run that takes `cpu_limit` seconds of CPU time hangs. Its output is in the file. */
static struct cost run(const char *command, const char *output) {
    const rlim_t cpu_limit = 60;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        int file = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
        setrlimit(RLIMIT_CPU, &(struct rlimit){cpu_limit, cpu_limit});
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    int status;
    struct rusage usage;
    assert_int_equal(wait4(child, &status, 0, &usage), child);
    return FILLED(cost, .status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
                  .cpu = (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                         1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec),
                  .mib = (double)usage.ru_maxrss / 1024);
}

/* Small maps: what counts is what comes before the drawing. */
#define RENDER                                                                                     \
    "render --size 16x16 -q -o @/hostile.png --set shadow-size=16 --set rsm-size=16 --set "        \
    "map-size=16 "

static const struct hostile {
    const char *name;
    char *(*write)(void);
    const char *arguments;
    int status;
    const char *message; /* NULL = any or none */
} cases[] = {
    {"targets", many_targets, RENDER, 0, NULL},
    {"zeros", targets_of_zeros, "info ", 1,
     "MiB are left of what the scene may take (ulimit -d grants more)"},
    {"elements", many_elements, "info ", 1, "accessor 1: more than 128 million elements"},
    {"joints", many_joints, RENDER, 0, NULL},
    {"chain", long_chain, RENDER, 0, NULL},
    {"instances", many_instances, "info ", 0, NULL},
    {"lights", many_lights, "info ", 0, "... and 99900 more"},
    {"lights", many_lights, RENDER, 1, "100000 lights with 600000 views: at most 64"},
    {"cameras", many_cameras, "info ", 0, "... and 99900 more"},
    {"extras", many_extras, "info ", 0, NULL},
    {"same", same_triangle, RENDER, 0, NULL},
    {"pictures", many_pictures, "info ", 0, "textures are scaled down, some to 4096 texels a side"},
};

static void write_case(const struct hostile *hostile, const char *path, size_t *size) {
    char *text = hostile->write();
    *size = strlen(text);
    check_ok(path, output_file_write(path, text, *size));
    free(text);
}

static void read_output(char *output, size_t size) {
    FILE *file = fopen(scratch("hostile.txt"), "r");
    output[fread(output, 1, size - 1, file)] = '\0';
    fclose(file);
}

/* A frame takes no more memory than `info` says. */
static void check_foretold(const char *path, double mib) {
    char output[1 << 16];
    double most;
    const char *command = form("exec %s info %s", binary_path(), path), *said;
    assert_int_equal(run(command, scratch("hostile.txt")).status, 0);
    read_output(output, sizeof output);
    said = strstr(output, "memory     at most ");
    assert_true(said && sscanf(said, "memory at most %lf MiB for a frame", &most) == 1);
    check_at_most("MiB of a frame", mib, most);
}

TEST(cost) {
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct hostile *hostile = &cases[i];
        if (!is_tried_here(i, 2))
            continue;
        char arguments[512], output[1 << 16];
        size_t size;
        const char *name = form("hostile-%s.gltf", hostile->name);
        const char *path = form("%s", scratch(name));
        write_case(hostile, path, &size);
        in_scratch(arguments, sizeof arguments, hostile->arguments);
        const char *command = form("exec %s %s%s", binary_path(), arguments, path);
        struct cost cost = run(command, scratch("hostile.txt"));
        read_output(output, sizeof output);
        printf("    %-10s %5.2f MiB -> %d, %5.2f s of the CPU\n", hostile->name,
               (double)size / (1 << 20), cost.status, cost.cpu);
        if (cost.status)
            printf("    %s", output);
        assert_int_equal(cost.status, hostile->status);
        if (hostile->message)
            assert_non_null(strstr(output, hostile->message));
#ifndef __SANITIZE_ADDRESS__
        /* What --help says of a scene, and the program with its drivers. */
        check_at_most("MiB of memory", cost.mib, 2048 + 64 * (double)size / (1 << 20) + 512);
        if (cost.status == 0 && strncmp(hostile->arguments, "render", 6) == 0)
            check_foretold(path, cost.mib);
#endif
    }
}

/* --- files of strangers ----------------------------------------------------------------------- */

/* Told or refused in one line; in the time and the memory that a small file may take. */
static void check_stranger(const char *path, double least_mib) {
    char output[1 << 12];
    struct stat info;
    assert_int_equal(stat(path, &info), 0);
    const char *command = form("exec %s info '%s'", binary_path(), path);
    struct cost cost = run(command, scratch("stranger.txt"));
    FILE *file = fopen(scratch("stranger.txt"), "r");
    output[fread(output, 1, sizeof output - 1, file)] = '\0';
    fclose(file);
    printf("    %6.1f MiB over a triangle's, %5.2f s, %8ld bytes -> %d %s\n", cost.mib - least_mib,
           cost.cpu, (long)info.st_size, cost.status, path);
    bool refused = cost.status == 1 && strncmp(output, "manylight info: ", 16) == 0 &&
                   strchr(output, '\n') == output + strlen(output) - 1;
    if (cost.status != 0 && !refused)
        fail_msg("%s", output);
#ifndef __SANITIZE_ADDRESS__
    if (info.st_size < 1 << 20)
        check_at_most("seconds of the CPU", cost.cpu, 2);
    check_at_most("MiB of memory", cost.mib, 2048 + 64 * (double)info.st_size / (1 << 20) + 512);
#endif
}

/* The files that fuzzing begins with, or those of the folder MANYLIGHT_STRANGERS. */
TEST(strangers) {
    const char *strangers = getenv("MANYLIGHT_STRANGERS");
    const char *folder = strangers ? strangers : "test/fuzz/seeds/scene";
    const char *command = form("exec %s info test/fuzz/seeds/scene/triangle.glb", binary_path());
    double least_mib = run(command, "/dev/null").mib;
    struct dirent **entries;
    int count = scandir(folder, &entries, NULL, alphasort);
    assert_true(count > 2);
    for (int i = 0; i < count; i++) {
        const char *path = form("%s/%s", folder, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.')
            check_stranger(path, least_mib);
        free(entries[i]);
    }
    free(entries);
}

RUN_TESTS(NULL, NULL)
