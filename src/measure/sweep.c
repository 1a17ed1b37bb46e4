#include "measure/sweep.h"

#include "base/error.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct list {
    char **items;
    int count;
};

static void add(struct list *list, char *item) {
    list->items = mem_resize(list->items, (size_t)list->count + 1, sizeof *list->items);
    list->items[list->count++] = item;
}

static void free_list(struct list *list) {
    for (int i = 0; i < list->count; i++)
        free(list->items[i]);
    free(list->items);
    *list = (struct list){0};
}

static const char *full_name(const char *name, size_t *length) {
    static const char *const letters[][2] = {{"N", "vpls"}, {"M", "vals"}, {"K", "terms"}};
    for (size_t i = 0; *length == 1 && i < sizeof letters / sizeof *letters; i++)
        if (*name == *letters[i][0]) {
            *length = strlen(letters[i][1]);
            return letters[i][1];
        }
    return name;
}

/* Whether the values of "key=value" are numbers or sizes, not names. */
static bool is_numeric(const char *assignment) {
    char name[MEASURE_NAME_SIZE];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(assignment, "="), assignment);
    struct settings settings;
    struct setting setting;
    renderer_settings_init(&settings);
    return strcmp(name, "size") == 0 ||
           (settings_find(&settings, name, &setting) &&
            (setting.option->type == OPTION_INT || setting.option->type == OPTION_FLOAT));
}

/* Takes the assignment, having tried it on a desc that nobody needs. */
static bool add_value(struct list *axis, char *assignment) {
    struct measure_desc scratch = measure_default(NULL, 1, 1, false);
    add(axis, assignment);
    return measure_assign_text(&scratch, assignment);
}

/* A value, or a range of powers of two: "2..120" is 2, 4, 8 ... 64, 120. */
static bool add_values(struct list *axis, const char *name, int name_length, const char *value,
                       int length) {
    char *given = mem_printf("%.*s=%.*s", name_length, name, length, value), *end, *rest;
    const char *text = given + name_length + 1;
    long first = strtol(text, &end, 10);
    if (end == text || strncmp(end, "..", 2) != 0 || !is_numeric(given))
        return add_value(axis, given);
    long last = strtol(end + 2, &rest, 10);
    bool ok = (rest != end + 2 && !*rest && first >= 1 && last >= first) ||
              error_set("sweep: '%s' is not a range such as 2..128", given);
    for (long i = first; ok; i = 2 * i < last ? 2 * i : last) {
        ok = add_value(axis, mem_printf("%.*s=%ld", name_length, name, i));
        if (i == last)
            break;
    }
    free(given);
    return ok;
}

/* Every point so far with every value of the axis, whose list is emptied. */
static void multiply(struct sweep *sweep, struct list *axis) {
    struct list product = {0}, before = {sweep->points, sweep->count};
    for (int i = 0; i < (before.count ? before.count : 1); i++)
        for (int k = 0; k < axis->count; k++)
            add(&product, before.count ? mem_printf("%s,%s", before.items[i], axis->items[k])
                                       : mem_strdup(axis->items[k]));
    sweep->has_variants = sweep->has_variants || !is_numeric(axis->items[0]);
    free_list(&before);
    free_list(axis);
    sweep->points = product.items;
    sweep->count = product.count;
}

bool sweep_parse(struct sweep *sweep, const char *text) {
    struct list axis = {0};
    const char *name = NULL;
    size_t name_length = 0;
    bool ok = *text || error_set("sweep: nothing to vary");
    for (const char *at = text; ok && *at;) {
        size_t length = strcspn(at, ","), key = strcspn(at, "=");
        if (key < length) {
            if (axis.count)
                multiply(sweep, &axis);
            name_length = key;
            name = full_name(at, &name_length);
            at += key + 1, length -= key + 1;
        }
        bool more = at[length] == ',';
        ok = (name && name_length && length && (!more || at[length + 1]))
                 ? add_values(&axis, name, (int)name_length, at, (int)length)
                 : error_set("sweep: '%s' is not KEY=VALUE,VALUE...", text);
        at += length + more;
    }
    if (ok)
        multiply(sweep, &axis);
    free_list(&axis);
    return ok;
}

void sweep_free(struct sweep *sweep) {
    free_list(&(struct list){sweep->points, sweep->count});
    *sweep = (struct sweep){0};
}

static bool append(char name[MEASURE_NAME_SIZE], const char *word, int length) {
    size_t used = strlen(name);
    int size =
        snprintf(name + used, MEASURE_NAME_SIZE - used, "%s%.*s", used ? " " : "", length, word);
    return (size_t)size < MEASURE_NAME_SIZE - used ||
           error_set("sweep: %s ...: too many things to vary", name);
}

bool sweep_apply(const char *point, struct measure_desc *desc) {
    bool ok = measure_assign_text(desc, point);
    for (const char *at = point; ok && *at;) {
        int length = (int)strcspn(at, ","), key = (int)strcspn(at, "=") + 1;
        ok = is_numeric(at) ? append(desc->point, at, length)
                            : append(desc->variant, at + key, length - key);
        at += length + (at[length] == ',');
    }
    return ok;
}
