/* The options that say how a picture is made, for every subcommand that renders. */
#ifndef APPS_TECHNIQUE_OPTIONS_H
#define APPS_TECHNIQUE_OPTIONS_H

#include "renderer/renderer.h"

struct technique_values {
    const char *technique, *direct;
    struct text_list settings;
};

/* Rows for an option table; member is the subcommand's struct technique_values. */
#define TECHNIQUE_OPTIONS(type, member)                                                            \
    {"technique",          0,                                                                      \
     OPTION_TEXT,          offsetof(type, member.technique),                                       \
     .value_name = "NAME", .help = "how indirect light is made; --help lists them"},               \
        {"direct",                                                                                 \
         0,                                                                                        \
         OPTION_TEXT,                                                                              \
         offsetof(type, member.direct),                                                            \
         .value_name = "NAME",                                                                     \
         .help = "how direct light is made; --help lists them"},                                   \
    {                                                                                              \
        "set", 0, OPTION_LIST, offsetof(type, member.settings),                                    \
            .value_name = "KEY=VALUE", .help = "a setting of the list below; repeatable"           \
    }

/* Fills technique, direct and settings of the desc. Error: of a name or a value. */
bool technique_values_resolve(const struct technique_values *values, struct renderer_desc *desc);

/* The end of --help: techniques, direct methods, and the settings of those that are named. */
void technique_values_print_help(FILE *out, const struct technique_values *values);

#endif
