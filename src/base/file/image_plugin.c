#define _GNU_SOURCE /* dladdr1 */
#include "base/file/image_plugin.h"

#include "base/memory.h"
#include "version.h"

#include <dlfcn.h>
#include <limits.h>
#include <link.h>
#include <pthread.h>
#include <string.h>
#include <sys/auxv.h>
#include <unistd.h>

#define NAME "libmanylight-openimageio.so"

/* --- where it lies ---------------------------------------------------------------------------- */

/* The file that this code is part of: the program or libmanylight.so. "" where the system does not
 * tell. */
static void find_own_file(char path[PATH_MAX]) {
    Dl_info symbol;
    struct link_map *object = NULL;
    path[0] = '\0';
    if (!dladdr1((const void *)&image_plugin_get, &symbol, (void **)&object, RTLD_DL_LINKMAP))
        return;
    /* The program itself has no name here. Without /proc it is what the shell started. */
    if (object && object->l_name[0]) {
        if (!realpath(object->l_name, path))
            path[0] = '\0';
    } else if (!realpath("/proc/self/exe", path) &&
               !realpath((const char *)getauxval(AT_EXECFN), path)) {
        path[0] = '\0';
    }
}

/* The path, to be freed; NULL: there is none. The folders are those of a build or a Python module,
 * of an installed library, and of an installed program. */
static char *find(void) {
    static const char *const below[] = {"", "manylight/", "../" MANYLIGHT_LIBDIR "/manylight/"};
    char own[PATH_MAX];
    find_own_file(own);
    char *slash = strrchr(own, '/');
    for (size_t i = 0; slash && i < sizeof below / sizeof *below; i++) {
        char *path = mem_printf("%.*s%s" NAME, (int)(slash + 1 - own), own, below[i]);
        if (access(path, R_OK) == 0)
            return path;
        free(path);
    }
    return NULL;
}

/* --- the object ------------------------------------------------------------------------------- */

static void pass_on(const struct log_sink *sink, enum log_kind kind, const char *message) {
    (void)sink;
    if (kind == LOG_IS_DETAIL)
        log_detail("%s", message);
    else if (kind == LOG_IS_NOTE)
        log_note("%s", message);
    else
        log_warning("%s", message);
}

static pthread_once_t found = PTHREAD_ONCE_INIT, opened = PTHREAD_ONCE_INIT;
static char *place; /* NULL: nowhere */
static const struct image_plugin *plugin;
static char *reason; /* why there is no plugin */

static void look(void) {
    place = find();
}

/* Never closed: OpenImageIO has threads. */
static void open_object(void) {
    static const struct log_sink sink = {pass_on};
    pthread_once(&found, look);
    if (!place) {
        reason = mem_strdup(NAME " is not there");
        return;
    }
    void *object = dlopen(place, RTLD_NOW | RTLD_LOCAL);
    image_plugin_entry *entry;
    *(void **)&entry = object ? dlsym(object, "manylight_openimageio") : NULL;
    const struct image_plugin *is_open = entry ? entry(&sink) : NULL;
    if (!is_open)
        reason = mem_printf("cannot open %s", dlerror());
    else if (strcmp(is_open->version, MANYLIGHT_VERSION) != 0)
        reason = mem_printf("%s is of manylight %s", place, is_open->version);
    else
        plugin = is_open;
}

const struct image_plugin *image_plugin_get(void) {
    pthread_once(&opened, open_object);
    if (!plugin)
        error_set("%s", reason);
    return plugin;
}

bool image_plugin_is_there(void) {
    pthread_once(&found, look);
    return place != NULL;
}

bool image_plugin_end(const struct image_plugin *of, bool ok) {
    if (ok)
        return true;
    return of->error_kind() == ERROR_OF_MEMORY ? error_set_memory("%s", of->error())
                                               : error_set("%s", of->error());
}
