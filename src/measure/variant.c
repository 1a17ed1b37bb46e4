#include "measure/variant.h"

#include "base/error.h"
#include "base/memory.h"

#include <stdlib.h>
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
    if (text[length])
        return measure_assign_text(desc, text + length + 1) || error_prefix("variant %s", text);
    char *assignments = assignments_of(text);
    bool ok = assignments && measure_assign_text(desc, assignments);
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
