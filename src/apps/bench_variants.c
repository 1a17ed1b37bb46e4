/* Variants: named sets of settings that are compared in one run. */
#include "apps/bench.h"

#include "base/error.h"
#include "base/memory.h"

#include <string.h>

static const struct variant {
    const char *name, *assignments, *help;
} variants[] = {
    {"paper", "technique=clustered,path=paper", "clustered visibility as in the paper"},
    {"fast", "technique=clustered", "clustered visibility at its best"},
    {"instant-radiosity", "technique=instant-radiosity", "a hard shadow map per VPL"},
    {"unshadowed", "technique=unshadowed", "no visibility"},
};

enum { VARIANT_COUNT = sizeof variants / sizeof *variants };

/* Compared unless --variant says otherwise. */
static const char *const usual_variants[] = {"paper", "fast"};

enum { USUAL_VARIANTS = sizeof usual_variants / sizeof *usual_variants };

void bench_print_variants(FILE *out, const void *values) {
    (void)values;
    fprintf(out, "\nvariants, for --variant:\n");
    for (const struct variant *v = variants; v < variants + VARIANT_COUNT; v++)
        fprintf(out, "  %-18s %s (%s)\n", v->name, v->help, v->assignments);
    fprintf(out, "or one of your own, such as NAME:technique=clustered,vals=8\n");
}

static bool apply_variant(struct bench_case *prepared, const char *text) {
    size_t length = strcspn(text, ":");
    snprintf(prepared->series, sizeof prepared->series, "%.*s", (int)length, text);
    if (text[length] == ':')
        return bench_assign_all(prepared, text + length + 1) || error_prefix("variant %s", text);
    for (const struct variant *v = variants; v < variants + VARIANT_COUNT; v++)
        if (strcmp(v->name, text) == 0)
            return bench_assign_all(prepared, v->assignments) || error_prefix("variant %s", text);
    return error_set("no variant is called '%s' (--help lists them)", text);
}

bool bench_prepare(struct bench_case *prepared, const struct bench_values *values,
                   const struct stage *stage, const char *variant) {
    *prepared = (struct bench_case){
        .technique = technique_default, .width = values->size[0], .height = values->size[1]};
    snprintf(prepared->scene, sizeof prepared->scene, "%s", stage->name);
    renderer_settings_init(&prepared->settings);
    if (!apply_variant(prepared, variant))
        return false;
    for (int i = 0; i < values->settings.count; i++)
        if (!bench_assign(prepared, values->settings.items[i]))
            return false;
    return true;
}

static struct bench_case *append(struct bench_cases *cases) {
    cases->items = mem_resize(cases->items, (size_t)cases->count + 1, sizeof *cases->items);
    return &cases->items[cases->count++];
}

static bool list_variant(struct bench_cases *cases, const struct bench_values *values,
                         const struct stage *stage, const struct sweep *sweep,
                         const char *variant) {
    for (int point = 0; point < sweep_point_count(sweep); point++) {
        struct bench_case *prepared = append(cases);
        if (!bench_prepare(prepared, values, stage, variant))
            return false;
        sweep_apply(sweep, point, prepared);
        if (!technique_check(prepared->technique, &prepared->settings))
            return error_prefix("%s %s", prepared->series, prepared->label);
    }
    return true;
}

int bench_variant_count(const struct bench_values *values) {
    return values->variants.count ? values->variants.count : USUAL_VARIANTS;
}

bool bench_list_cases(struct bench_cases *cases, const struct bench_values *values,
                      const struct stage *stage, const struct sweep *sweep) {
    if (values->variants.count == 0 && sweep_has_series(sweep))
        return list_variant(cases, values, stage, sweep, ":");
    const char *const *names = values->variants.count ? values->variants.items : usual_variants;
    bool ok = true;
    for (int i = 0; ok && i < bench_variant_count(values); i++)
        ok = list_variant(cases, values, stage, sweep, names[i]);
    return ok;
}
