/* Rows of options that several subcommands share. */
#ifndef APPS_OPTIONS_H
#define APPS_OPTIONS_H

#include "base/option.h"
#include "gl/context/context.h"
#include "gl/screen.h"
#include "renderer/renderer.h"

_Static_assert(sizeof(enum context_kind) == sizeof(int), "OPTION_CHOICE writes an int");

struct technique_values {
    const char *technique, *direct;
    struct text_list settings;
};

/* clang-format off */
/* Shader type of full-screen passes: the member is an int. */
#define SCREEN_OPTION(type, member)                                                                \
    {"screen-passes", 0, OPTION_CHOICE, offsetof(type, member), .choices = screen_way_names,       \
     .help = "shader type of full-screen passes, same picture; auto times both on a GPU and is\n"  \
             "fragment on software OpenGL",                                                        \
     .rare = true}

/* Source of OpenGL: the member is a struct context_desc. */
#define CONTEXT_OPTIONS(type, member)                                                              \
    {"context", 0, OPTION_CHOICE, offsetof(type, member.kind), .choices = context_kind_names,      \
     .help = "source of the OpenGL context", .rare = true},                                        \
    {"device", 0, OPTION_TEXT, offsetof(type, member.device), .check = context_check_device,       \
     .value_name = "N|cuda:N|hardware",                                                            \
     .help = "EGL device by number (manylight info --gl lists them) or CUDA device; hardware:\n"   \
             "refuses software OpenGL [the first that works]",                                     \
     .rare = true},                                                                                \
    SCREEN_OPTION(type, member.screen),                                                            \
    {"gl-debug", 0, OPTION_FLAG, offsetof(type, member.debug),                                     \
     .help = "debug context, which prints messages of OpenGL to standard error", .rare = true}

/* Help of a size that may be 0. */
#define SIZE_HELP                                                                                  \
    "size of the picture, pixels [800x800; 800 along the longer side for a camera with an\n"       \
    "aspect ratio]; the vertical field of view stays the camera's"

/* Which parts of the file to show: the member is a struct scene_choice. */
#define SCENE_OPTION(type, member)                                                                 \
    {"scene", 0, OPTION_TEXT, offsetof(type, member.scene), .value_name = "NAME|N",                \
     .help = "scene of the file by name or number [the file's default]"}
#define VARIANT_OPTION(type, member)                                                               \
    {"variant", 0, OPTION_TEXT, offsetof(type, member.variant), .value_name = "NAME|N",            \
     .help = "material variant by name or number [none] (manylight info lists them)"}

/* Camera, lights, environment, clip and time: the member has the fields of a struct stage_desc.
 * LIGHTING_OPTIONS are all but the camera. */
#define STAGE_OPTIONS(type, member)                                                                \
    {"camera", 0, OPTION_TEXT, offsetof(type, member.camera), .value_name = "NAME|N",              \
     .help = "camera by name or number [the first], with changes:\n"                               \
             "\"0 eye=0,1,3 forward=0,0,-1\", shift=X,Y (shifted lens); a pinhole:\n"             \
             "\"intrinsics=FX,FY,CX,CY,WIDTH,HEIGHT opencv=...\", 16 numbers of a pose;\n"          \
             "lens=equirectangular, cube, equidistant or equisolid (fov along the height)"},       \
    LIGHTING_OPTIONS(type, member)
#define LIGHTING_OPTIONS(type, member)                                                             \
    {"light", 0, OPTION_TEXT, offsetof(type, member.light), .value_name = "NAME|N,...",            \
     .help = "lights that shine [all]: \"lamp,1\" (manylight info lists them); "                   \
             "emitters: all area lights;\n"                                                        \
             "sky: the environment; changed: \"0 position=0,2,0 intensity=9,9,9; 1\"; "            \
             "new: \"+area\n"                                                                      \
             "size=1,1 position=0,2,0 direction=0,-1,0 intensity=9,9,9\"; "                        \
             "a name with , ; or =: by number"},                                                    \
    {"environment", 0, OPTION_TEXT, offsetof(type, member.environment.path), .value_name = "FILE", \
     .help = "environment map in place of the scene's: panorama, .hdr or .exr, in W/(sr m2); or\n" \
             "a sky by formula: \"cie:TYPE,elevation=45,azimuth=180,horizontal=10000\"\n"           \
             "or \"preetham:TURBIDITY,elevation=45,azimuth=180\""},                                 \
    {"environment-turn", 0, OPTION_FLOAT, offsetof(type, member.environment.turn), 0, -360, 360,   \
     .help = "rotation of the environment about +Y, degrees, from +Z towards +X", .rare = true},   \
    {"environment-strength", 0, OPTION_FLOAT, offsetof(type, member.environment.strength), 1,      \
     1e-9, 1e9, .help = "factor of the environment's radiance", .rare = true},                     \
    {"punctual-scale", 0, OPTION_FLOAT, offsetof(type, member.punctual_scale), 1, 1e-9, 1e9,       \
     .help = "factor of the file's punctual lights: .001464 for those of Blender 3",           \
     .rare = true},                                                                                \
    {"clip", 0, OPTION_TEXT, offsetof(type, member.clip), .value_name = "NAME|N,...",              \
     .help = "animations that play [all; the first of those that move the same object]"},          \
    {"time", 0, OPTION_FLOAT, offsetof(type, member.time), 0, 0, 1e6,                              \
     .help = "time of the animation, seconds"}

/* Technique, direct method and settings: the member is a struct technique_values. */
#define TECHNIQUE_OPTIONS(type, member)                                                            \
    {"technique", 0, OPTION_TEXT, offsetof(type, member.technique), .value_name = "NAME",          \
     .help = "technique for indirect light, listed below"},                                        \
    {"direct", 0, OPTION_TEXT, offsetof(type, member.direct), .value_name = "NAME",                \
     .help = "method for direct light, listed below"},                                             \
    {"set", 0, OPTION_LIST, offsetof(type, member.settings), .value_name = "KEY=VALUE",            \
     .help = "setting to change, listed below; repeatable"}
/* clang-format on */

/* Finds technique, direct method and all settings. *direct is NULL if --direct is not given.
 * Error: an unknown name or an invalid value. */
bool technique_values_resolve(const struct technique_values *values,
                              const struct technique **technique,
                              const struct direct_method **direct, struct settings *settings);

/* Returns true if --set gives this setting. */
bool technique_values_name(const struct technique_values *values, const struct settings_part *part,
                           const char *name);

/* Prints the end of --help: techniques, direct methods, and settings of the named technique: the
 * main ones, or all. */
void technique_values_print_help(FILE *out, const struct technique_values *values, bool all);

#endif
