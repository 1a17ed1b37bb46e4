/* The modes of bench that measure errors and no times. */
#include "apps/bench.h"

#include "apps/bench_budget.h"
#include "apps/bench_curves.h"
#include "base/memory.h"

#include <stdlib.h>

/* The path-traced picture that a scene's errors are held against. */
static struct bench_reference_desc truth_of(const struct bench_values *values, const char *path,
                                            const struct stage *stage, bool software) {
    return (struct bench_reference_desc){.kind = BENCH_REFERENCE_PATH,
                                         .cache = values->cache,
                                         .scene_path = path,
                                         .stage = stage,
                                         .width = values->size[0],
                                         .height = values->size[1],
                                         .noise = (double)values->noise,
                                         .software = software};
}

/* A budget for each variant that is asked for. */
static bool make_budgets(struct budget *budgets, const struct bench_values *values,
                         const char *path, bool software) {
    static const struct sweep no_sweep;
    struct stage stage;
    struct bench_cases cases = {0};
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    struct bench_reference_desc truth = truth_of(values, path, &stage, software);
    bool ok = bench_list_cases(&cases, values, &stage, &no_sweep);
    for (int i = 0; ok && i < cases.count; i++) {
        ok = budget_make(&budgets[i], &cases.items[i], &truth);
        if (ok)
            budget_print(stdout, &budgets[i]);
    }
    free(cases.items);
    stage_free(&stage);
    return ok;
}

bool bench_budgets(const struct bench_values *values, const char **scenes, int scene_count,
                   bool software) {
    int variants = bench_variant_count(values), count = scene_count * variants;
    struct budget *budgets = mem_alloc((size_t)count, sizeof *budgets);
    bool ok = true;
    for (int i = 0; ok && i < scene_count; i++)
        ok = make_budgets(&budgets[i * variants], values, scenes[i], software);
    ok = ok && (!values->csv || budget_write_csv(values->csv, budgets, count));
    free(budgets);
    return ok;
}

static bool make_curves(struct curves *curves, const struct bench_values *values, const char *path,
                        bool software) {
    struct stage stage;
    struct bench_case base;
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    struct bench_reference_desc truth = truth_of(values, path, &stage, software);
    bool ok = bench_prepare(&base, values, &stage, ":") && curves_measure(curves, &base, &truth);
    if (ok) {
        curves_print(stdout, curves);
        ok = curves_draw(curves, bench_output(values));
    }
    stage_free(&stage);
    return ok;
}

bool bench_all_curves(const struct bench_values *values, const char **scenes, int scene_count,
                      bool software) {
    struct curves *curves = mem_alloc((size_t)scene_count, sizeof *curves);
    bool ok = true;
    for (int i = 0; ok && i < scene_count; i++)
        ok = make_curves(&curves[i], values, scenes[i], software);
    ok = ok && (!values->csv || curves_write_csv(values->csv, curves, scene_count));
    for (int i = 0; i < scene_count; i++)
        curves_free(&curves[i]);
    free(curves);
    return ok;
}
