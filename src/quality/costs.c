#include "quality/costs.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/folder.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "gl/api.h"
#include "quality/quality.h"
#include "quality/time_budget.h"
#include "scene/hash.h"

#include "version.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

void costs_free(struct costs *costs) {
    for (int i = 0; i < costs->count; i++)
        free(costs->items[i].choice);
    free(costs->items);
    *costs = (struct costs){0};
}

/* NULL: there is none. */
static struct cost *find(const struct costs *costs, const char *choice) {
    for (int i = 0; costs && i < costs->count; i++)
        if (strcmp(costs->items[i].choice, choice) == 0)
            return &costs->items[i];
    return NULL;
}

void costs_add(struct costs *costs, const char *choice, double ms) {
    size_t count = (size_t)costs->count++;
    costs->items = mem_resize(costs->items, count + 1, sizeof *costs->items);
    costs->items[count] = (struct cost){mem_strdup(choice), ms};
}

char *costs_choice(const char *technique, const char *settings) {
    return mem_printf("technique=%s%s%s", technique ? technique : technique_default->name,
                      *settings ? " " : "", settings);
}

double costs_find(const struct costs *costs, const char *technique, const char *settings) {
    char *choice = costs_choice(technique, settings);
    const struct cost *cost = find(costs, choice);
    free(choice);
    return cost ? cost->ms : 0;
}

static void add_once(struct costs *costs, const char *technique, const char *settings) {
    char *choice = costs_choice(technique, settings);
    if (!find(costs, choice))
        costs_add(costs, choice, 0);
    free(choice);
}

void costs_list(struct costs *costs) {
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    int count = quality_ladder(choices, 1, NULL);
    *costs = (struct costs){0};
    for (const struct preset *p = technique_default->presets; p && p->name; p++) {
        char *path = mem_printf("path=%s", p->name);
        add_once(costs, NULL, path);
        free(path);
    }
    for (int i = 0; i < count; i++)
        add_once(costs, choices[i].technique, choices[i].settings);
    for (int row = 0; row < TIME_BUDGET_ROWS; row++) {
        char *settings = time_budget_settings(time_budget_level_of_row(row));
        add_once(costs, NULL, settings);
        free(settings);
    }
}

/* --- the file --------------------------------------------------------------------------------- */

enum { SIZE_MOST = 1 << 16 };

static const char *gl_text(GLenum name) {
    return (const char *)gl.GetString(name);
}

char *costs_path(void) {
    char *folder = folder_of_user("XDG_CACHE_HOME", ".cache");
    if (!folder)
        return NULL;
    int cores = parallel_core_count();
    uint64_t sum = 0;
    hash_bytes(&sum, gl_text(GL_VENDOR), strlen(gl_text(GL_VENDOR)));
    hash_bytes(&sum, gl_text(GL_RENDERER), strlen(gl_text(GL_RENDERER)));
    hash_bytes(&sum, &cores, sizeof cores);
    char *path = mem_printf("%s/costs-%016llx.txt", folder, (unsigned long long)sum);
    free(folder);
    return path;
}

static const char first_line[] =
    "# what frames cost, measured by manylight tune: milliseconds and a choice a line\n";

/* The lines before the figures; the caller frees them. */
static char *header(void) {
    return mem_printf("%s# %s\n# %s\n# %s\n# %d cores\n# manylight %s\n", first_line,
                      gl_text(GL_VENDOR), gl_text(GL_RENDERER), gl_text(GL_VERSION),
                      parallel_core_count(), MANYLIGHT_VERSION);
}

bool costs_write(const struct costs *costs, const char *path) {
    struct text text = {0};
    char *head = header();
    text_print(&text, "%s", head);
    for (int i = 0; i < costs->count; i++)
        text_print(&text, "%.4g %s\n", costs->items[i].ms, costs->items[i].choice);
    bool ok = folder_make_for(path) && output_file_write(path, text.data, text.length);
    free(head);
    free(text.data);
    return ok;
}

static bool parse_lines(struct costs *costs, char *line) {
    for (char *end; *line; line = end + 1) {
        char *rest;
        end = strchr(line, '\n');
        if (!end)
            return error_set("its last line has no end");
        *end = '\0';
        double ms = strtod(line, &rest);
        if (rest == line || *rest != ' ' || !(ms > 0) || isinf(ms))
            return error_set("'%.40s' is no line of it", line);
        if (find(costs, rest + 1))
            return error_set("'%.40s' is there twice", rest + 1);
        costs_add(costs, rest + 1, ms);
    }
    return true;
}

static bool check_whole(const struct costs *costs) {
    struct costs wanted;
    bool ok = true;
    costs_list(&wanted);
    for (int i = 0; ok && i < wanted.count; i++)
        ok = find(costs, wanted.items[i].choice) ||
             error_set("it lacks '%s'", wanted.items[i].choice);
    costs_free(&wanted);
    return ok;
}

static bool parse(struct costs *costs, char *text) {
    char *head = header();
    size_t length = strlen(head);
    bool is_table = strncmp(text, first_line, strlen(first_line)) == 0;
    bool ok = is_table ? strncmp(text, head, length) == 0 ||
                             error_set("it is of another machine, driver or version")
                       : error_set("it is no table of costs");
    free(head);
    return ok && parse_lines(costs, text + length) && check_whole(costs);
}

static bool read_table(struct costs *costs, const char *path) {
    struct stat status;
    if (stat(path, &status) == 0 && status.st_size > SIZE_MOST)
        return error_set("it is no table of costs");
    char *text = file_read_text(path);
    bool ok = text && parse(costs, text);
    free(text);
    return ok;
}

void costs_load(struct costs *costs) {
    struct stat status;
    char *path = costs_path();
    *costs = (struct costs){0};
    if (path && stat(path, &status) == 0) {
        if (read_table(costs, path)) {
            log_detail("costs of %s", path);
        } else {
            log_note("%s is ignored: %s; manylight tune measures anew", path, error_get());
            costs_free(costs);
        }
    }
    free(path);
}
