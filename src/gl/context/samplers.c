#include "gl/context/samplers.h"

#include "base/log.h"

#include <stddef.h>

enum { UNITS = 96 };

static const struct {
    GLenum type, binding;
} kinds[] = {
    {GL_SAMPLER_2D, GL_TEXTURE_BINDING_2D},
    {GL_INT_SAMPLER_2D, GL_TEXTURE_BINDING_2D},
    {GL_UNSIGNED_INT_SAMPLER_2D, GL_TEXTURE_BINDING_2D},
    {GL_SAMPLER_3D, GL_TEXTURE_BINDING_3D},
    {GL_SAMPLER_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    {GL_INT_SAMPLER_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    {GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    {GL_SAMPLER_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY},
    {GL_SAMPLER_BUFFER, GL_TEXTURE_BINDING_BUFFER},
    {GL_INT_SAMPLER_BUFFER, GL_TEXTURE_BINDING_BUFFER},
    {GL_UNSIGNED_INT_SAMPLER_BUFFER, GL_TEXTURE_BINDING_BUFFER},
};

/* 0: no sampler. */
static GLenum binding_of(GLenum type) {
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (kinds[i].type == type)
            return kinds[i].binding;
    return 0;
}

static void complain(const char *name, GLint unit, const char *what) {
    ++*gl.watched.faults;
    log_warning("OpenGL: sampler '%s' of unit %d %s", name, unit, what);
}

/* All textures are made whole (gl/texture.c): one that is there has its levels. An array has a
 * location and a unit for each element. */
static void check_sampler(GLuint program, const char *name, GLint element, GLenum binding,
                          bool taken[UNITS]) {
    GLint unit = 0, texture = 0;
    gl.GetUniformiv(program, gl.GetUniformLocation(program, name) + element, &unit);
    gl.ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl.GetIntegerv(binding, &texture);
    if (!texture)
        complain(name, unit, "has no texture of its kind");
    if (taken[unit])
        complain(name, unit, "shares it with another");
    taken[unit] = true;
}

static void check_program(void) {
    bool taken[UNITS] = {false};
    GLint program = 0, count = 0;
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
    gl.GetProgramiv((GLuint)program, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < (GLuint)count; i++) {
        char name[128];
        GLint size;
        GLenum type;
        gl.GetActiveUniform((GLuint)program, i, sizeof name, NULL, &size, &type, name);
        GLenum binding = binding_of(type);
        for (GLint element = 0; binding && element < size; element++)
            check_sampler((GLuint)program, name, element, binding, taken);
    }
}

static void APIENTRY draw_arrays(GLenum mode, GLint first, GLsizei count) {
    check_program();
    gl.watched.DrawArrays(mode, first, count);
}

static void APIENTRY draw_arrays_instanced(GLenum mode, GLint first, GLsizei count,
                                           GLsizei instances) {
    check_program();
    gl.watched.DrawArraysInstanced(mode, first, count, instances);
}

static void APIENTRY draw_elements_instanced(GLenum mode, GLsizei count, GLenum type,
                                             const void *indices, GLsizei instances, GLint base) {
    check_program();
    gl.watched.DrawElementsInstancedBaseVertex(mode, count, type, indices, instances, base);
}

static void APIENTRY dispatch_compute(GLuint x, GLuint y, GLuint z) {
    check_program();
    gl.watched.DispatchCompute(x, y, z);
}

static void APIENTRY dispatch_compute_indirect(GLintptr offset) {
    check_program();
    gl.watched.DispatchComputeIndirect(offset);
}

void samplers_watch(struct gl_api *api, int *faults) {
    api->watched = (struct gl_watched){
        api->DrawArrays,      api->DrawArraysInstanced,     api->DrawElementsInstancedBaseVertex,
        api->DispatchCompute, api->DispatchComputeIndirect, faults};
    api->DrawArrays = draw_arrays;
    api->DrawArraysInstanced = draw_arrays_instanced;
    api->DrawElementsInstancedBaseVertex = draw_elements_instanced;
    api->DispatchCompute = dispatch_compute;
    api->DispatchComputeIndirect = dispatch_compute_indirect;
}
