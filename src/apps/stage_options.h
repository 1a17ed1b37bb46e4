/* The options of every subcommand that shows a scene: which camera, lights and animation.
 *
 *     struct values { struct common_values common; struct stage_desc stage; };
 *
 *     static const struct option options[] = {
 *         STAGE_OPTIONS(struct values, stage),
 */
#ifndef APPS_STAGE_OPTIONS_H
#define APPS_STAGE_OPTIONS_H

#include "base/option.h"

/* Rows for a member that has camera, light and clip, as a struct stage_desc. */
/* clang-format off */
#define STAGE_OPTIONS(type, member)                                                                \
    {"camera", 0, OPTION_TEXT, offsetof(type, member.camera), .value_name = "NAME|N",              \
     .help = "camera of the scene [the first], or changed: \"0 eye=0,1,3 forward=0,0,-1\""},       \
    {"light", 0, OPTION_TEXT, offsetof(type, member.light), .value_name = "NAME|N,...",            \
     .help = "lights of the scene that shine [all], or changed: \"lamp,2\",\n"                     \
             "\"0 position=0,2,0 intensity=9,9,9; 1\""},                                           \
    {"clip", 0, OPTION_TEXT, offsetof(type, member.clip), .value_name = "NAME|N",                  \
     .help = "animation of the scene [the first]"}
/* clang-format on */

#endif
