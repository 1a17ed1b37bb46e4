#include "lab/measure/variants.h"

#include "base/error.h"
#include "base/memory.h"

#include <string.h>

/* The assignments that a name stands for; the caller frees them. NULL: there is no such name. */
static char *assignments_of(const char *name) {
    for (const struct technique *const *t = techniques; *t; t++)
        if (strcmp((*t)->name, name) == 0)
            return mem_printf("technique=%s", name);
    for (const struct preset *p = technique_default->presets; p && p->name; p++)
        if (strcmp(p->name, name) == 0)
            return mem_printf("technique=%s,path=%s", technique_default->name, name);
    error_set("no variant is called '%s' (--help lists them)", name);
    return NULL;
}

bool variant_apply(struct measure_desc *desc, const char *text) {
    size_t length = strcspn(text, ":");
    if (length >= sizeof desc->variant || strcspn(text, ",\"") < length)
        return error_set("variant %s: a name has less than %zu letters, no comma and no quote",
                         text, sizeof desc->variant);
    snprintf(desc->variant, sizeof desc->variant, "%.*s", (int)length, text);
    char *assignments = text[length] ? mem_strdup(text + length + 1) : assignments_of(text);
    bool ok =
        assignments && (measure_assign(desc, assignments) || error_prefix("variant %s", text));
    free(assignments);
    return ok;
}

void variants_print(FILE *out) {
    fprintf(out, "\nvariants, for --variant:\n");
    for (const struct preset *p = technique_default->presets; p && p->name; p++)
        fprintf(out, "  %-18s %s (technique=%s,path=%s)\n", p->name, p->help,
                technique_default->name, p->name);
    for (const struct technique *const *t = techniques; *t; t++)
        fprintf(out, "  %-18s %s (technique=%s)\n", (*t)->name, (*t)->help, (*t)->name);
    fprintf(out, "or one of your own, such as NAME:technique=clustered,vals=8\n");
}

void measure_list_add(struct measure_list *list, const struct measure_desc *desc) {
    list->items = mem_resize(list->items, (size_t)list->count + 1, sizeof *list->items);
    list->items[list->count++] = *desc;
}

/* --- grids ------------------------------------------------------------------------------------ */

static const char *full_name(const char *name) {
    return strcmp(name, "N") == 0   ? "vpls"
           : strcmp(name, "M") == 0 ? "vals"
           : strcmp(name, "K") == 0 ? "terms"
                                    : name;
}

/* Whether the values are numbers or sizes, not names. */
static bool is_numeric(const struct measure_desc *desc, const char *name) {
    struct setting setting;
    return strcmp(name, "size") == 0 ||
           (settings_find(&desc->settings, name, &setting) &&
            (setting.option->type == OPTION_INT || setting.option->type == OPTION_FLOAT));
}

static bool append(char name[MEASURE_NAME_SIZE], const char *word) {
    size_t used = strlen(name), room = MEASURE_NAME_SIZE - used;
    return (size_t)snprintf(name + used, room, "%s%s", used ? " " : "", word) < room ||
           error_set("%s ...: too many things to vary", name);
}

static bool add_value(struct measure_list *to, const struct measure_desc *desc, const char *name,
                      const char *value) {
    struct measure_desc varied = *desc;
    char *assignment = mem_printf("%s=%s", name, value);
    bool ok =
        measure_assign(&varied, assignment) &&
        (is_numeric(desc, name) ? append(varied.point, assignment) : append(varied.variant, value));
    measure_list_add(to, &varied);
    free(assignment);
    return ok;
}

/* A value, or a range of powers of two: "2..120" is 2, 4, 8 ... 64, 120. */
static bool add_values(struct measure_list *to, const struct measure_desc *desc, const char *name,
                       const char *value) {
    char *end, *rest, number[32];
    long first = strtol(value, &end, 10);
    if (end == value || strncmp(end, "..", 2) != 0 || !is_numeric(desc, name))
        return add_value(to, desc, name, value);
    long last = strtol(end + 2, &rest, 10);
    if (rest == end + 2 || *rest || first < 1 || last < first)
        return error_set("%s: '%s' is not a range such as 2..128", name, value);
    for (long i = first;; i = 2 * i < last ? 2 * i : last) {
        snprintf(number, sizeof number, "%ld", i);
        if (!add_value(to, desc, name, number))
            return false;
        if (i == last)
            return true;
    }
}

bool measure_vary(struct measure_list *list, const char *text) {
    struct measure_list product = {0};
    const char *values = strchr(text, '=');
    if (!values || values == text)
        return error_set("'%s' is not KEY=VALUE,VALUE...", text);
    char *name = mem_printf("%.*s", (int)(values - text), text);
    bool ok = true;
    for (int i = 0; ok && i < list->count; i++)
        for (const char *at = values; ok && *at; at += strcspn(at, ",")) {
            at++;
            char *value = mem_printf("%.*s", (int)strcspn(at, ","), at);
            ok = add_values(&product, &list->items[i], full_name(name), value);
            free(value);
        }
    mem_free(name, list->items);
    *list = product;
    return ok;
}
