/* manylight info: what renders here, and what a scene holds. */
#define _POSIX_C_SOURCE 200809L
#include "apps/arguments.h"
#include "apps/facts.h"
#include "apps/options.h"
#include "apps/scene_summary.h"
#include "apps/subcommands.h"

#include "gl/api.h"

#include <stdio.h>
#include <stdlib.h>

struct values {
    struct common_values common;
    bool gl, json;
    struct scene_choice choice;
    struct context_desc context;
};

static const struct option options[] = {
    {"gl", 0, OPTION_FLAG, offsetof(struct values, gl),
     .help = "print the OpenGL implementation, its limits, and the EGL devices"},
    {"json", 0, OPTION_FLAG, offsetof(struct values, json),
     .help = "print JSON; docs/user/04-scenes-and-materials.md lists its keys"},
    SCENE_OPTION(struct values, choice),
    VARIANT_OPTION(struct values, choice),
    CONTEXT_OPTIONS(struct values, context),
    {NULL},
};

static void print_limit(struct json *json, const char *name, GLint64 value) {
    json_number(json, name, (double)value);
    if (!json->out)
        printf("  %-26s %lld\n", name, (long long)value);
}

static void print_limits(struct json *json) {
    static const struct {
        const char *name;
        GLenum limit;
    } limits[] = {
        {"texture size", GL_MAX_TEXTURE_SIZE},
        {"texture layers", GL_MAX_ARRAY_TEXTURE_LAYERS},
        {"cube map size", GL_MAX_CUBE_MAP_TEXTURE_SIZE},
        {"buffer texture texels", GL_MAX_TEXTURE_BUFFER_SIZE},
        {"texture units per stage", GL_MAX_TEXTURE_IMAGE_UNITS},
        {"texture units in all", GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS},
        {"draw buffers", GL_MAX_DRAW_BUFFERS},
        {"framebuffer layers", GL_MAX_FRAMEBUFFER_LAYERS},
        {"viewports", GL_MAX_VIEWPORTS},
        {"uniform block bytes", GL_MAX_UNIFORM_BLOCK_SIZE},
        {"uniform buffer bindings", GL_MAX_UNIFORM_BUFFER_BINDINGS},
        {"uniform buffer alignment", GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT},
        {"shader storage bytes", GL_MAX_SHADER_STORAGE_BLOCK_SIZE},
        {"shader storage bindings", GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
        {"geometry output vertices", GL_MAX_GEOMETRY_OUTPUT_VERTICES},
        {"geometry invocations", GL_MAX_GEOMETRY_SHADER_INVOCATIONS},
        {"compute invocations", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS},
        {"compute shared bytes", GL_MAX_COMPUTE_SHARED_MEMORY_SIZE},
    };
    fact_words(json, "limits\n");
    json_open(json, "limits", "{");
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        GLint64 value = 0;
        gl.GetInteger64v(limits[i].limit, &value);
        print_limit(json, limits[i].name, value);
    }
    GLint bits = 0;
    gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    print_limit(json, "timestamp bits", bits);
    json_close(json, "}");
}

static bool print_gl(struct json *json, const struct values *values) {
    char devices[4096];
    context_list_devices(devices, sizeof devices);
    json_open(json, "gl", "{");
    fact_text(json, "contexts", "ways to a context, in the order tried:\n%s\n", devices);
    struct context *context = context_create(&values->context);
    if (!context)
        return false;
    fact_text(json, "context", "context   %s, ", context_description(context));
    fact_flag(json, "software", gl.software, "software");
    fact_words(json, gl.software ? "" : "hardware");
    fact_text(json, "vendor", "\nvendor    %s\n", (const char *)gl.GetString(GL_VENDOR));
    fact_text(json, "renderer", "renderer  %s\n", (const char *)gl.GetString(GL_RENDERER));
    fact_text(json, "version", "version   %s\n", (const char *)gl.GetString(GL_VERSION));
    fact_text(json, "glsl", "GLSL      %s\n",
              (const char *)gl.GetString(GL_SHADING_LANGUAGE_VERSION));
    fact_text(json, "screen_passes", "screen    passes by %s shaders\n",
              screen_way_names[screen_way()]);
    print_limits(json);
    json_close(json, "}");
    context_free(context);
    return true;
}

static const struct arguments arguments = {
    .synopsis = "[OPTION ...] [SCENE]",
    .summary =
        "Describes a scene; without SCENE, or with --gl, describes the renderer of this machine.\n"
        "SCENE - is standard input.",
    .options = options,
    .opens_scenes = true,
    .max_positional = 1,
};

int app_info(int argc, char **argv) {
    struct values values = {0};
    const char *scene;
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, &scene, &count, &status))
        return status;
    const struct option_use uses[] = {
        {"strict root scene variant", scene, "a SCENE"},
        {"context device screen-passes gl-debug", !scene || values.gl, "--gl"},
        {NULL}};
    if (!arguments_check_use(&values.common, uses))
        return arguments_misuse(argv[0]);
    char *text = NULL; /* JSON is printed whole or not at all */
    size_t size;
    struct json json = {.out = values.json ? open_memstream(&text, &size) : NULL, .lines = 2};
    json_open(&json, NULL, "{");
    bool ok = (!scene || scene_summary_print(&json, scene, &values.choice)) &&
              ((scene && !values.gl) || print_gl(&json, &values));
    json_close(&json, "}");
    if (json.out)
        fclose(json.out);
    fputs(ok && text ? text : "", stdout);
    free(text);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
