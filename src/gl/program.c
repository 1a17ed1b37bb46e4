#include "gl/program.h"

#include "base/error.h"
#include "gl/glsl.h"

#include <stdlib.h>

static bool check_compiled(GLuint shader, const struct glsl_source *source, const char *file) {
    GLint ok;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok)
        return true;
    char message[1500] = "";
    gl.GetShaderInfoLog(shader, sizeof message, NULL, message);
    char *explained = glsl_explain(source, message);
    error_set("shader %s does not compile:\n%s", file, explained);
    free(explained);
    return false;
}

static bool attach(GLuint program, GLenum stage, const char *file, const char *defines) {
    if (!file)
        return true;
    struct glsl_source source;
    if (!glsl_load(&source, file, defines))
        return false;
    GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, 1, (const char *const *)&source.text, NULL);
    gl.CompileShader(shader);
    bool ok = check_compiled(shader, &source, file);
    if (ok)
        gl.AttachShader(program, shader);
    gl.DeleteShader(shader); /* lives on while attached */
    glsl_free(&source);
    return ok;
}

static bool link(GLuint program, const struct program_desc *desc) {
    if (desc->varyings) {
        int count = 0;
        while (desc->varyings[count])
            count++;
        gl.TransformFeedbackVaryings(program, count, desc->varyings, GL_INTERLEAVED_ATTRIBS);
    }
    gl.LinkProgram(program);
    GLint ok;
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok)
        return true;
    char message[1500] = "";
    gl.GetProgramInfoLog(program, sizeof message, NULL, message);
    return error_set("shaders %s do not link: %s", desc->compute ? desc->compute : desc->vertex,
                     message);
}

bool program_init(GLuint *program, const struct program_desc *desc) {
    *program = gl.CreateProgram();
    if (attach(*program, GL_VERTEX_SHADER, desc->vertex, desc->defines) &&
        attach(*program, GL_FRAGMENT_SHADER, desc->fragment, desc->defines) &&
        attach(*program, GL_COMPUTE_SHADER, desc->compute, desc->defines) && link(*program, desc))
        return true;
    program_free(program);
    return false;
}

void program_free(GLuint *program) {
    if (*program)
        gl.DeleteProgram(*program);
    *program = 0;
}
