/* What C and GLSL share: that C's structs lie in memory as std140 has them, in every header below
 * glsl/shared, those to come included. C packs them without gaps, as all is made of words; so it is
 * enough that each member begins where std140 would begin it. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include "gl/glsl_embedded.h"

#include <ctype.h>

/* Words. A struct's own size is told by its own check: a multiple of four. */
static const struct type {
    const char *name;
    int size, alignment;
} types[] = {
    {"float", 1, 1}, {"int", 1, 1},  {"BOOL", 1, 1},  {"vec2", 2, 2},   {"ivec2", 2, 2},
    {"vec3", 3, 4},  {"vec4", 4, 4}, {"mat4", 16, 4}, {"STRUCT", 4, 4},
};

static const struct type *find_type(const char *name) {
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(types[i].name, name) == 0)
            return &types[i];
    fail_msg("no type '%s' in blocks", name);
    return NULL;
}

/* The text without its comments. */
static char *code_of(const char *text) {
    char *code = mem_strdup(text), *to = code;
    for (const char *from = code; *from;) {
        const char *end = strncmp(from, "/*", 2) == 0 ? strstr(from, "*/") : NULL;
        if (end)
            from = end + 2;
        else
            *to++ = *from++;
    }
    *to = '\0';
    return code;
}

/* One member after `offset` words; where it ends. */
static int check_member(const char *block, const struct type *type, const char *name, int offset) {
    bool is_array = strchr(name, '[') != NULL;
    if (offset % (is_array ? 4 : type->alignment) != 0)
        fail_msg("%s: %s begins %d words in, which is not where std140 has it", block, name,
                 offset);
    if (is_array && type->size % 4 != 0)
        fail_msg("%s: the rows of %s are padded by std140", block, name);
    return offset + type->size;
}

/* "TYPE name, name" or "STRUCT(type) name". */
static int check_declaration(const char *block, char *declaration, int offset) {
    char *rest = NULL, *word = strtok_r(declaration, " \n(", &rest);
    const struct type *type = find_type(word);
    if (strcmp(type->name, "STRUCT") == 0)
        strtok_r(NULL, ")", &rest);
    for (char *name = strtok_r(NULL, ",", &rest); name; name = strtok_r(NULL, ",", &rest))
        offset = check_member(block, type, name + strspn(name, " \n"), offset);
    return offset;
}

static void check_struct(const char *code, char *name, char *body) {
    char asserted[64], *rest = NULL;
    int words = 0;
    for (char *line = strtok_r(body, ";", &rest); line; line = strtok_r(NULL, ";", &rest))
        if (line[strspn(line, " \n")])
            words = check_declaration(name, line, words);
    printf("    %-24s %d words but for its arrays and structs\n", name, words);
    if (words % 4 != 0)
        fail_msg("%s ends %d words in: std140 pads it", name, words);
    snprintf(asserted, sizeof asserted, "(%s, ", name);
    if (!strstr(code, asserted))
        fail_msg("%s: no STD140_SIZE and no PASS_BLOCK tells its size", name);
}

/* How many structs the header has. */
static int check_header(const char *text) {
    char *code = code_of(text), *searched = mem_strdup(code);
    int count = 0;
    for (char *at = searched; (at = strstr(at, "\nstruct ")); count++) {
        char *name = at + strlen("\nstruct "), *open = strchr(name, '{');
        char *close = strstr(open, "\n}");
        name[strcspn(name, " ")] = '\0';
        *close = '\0';
        check_struct(code, name, open + 1);
        at = close + 1;
    }
    mem_free(searched, code);
    return count;
}

TEST(layouts) {
    int count = 0;
    for (const struct glsl_file *file = glsl_embedded; file->name; file++)
        if (strncmp(file->name, "shared/", 7) == 0)
            count += check_header(file->text);
    printf("    %d structs\n", count);
    assert_true(count > 15);
}

/* A number has one name within its kind. Texture units have arrays, and numbers of passes:
 * test/shaders/check. */
TEST(bindings) {
    static const char kind[] = "#define BLOCK_";
    const struct glsl_file *file = glsl_embedded;
    while (file->name && strcmp(file->name, "shared/bindings.h") != 0)
        file++;
    assert_non_null(file->name);
    bool taken[84] = {false};
    int count = 0;
    for (const char *at = file->text; (at = strstr(at, kind)); count++) {
        at += strlen(kind);
        int number = atoi(at + strcspn(at, " "));
        assert_true(number >= 0 && number <= 83);
        if (taken[number])
            fail_msg("%s...: %d is taken twice", kind, number);
        taken[number] = true;
    }
    printf("    %s... %d\n", kind, count);
    assert_true(count > 5);
}

RUN_TESTS(NULL, NULL)
