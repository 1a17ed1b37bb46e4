/* Where pictures go: files, and standard output, which is called "-".
 *
 *     struct values { const char *output, *format; };
 *     ...
 *     FORMAT_OPTION(struct values, format),
 *     ...
 *     if (!outputs_use_format(&values.output, 1, values.format))
 *         return arguments_misuse(argv[0]);
 */
#ifndef APPS_OUTPUTS_H
#define APPS_OUTPUTS_H

#include "base/option.h"

#include <stdbool.h>
#include <stdio.h>

/* clang-format off */
#define FORMAT_OPTION(type, member)                                                                \
    {"format", 0, OPTION_TEXT, offsetof(type, member), .value_name = "png|exr|...",                \
     .help = "format of outputs whose names have no known extension, for example - (standard\n"    \
             "output) or /dev/fd/63"}
/* Of pictures with all layers. */
#define EXR_FORMAT_OPTION(type, member)                                                            \
    {"format", 0, OPTION_TEXT, offsetof(type, member), .value_name = "exr",                        \
     .help = "exr: needed if the output's name does not end in .exr, for example - (standard\n"    \
             "output) or /dev/fd/63"}
/* clang-format on */

/* Call it before outputs are asked for their format; format is NULL without --format. Error: it is
 * not known, no output needs it, or two go to standard output. */
bool outputs_use_format(const char *const *paths, int count, const char *format);

/* Whether a file is a whole picture of that size; else a note says that it is rendered again, where
 * there is one. */
bool output_is_there(const char *path, int width, int height);

/* The stream for tables and JSON: stderr where a picture goes to stdout. */
FILE *outputs_table_stream(const char *const *paths, int count);

/* Whether standard input, "-", is one of the inputs at most. Error: it is not. */
bool inputs_check(const char *const *paths, int count);

#endif
