#define _POSIX_C_SOURCE 200809L
#include "apps/outputs.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/log.h"

#include <unistd.h>

/* How many of the paths are "-". */
static int count_standard(const char *const *paths, int count) {
    int standard = 0;
    for (int i = 0; i < count; i++)
        standard += paths[i] && output_file_is_stdout(paths[i]);
    return standard;
}

bool outputs_use_format(const char *const *paths, int count, const char *format) {
    bool needed = false;
    if (count_standard(paths, count) > 1)
        return error_set("-o -: two pictures cannot share standard output");
    if (!format)
        return true;
    for (int i = 0; i < count; i++)
        needed = needed || (paths[i] && !image_name_tells_format(paths[i]));
    if (!needed)
        return error_set("--format %s: the outputs' extensions tell their formats", format);
    return image_set_format_of_others(format);
}

bool output_is_there(const char *path, int width, int height) {
    int size[2];
    if (access(path, F_OK) != 0)
        return false;
    bool ok = image_is_whole(path) && image_size(path, size);
    if (ok && (size[0] != width || size[1] != height))
        ok = error_set("%s is %dx%d, not %dx%d", path, size[0], size[1], width, height);
    if (!ok)
        log_note("%s; it is rendered again", error_get());
    return ok;
}

FILE *outputs_table_stream(const char *const *paths, int count) {
    return count_standard(paths, count) ? stderr : stdout;
}

bool inputs_check(const char *const *paths, int count) {
    return count_standard(paths, count) <= 1 ||
           error_set("-: standard input can be only one of the pictures");
}
