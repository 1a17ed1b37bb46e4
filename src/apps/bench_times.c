/* Times of variants and sweeps, as tables and as rows. */
#include "apps/bench.h"

#include "apps/bench_errors.h"
#include "apps/bench_machine.h"
#include "apps/bench_rows.h"
#include "apps/bench_tables.h"
#include "base/log.h"

#include <stdlib.h>

/* The reference of the size at hand. */
struct inspection {
    struct bench_reference_desc desc;
    struct image reference;
};

static bool inspect(void *user, struct bench_case *measured, struct renderer *renderer) {
    struct inspection *inspection = user;
    struct image *reference = &inspection->reference;
    if (reference->width != measured->width || reference->height != measured->height) {
        image_free(reference);
        inspection->desc.width = measured->width;
        inspection->desc.height = measured->height;
        if (!bench_reference_get(&inspection->desc, reference))
            return false;
    }
    return bench_errors_of_frame(renderer, reference, &measured->errors);
}

bool bench_measure_groups(struct bench_case *cases, int count, const struct stage *stage,
                          const struct bench_protocol *protocol) {
    for (int first = 0; first < count; first += BENCH_GROUP) {
        int group = count - first < BENCH_GROUP ? count - first : BENCH_GROUP;
        if (!bench_measure(&cases[first], group, stage, protocol))
            return false;
    }
    return true;
}

struct bench_protocol bench_choose_protocol(const struct bench_values *values, bool software) {
    struct bench_protocol protocol = bench_protocol_of(software);
    if (values->frames)
        protocol.frames = values->frames;
    if (values->warm_up)
        protocol.warm_up = values->warm_up;
    return protocol;
}

static bool measure_scene(struct bench_cases *cases, const struct bench_values *values,
                          const char *path, const struct sweep *sweep, bool software) {
    struct stage stage;
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    struct inspection inspection = {.desc = {.kind = values->reference,
                                             .cache = values->cache,
                                             .scene_path = path,
                                             .stage = &stage,
                                             .noise = (double)values->noise,
                                             .software = software}};
    struct bench_protocol protocol = bench_choose_protocol(values, software);
    if (values->reference != BENCH_REFERENCE_NONE)
        protocol.inspect = inspect, protocol.user = &inspection;
    int first = cases->count;
    bool ok = bench_list_cases(cases, values, &stage, sweep);
    if (ok)
        log_note("%s: %d cases", stage.name, cases->count - first);
    ok = ok && bench_measure_groups(&cases->items[first], cases->count - first, &stage, &protocol);
    image_free(&inspection.reference);
    stage_free(&stage);
    return ok;
}

static void print_sweep(const struct bench_cases *cases) {
    printf("%-16s %-18s %-28s %9s %9s %9s %9s %9s\n", "scene", "series", "settings", "ms",
           "rRMSE %", "bias %", "gradient", "FLIP");
    for (int i = 0; i < cases->count; i++) {
        const struct bench_case *c = &cases->items[i];
        printf("%-16s %-18s %-28s %9.2f", c->scene, c->series, c->label, c->wall_ms.median);
        if (c->errors.measured)
            printf(" %9.2f %+9.2f %9.4f %9.4f", 100 * c->errors.relative_rmse,
                   100 * c->errors.relative_bias, c->errors.gradient, c->errors.ldr_flip);
        printf("\n");
    }
}

static void print_machine(const struct bench_machine *machine) {
    printf("%s, %s, %s%s; %s, %d cores; commit %s\n\n", machine->vendor, machine->renderer,
           machine->version, machine->software ? " (software: passes timed with glFinish)" : "",
           machine->cpu, machine->cores, machine->commit);
}

static bool report(const struct bench_cases *cases, const struct bench_values *values,
                   const struct sweep *sweep, bool software) {
    struct bench_machine machine;
    bench_machine_read(&machine, software);
    print_machine(&machine);
    if (sweep->axis_count) {
        print_sweep(cases);
    } else {
        bench_print_table1(stdout, cases->items, cases->count);
        bench_print_ratios(stdout, cases->items, cases->count);
        for (int i = 0; i < cases->count; i++) {
            printf("\n");
            bench_print_table2(stdout, &cases->items[i]);
        }
    }
    return (!values->csv || bench_write_csv(values->csv, cases->items, cases->count, &machine)) &&
           (!values->json || bench_write_json(values->json, cases->items, cases->count, &machine));
}

bool bench_times(const struct bench_values *values, const char **scenes, int scene_count,
                 const struct sweep *sweep, bool software) {
    bool ok = true;
    struct bench_cases cases = {0};
    for (int i = 0; ok && i < scene_count; i++)
        ok = measure_scene(&cases, values, scenes[i], sweep, software);
    ok = ok && report(&cases, values, sweep, software);
    free(cases.items);
    return ok;
}
