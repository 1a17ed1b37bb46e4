#define _DEFAULT_SOURCE
#include "gl/screen_glsl.h"

#include "base/memory.h"
#include "base/text.h"
#include "shared/bindings.h"

#include <assert.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* A text in the making. */
struct rewriting {
    struct text text;
    const struct screen_desc *desc;
    int line;    /* the number that the next line of the fragment shader has for the driver */
    int targets; /* declared so far */
    int values;  /* uniforms that are a row's, so far */
};

/* What a body counts on, before its first line. */
static const char header[] =
    "#define SCREEN_COMPUTE\n"
    "vec4 screen_coord = vec4(0.0);\n"
    "vec4 screen_texel(float value) { return vec4(value, 0.0, 0.0, 1.0); }\n"
    "vec4 screen_texel(vec2 value) { return vec4(value, 0.0, 1.0); }\n"
    "vec4 screen_texel(vec4 value) { return value; }\n"
    "uvec4 screen_texel(uint value) { return uvec4(value, 0u, 0u, 1u); }\n"
    "uvec4 screen_texel(uvec2 value) { return uvec4(value, 0u, 1u); }\n"
    "uvec4 screen_texel(uvec4 value) { return value; }\n";

static const char area_header[] =
    "layout(location = %d) uniform ivec4 screen_area; // x, y, width, height\n";

static const char row_header[] =
    "layout(std430, binding = %d) readonly buffer screen_row_data { uvec4 screen_rows[]; };\n"
    "layout(location = %d) uniform ivec2 screen_row; // the dispatch's first, and texels of each\n"
    "ivec4 screen_area = ivec4(0);\n"
    "void screen_take(uvec4 row, out int value) { value = int(row.x); }\n"
    "void screen_take(uvec4 row, out float value) { value = uintBitsToFloat(row.x); }\n"
    "void screen_take(uvec4 row, out vec2 value) { value = uintBitsToFloat(row.xy); }\n"
    "void screen_take(uvec4 row, out ivec4 value) { value = ivec4(row); }\n"
    "void screen_take(uvec4 row, out vec4 value) { value = uintBitsToFloat(row); }\n";

/* Pixels as x | y << 16, and the workgroups of the indirect dispatch over them: of as many
 * invocations as those of a picture, side by side up to what OpenGL promises, then in
 * further rows. */
static const char queue_header[] =
    "layout(std430, binding = %d) %sbuffer screen_queue_data {\n"
    "    uint screen_queue_x, screen_queue_y, screen_queue_z, screen_queue_count;\n"
    "    uint screen_queue[];\n"
    "};\n"
    "const uint SCREEN_QUEUE_GROUP = %du, SCREEN_QUEUE_WIDE = 32768u;\n";

/* One atomic addition a workgroup, as all of the picture add to one number. */
static const char mark_header[] =
    "shared uint screen_group_count, screen_group_first;\n"
    "bool screen_kept = false;\n"
    "void screen_mark(ivec2 pixel) {\n"
    "    bool counts = gl_LocalInvocationIndex == 0u;\n"
    "    if (counts)\n"
    "        screen_group_count = 0u;\n"
    "    barrier();\n"
    "    uint own = screen_kept ? atomicAdd(screen_group_count, 1u) : 0u;\n"
    "    barrier();\n"
    "    if (counts && screen_group_count > 0u) {\n"
    "        screen_group_first = atomicAdd(screen_queue_count, screen_group_count);\n"
    "        uint last = (screen_group_first + screen_group_count - 1u) / SCREEN_QUEUE_GROUP;\n"
    "        atomicMax(screen_queue_x, min(last + 1u, SCREEN_QUEUE_WIDE));\n"
    "        atomicMax(screen_queue_y, last / SCREEN_QUEUE_WIDE + 1u);\n"
    "    }\n"
    "    barrier();\n"
    "    if (screen_kept)\n"
    "        screen_queue[screen_group_first + own] = uint(pixel.x | pixel.y << 16);\n"
    "}\n";

static const char blend_header[] = "layout(location = %d) uniform bool screen_adds;\n";

static const char layer_header[] = "layout(location = %d) uniform int first_layer;\n";

static void write_header(struct rewriting *to) {
    text_print(&to->text, "%s", header);
    if (to->desc->tiled)
        text_print(&to->text, row_header, STORAGE_SCREEN_ROWS, LOCATION_SCREEN_ROW);
    else if (!to->desc->masked)
        text_print(&to->text, area_header, LOCATION_SCREEN_AREA);
    if (to->desc->marks || to->desc->masked)
        text_print(&to->text, queue_header, STORAGE_SCREEN_QUEUE,
                   to->desc->masked ? "readonly " : "", SCREEN_GROUP * SCREEN_GROUP);
    if (to->desc->marks)
        text_print(&to->text, "%s", mark_header);
    if (to->desc->blended)
        text_print(&to->text, blend_header, LOCATION_SCREEN_ADDS);
    if (to->desc->layers)
        text_print(&to->text, layer_header, LOCATION_FIRST_LAYER);
}

/* --- lines ------------------------------------------------------------------------------------ */

static void resume(struct rewriting *to) {
    text_print(&to->text, "#line %d\n", to->line + 1);
}

/* Texels outside of a list or of zeros need no sum: another dispatch row may own them. */
static void write_sum(struct rewriting *to, int number) {
    text_print(&to->text,
               "    if (screen_adds && texel == vec4(0.0))\n"
               "        return;\n"
               "    if (screen_adds)\n"
               "        texel += imageLoad(screen_target_%d, at);\n",
               number);
}

/* A variable in place of an output, and a function that stores it: which of the outputs of a file
 * there are only the preprocessor knows, so that each says it by a macro. */
static void write_target(struct rewriting *to, const char *location, const char *type,
                         const char *name) {
    const char *letter = type[0] == 'u' ? "u" : "";
    int number = to->targets++;
    text_print(&to->text, "%s %s = %s(0);\n#define SCREEN_TARGET_%d\n", type, name, type, number);
    text_print(&to->text, "layout(%sbinding = %d + %s) %suniform %simage2D%s screen_target_%d;\n",
               to->desc->blended ? "rgba32f, " : "", IMAGE_SCREEN_TARGETS, location,
               to->desc->blended ? "" : "writeonly ", letter, to->desc->layers ? "Array" : "",
               number);
    text_print(&to->text,
               "void screen_store_%d(%s at) {\n"
               "    %svec4 texel = screen_texel(%s);\n",
               number, to->desc->layers ? "ivec3" : "ivec2", letter, name);
    if (to->desc->blended)
        write_sum(to, number);
    text_print(&to->text, "    imageStore(screen_target_%d, at, texel);\n}\n", number);
    resume(to);
}

/* A variable in place of a uniform, and a function that takes it from a row: one value, or an
 * array. */
static void write_value(struct rewriting *to, const char *location, const char *type,
                        const char *name) {
    int number = to->values++, length = (int)strcspn(name, "[");
    const char *size = name + length;
    text_print(&to->text, "%s %s", type, name);
    if (!*size)
        text_print(&to->text, " = %s(0)", type);
    text_print(&to->text, ";\n#define SCREEN_VALUE_%d\nvoid screen_take_%d(int row) {\n", number,
               number);
    if (*size)
        text_print(&to->text,
                   "    for (int i = 0; i < %.*s; i++)\n"
                   "        screen_take(screen_rows[row + 1 + %s + i], %.*s[i]);\n}\n",
                   (int)strcspn(size + 1, "]"), size + 1, location, length, name);
    else
        text_print(&to->text, "    screen_take(screen_rows[row + 1 + %s], %s);\n}\n", location,
                   name);
    resume(to);
}

/* Whether the line declares what a compute shader has not; it is then written in another form. */
static bool write_declaration(struct rewriting *to, const char *line) {
    char location[64], type[16], name[64];
    if (sscanf(line, "layout(location = %63[^)]) out %15s %63[^;];", location, type, name) == 3)
        write_target(to, location, type, name);
    else if (to->desc->tiled && sscanf(line, "layout(location = %63[^)]) uniform %15s %63[^;];",
                                       location, type, name) == 3)
        write_value(to, location, type, name);
    else if (sscanf(line, "flat in %15s %63[^;];", type, name) == 2)
        text_print(&to->text, "%s %s = %s(0);\n", type, name, type);
    else if (strncmp(line, "layout(early_fragment_tests) in;", 32) == 0)
        text_print(&to->text, "\n");
    else if (strncmp(line, "void main() {", 13) == 0)
        text_print(&to->text, "void screen_body() {\n");
    else
        return false;
    return true;
}

/* Of a body that marks pixels. */
static bool write_discard(struct rewriting *to, const char *line) {
    if (!to->desc->marks || strcmp(line + strspn(line, " "), "discard;") != 0)
        return false;
    text_print(&to->text, "{ screen_kept = false; return; }\n");
    return true;
}

static void write_line(struct rewriting *to, const char *line) {
    static const char coord[] = "gl_FragCoord";
    for (const char *found; (found = strstr(line, coord)); line = found + sizeof coord - 1) {
        text_append(&to->text, line, (size_t)(found - line));
        text_print(&to->text, "screen_coord");
    }
    text_print(&to->text, "%s\n", line);
}

/* --- the end ---------------------------------------------------------------------------------- */

static void take_row(struct rewriting *to) {
    text_print(&to->text, "    int row = (screen_row.x + int(gl_WorkGroupID.z)) * screen_row.y;\n"
                          "    screen_area = ivec4(screen_rows[row]);\n");
    for (int i = 0; i < to->values; i++)
        text_print(&to->text, "#ifdef SCREEN_VALUE_%d\n    screen_take_%d(row);\n#endif\n", i, i);
    text_print(&to->text, "#ifdef SCREEN_BEGIN\n    SCREEN_BEGIN;\n#endif\n");
}

static const char coord_of_pixel[] = "    screen_coord = vec4(vec2(pixel) + 0.5, 0.0, 1.0);\n";

/* Where main is, or its end where there is no pixel. */
static void find_pixel(struct rewriting *to) {
    if (to->desc->masked)
        text_print(
            &to->text,
            "    uint group = gl_WorkGroupID.y * SCREEN_QUEUE_WIDE + gl_WorkGroupID.x;\n"
            "    uint entry = group * SCREEN_QUEUE_GROUP + gl_LocalInvocationIndex;\n"
            "    if (entry >= screen_queue_count)\n"
            "        return;\n"
            "    ivec2 pixel = ivec2(screen_queue[entry] & 0xffffu, screen_queue[entry] >> 16);\n");
    else
        text_print(&to->text, "    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);\n"
                              "    if (any(greaterThanEqual(pixel, screen_area.zw)))\n"
                              "        return;\n"
                              "    pixel += screen_area.xy;\n");
    text_print(&to->text, "%s", coord_of_pixel);
}

/* All invocations of a workgroup count together, those beside the picture too. */
static void write_marking_main(struct rewriting *to) {
    text_print(&to->text,
               "    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);\n"
               "    screen_kept = all(lessThan(pixel, screen_area.zw));\n"
               "    pixel += screen_area.xy;\n"
               "%s"
               "    if (screen_kept)\n"
               "        screen_body();\n"
               "    screen_mark(pixel);\n",
               coord_of_pixel);
}

static void write_storing_main(struct rewriting *to) {
    bool layers = to->desc->layers;
    if (to->desc->tiled)
        take_row(to);
    find_pixel(to);
    if (layers)
        text_print(&to->text, "    instance = int(gl_WorkGroupID.z);\n");
    text_print(&to->text, "    screen_body();\n");
    for (int i = 0; i < to->targets; i++)
        text_print(&to->text, "#ifdef SCREEN_TARGET_%d\n    screen_store_%d(%s);\n#endif\n", i, i,
                   layers ? "ivec3(pixel, first_layer + instance)" : "pixel");
}

static void write_main(struct rewriting *to) {
    text_print(&to->text,
               "layout(local_size_x = %d, local_size_y = %d) in;\n"
               "void main() {\n",
               SCREEN_GROUP, SCREEN_GROUP);
    if (to->desc->marks)
        write_marking_main(to);
    else
        write_storing_main(to);
    text_print(&to->text, "}\n");
}

/* The version and the defines stay first: the header follows them. Lines are cut apart, for what
 * reads a line measures all text up to a zero. */
char *screen_glsl(const char *text, const struct screen_desc *desc) {
    struct rewriting to = {.desc = desc};
    bool begun = false;
    char *lines = mem_strdup(text), *rest = lines;
    for (char *line; (line = strsep(&rest, "\n"));) {
        if (!begun && strncmp(line, "#ifndef", 7) == 0) {
            begun = true;
            write_header(&to);
        }
        if (sscanf(line, "#line %d", &to.line) == 1)
            to.line--;
        if (!write_declaration(&to, line) && !write_discard(&to, line))
            write_line(&to, line);
        to.line++;
    }
    free(lines);
    assert(begun);
    write_main(&to);
    return to.text.data;
}
