/* Checks outputs of pictures: files, and standard output, which is called "-".
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
/* For pictures with all layers. */
#define EXR_FORMAT_OPTION(type, member)                                                            \
    {"format", 0, OPTION_TEXT, offsetof(type, member), .value_name = "exr",                        \
     .help = "exr: needed if the output's name does not end in .exr, for example - (standard\n"    \
             "output) or /dev/fd/63"}
/* clang-format on */

/* Sets the format of outputs without a known extension. Call it before any function that asks
 * for an output's format. NULL: no --format. Error: an unknown format, no output that needs it,
 * or two outputs to standard output. */
bool outputs_use_format(const char *const *paths, int count, const char *format);

/* Returns true if the file is a complete picture of that size. Else a note says that an existing
 * file is rendered again. */
bool output_is_there(const char *path, int width, int height);

/* Returns the stream for tables and JSON: stderr if a picture goes to stdout. */
FILE *outputs_table_stream(const char *const *paths, int count);

/* Returns true if at most one input is "-", standard input. Error: more than one. */
bool inputs_check(const char *const *paths, int count);

#endif
