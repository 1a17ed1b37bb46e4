#include "gl/context/needs.h"

#include "base/error.h"
#include "shared/light.h"
#include "shared/maps.h"
#include "shared/vpl.h"

#include <stddef.h>

static const struct {
    const char *name, *use;
} extensions[] = {
    {"GL_ARB_shader_viewport_layer_array", "vertex shaders pick the layer that they draw to"},
};

/* OpenGL 4.5 promises 16 KiB of a uniform block and 65536 texels of a buffer texture. All else that
 * the shaders count on is within its promises, or is told by the object that does not fit: sizes
 * and samples of textures. */
enum {
    VPL_BLOCK_BYTES = VPLS_PER_BLOCK * sizeof(struct vpl),
    VIEW_BLOCK_BYTES = MAP_VIEWS_MAX * sizeof(struct map_view),
    LIGHT_BLOCK_BYTES = sizeof(struct light_block),
    VPL_TEXELS = VPLS_MAX * sizeof(struct vpl) / sizeof(vec4),
};

static const struct {
    GLenum limit;
    int least;
    const char *what, *use;
} limits[] = {
    {GL_MAX_UNIFORM_BLOCK_SIZE, VPL_BLOCK_BYTES, "bytes in a uniform block", "virtual lights"},
    {GL_MAX_UNIFORM_BLOCK_SIZE, VIEW_BLOCK_BYTES, "bytes in a uniform block", "shadow maps' views"},
    {GL_MAX_UNIFORM_BLOCK_SIZE, LIGHT_BLOCK_BYTES, "bytes in a uniform block", "lights"},
    {GL_MAX_TEXTURE_BUFFER_SIZE, VPL_TEXELS, "texels in a buffer texture", "virtual lights"},
};

bool gl_needs_met(const struct gl_api *api) {
    GLint major = 0, minor = 0;
    api->GetIntegerv(GL_MAJOR_VERSION, &major);
    api->GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 45)
        return error_set("has OpenGL %d.%d, and 4.5 is needed", major, minor);
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++)
        if (!gl_has_extension(api, extensions[i].name))
            return error_set("lacks %s, by which %s", extensions[i].name, extensions[i].use);
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        GLint value = 0;
        api->GetIntegerv(limits[i].limit, &value);
        if (value < limits[i].least)
            return error_set("allows %d %s, and %d are needed for %s", value, limits[i].what,
                             limits[i].least, limits[i].use);
    }
    return true;
}
