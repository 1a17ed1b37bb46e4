/* The options of every subcommand that renders: where OpenGL comes from.
 *
 *     struct values { struct common_values common; struct context_desc context; };
 *
 *     static const struct option options[] = {
 *         CONTEXT_OPTIONS(struct values, context),
 *         ...
 *     struct context *context = context_create(&values.context);
 */
#ifndef APPS_CONTEXT_OPTIONS_H
#define APPS_CONTEXT_OPTIONS_H

#include "base/option.h"
#include "gl/context/context.h"

_Static_assert(sizeof(enum context_kind) == sizeof(int), "OPTION_CHOICE writes an int");

/* Rows for the member of that type of values that is a struct context_desc. */
/* clang-format off */
#define CONTEXT_OPTIONS(type, member)                                                              \
    {"context", 0, OPTION_CHOICE, offsetof(type, member.kind), .choices = context_kind_names,      \
     .help = "where OpenGL comes from"},                                                           \
    {"device", 0, OPTION_INT, offsetof(type, member.device), -1, -1, 999,                          \
     .help = "EGL device (manylight info lists them); -1 = the first that works"},                 \
    {"gl-debug", 0, OPTION_FLAG, offsetof(type, member.debug),                                     \
     .help = "a debug context: OpenGL's messages go to stderr"}
/* clang-format on */

#endif
