#define _DEFAULT_SOURCE
#include "gl/screen_glsl.h"

#include "base/memory.h"
#include "base/text.h"
#include "shared/bindings.h"

#include <assert.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
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

static const char mask_header[] = "layout(binding = %d) uniform sampler2D screen_mask;\n";

static const char blend_header[] = "layout(location = %d) uniform bool screen_adds;\n";

static const char layer_header[] = "layout(location = %d) uniform int first_layer;\n";

static void write_header(struct rewriting *to) {
    text_print(&to->text, "%s", header);
    if (to->desc->tiled)
        text_print(&to->text, row_header, STORAGE_SCREEN_ROWS, LOCATION_SCREEN_ROW);
    else
        text_print(&to->text, area_header, LOCATION_SCREEN_AREA);
    if (to->desc->masked)
        text_print(&to->text, mask_header, UNIT_SCREEN_MASK);
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

/* A variable in place of an output, and a function that stores it: which of the outputs of a file there are only the
 * preprocessor knows, so that each says it by a macro. */
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

/* A variable in place of a uniform, and a function that takes it from a row: one value, or an array. */
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

static void write_main(struct rewriting *to) {
    bool layers = to->desc->layers;
    text_print(&to->text,
               "layout(local_size_x = %d, local_size_y = %d) in;\n"
               "void main() {\n",
               SCREEN_GROUP, SCREEN_GROUP);
    if (to->desc->tiled)
        take_row(to);
    text_print(&to->text, "    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);\n"
                          "    if (any(greaterThanEqual(pixel, screen_area.zw)))\n"
                          "        return;\n"
                          "    pixel += screen_area.xy;\n"
                          "    screen_coord = vec4(vec2(pixel) + 0.5, 0.0, 1.0);\n");
    if (to->desc->masked)
        text_print(&to->text, "    if (texelFetch(screen_mask, pixel, 0).r != 0.0)\n"
                              "        return;\n");
    if (layers)
        text_print(&to->text, "    instance = int(gl_WorkGroupID.z);\n");
    text_print(&to->text, "    screen_body();\n");
    for (int i = 0; i < to->targets; i++)
        text_print(&to->text, "#ifdef SCREEN_TARGET_%d\n    screen_store_%d(%s);\n#endif\n", i, i,
                   layers ? "ivec3(pixel, first_layer + instance)" : "pixel");
    text_print(&to->text, "}\n");
}

/* The version and the defines stay first: the header follows them. Lines are cut apart, for what reads a line measures
 * all text up to a zero. */
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
        if (!write_declaration(&to, line))
            write_line(&to, line);
        to.line++;
    }
    free(lines);
    assert(begun);
    write_main(&to);
    return to.text.data;
}
