#include "null_driver.h"

#include "base/memory.h"
#include "gl/api.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHADERS_MAX = 8192 };

static struct kept_shader {
    const char *extension;
    char *text;
    int file;
} shaders[SHADERS_MAX];
static int shader_count, kept_count;
static const char *kept_folder;

void null_driver_keep(const char *folder) {
    kept_folder = folder;
}

int null_driver_count(void) {
    return kept_count;
}

/* --- shaders --- */

static const char *extension_of(GLenum type) {
    switch (type) {
    case GL_VERTEX_SHADER:
        return "vert";
    case GL_GEOMETRY_SHADER:
        return "geom";
    case GL_FRAGMENT_SHADER:
        return "frag";
    default:
        return "comp";
    }
}

static GLuint create_shader(GLenum type) {
    if (shader_count == SHADERS_MAX)
        abort();
    shaders[shader_count] = (struct kept_shader){.extension = extension_of(type)};
    return (GLuint)++shader_count;
}

/* The one with the same text; else the shader. */
static const struct kept_shader *first_of(const struct kept_shader *shader) {
    const struct kept_shader *s = shaders;
    while (s < shader && (s->extension != shader->extension || strcmp(s->text, shader->text) != 0))
        s++;
    return s;
}

static void write_file(const struct kept_shader *shader) {
    char *path = mem_printf("%s/%04d.%s", kept_folder, shader->file, shader->extension);
    FILE *file = fopen(path, "wb");
    if (!file || fputs(shader->text, file) < 0 || fclose(file) != 0)
        abort();
    free(path);
}

/* One that is there already gives its number back, and its file's name to the next program. */
static void shader_source(GLuint number, GLsizei count, const GLchar *const *texts,
                          const GLint *lengths) {
    (void)count, (void)lengths;
    struct kept_shader *shader = &shaders[number - 1];
    shader->text = mem_strdup(texts[0]);
    const struct kept_shader *first = first_of(shader);
    shader->file = first == shader ? kept_count++ : first->file;
    if (first == shader) {
        write_file(shader);
        return;
    }
    free(shader->text);
    shader_count--;
}

static void attach_shader(GLuint program, GLuint number) {
    const struct kept_shader *shader = &shaders[number - 1];
    char *path = mem_printf("%s/programs", kept_folder);
    FILE *file = fopen(path, "ab");
    if (!file || fprintf(file, "%u %04d.%s\n", program, shader->file, shader->extension) < 0 ||
        fclose(file) != 0)
        abort();
    free(path);
}

static GLuint create_program(void) {
    static GLuint last;
    return ++last;
}

static void get_status(GLuint object, GLenum name, GLint *value) {
    (void)object, (void)name;
    *value = GL_TRUE;
}

/* --- all else --- */

static void create(GLsizei count, GLuint *names) {
    static GLuint last;
    for (GLsizei i = 0; i < count; i++)
        names[i] = ++last;
}

static void create_typed(GLenum type, GLsizei count, GLuint *names) {
    (void)type;
    create(count, names);
}

/* More than any driver, but of what a picture is made for: samples. */
static void get_integer(GLenum name, GLint *value) {
    *value = name == GL_MAJOR_VERSION               ? 4
             : name == GL_MINOR_VERSION             ? 5
             : name == GL_NUM_EXTENSIONS            ? 1
             : name == GL_MAX_DEPTH_TEXTURE_SAMPLES ? 4
                                                    : 1 << 20;
}

static const GLubyte *get_string(void) {
    return (const GLubyte *)"GL_ARB_shader_viewport_layer_array";
}

static GLenum is_complete(void) {
    return GL_FRAMEBUFFER_COMPLETE;
}

static void get_sample_place(GLenum name, GLuint index, GLfloat *value) {
    (void)name, (void)index;
    value[0] = value[1] = .5f;
}

/* Where depth is half there is a surface. */
static void get_image(GLuint texture, GLint level, GLenum format, GLenum type, GLsizei size,
                      void *pixels) {
    (void)texture, (void)level, (void)format;
    memset(pixels, 0, (size_t)size);
    for (size_t i = 0; type == GL_FLOAT && i < (size_t)size / sizeof(float); i++)
        ((float *)pixels)[i] = .5f;
}

static void get_part(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width,
                     GLsizei height, GLsizei depth, GLenum format, GLenum type, GLsizei size,
                     void *pixels) {
    (void)x, (void)y, (void)z, (void)width, (void)height, (void)depth;
    get_image(texture, level, format, type, size, pixels);
}

static void get_data(GLuint buffer, GLintptr offset, GLsizeiptr size, void *data) {
    (void)buffer, (void)offset;
    memset(data, 0, (size_t)size);
}

static GLuint nothing(void) {
    return 0;
}

static const struct {
    const char *name;
    void *function;
} table[] = {
    {"glCreateShader", (void *)create_shader},
    {"glShaderSource", (void *)shader_source},
    {"glAttachShader", (void *)attach_shader},
    {"glGetShaderiv", (void *)get_status},
    {"glGetProgramiv", (void *)get_status},
    {"glCreateProgram", (void *)create_program},
    {"glCreateTextures", (void *)create_typed},
    {"glCreateQueries", (void *)create_typed},
    {"glCreateBuffers", (void *)create},
    {"glCreateVertexArrays", (void *)create},
    {"glCreateFramebuffers", (void *)create},
    {"glGetIntegerv", (void *)get_integer},
    {"glGetString", (void *)get_string},
    {"glGetStringi", (void *)get_string},
    {"glCheckNamedFramebufferStatus", (void *)is_complete},
    {"glGetMultisamplefv", (void *)get_sample_place},
    {"glGetTextureImage", (void *)get_image},
    {"glGetTextureSubImage", (void *)get_part},
    {"glGetNamedBufferSubData", (void *)get_data},
};

void *null_driver_getproc(const char *name) {
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].name, name) == 0)
            return table[i].function;
    return (void *)nothing;
}
