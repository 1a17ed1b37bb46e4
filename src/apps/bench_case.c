#include "apps/bench_case.h"

#include "base/memory.h"
#include "metrics/quantile.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct summary summary_of(float *values, int count) {
    size_t n = (size_t)count;
    return (struct summary){
        .count = count,
        .median = (double)quantile(values, n, .5),
        .p5 = (double)quantile(values, n, .05),
        .p95 = (double)quantile(values, n, .95),
        .minimum = (double)quantile(values, n, 0),
        .maximum = (double)quantile(values, n, 1),
    };
}

const char *const bench_step_names[STEP_COUNT] = {
    "deferred rendering",    "VPL generation", "VAL clustering", "CSSM",
    "indirect illumination", "blur",           "other",
};

enum bench_step bench_step_of(const char *path) {
    static const struct {
        const char *pass;
        enum bench_step step;
    } rows[] = {
        {"gbuffer", STEP_DEFERRED},
        {"shadow map", STEP_DEFERRED},
        {"direct", STEP_DEFERRED},
        {"antialias", STEP_DEFERRED},
        {"composite", STEP_DEFERRED},
        {"rsm", STEP_VPLS},
        {"vpls", STEP_VPLS},
        {"clustering", STEP_CLUSTERING},
        {"cssm", STEP_CSSM},
        {"map views", STEP_CSSM},
        {"depth maps", STEP_CSSM},
        {"gather", STEP_INDIRECT},
        {"block visibility", STEP_INDIRECT},
        {"near light", STEP_INDIRECT},
        {"near field", STEP_INDIRECT},
        {"blur", STEP_BLUR},
    };
    const char *name = strchr(path, '/');
    for (size_t i = 0; name && i < sizeof rows / sizeof *rows; i++) {
        size_t length = strlen(rows[i].pass);
        if (strncmp(name + 1, rows[i].pass, length) == 0 &&
            (name[1 + length] == '\0' || name[1 + length] == '/'))
            return rows[i].step;
    }
    return STEP_OTHER;
}

static const struct option size_option = {
    "size", 0, OPTION_SIZE, offsetof(struct bench_case, width), 800, 1, 16384, .help = ""};

_Static_assert(offsetof(struct bench_case, height) ==
                   offsetof(struct bench_case, width) + sizeof(int),
               "OPTION_SIZE writes both");

bool bench_assign(struct bench_case *prepared, const char *assignment) {
    if (strncmp(assignment, "size=", 5) == 0)
        return option_parse(&size_option, prepared, assignment + 5);
    if (strncmp(assignment, "technique=", 10) == 0) {
        prepared->technique = technique_find(assignment + 10);
        return prepared->technique;
    }
    return renderer_settings_assign(&prepared->settings, prepared->technique, &assignment, 1);
}

bool bench_assign_all(struct bench_case *prepared, const char *assignments) {
    char *rest = mem_strdup(assignments);
    bool ok = true;
    char *text = rest;
    while (ok && text && *text) {
        char *comma = strchr(text, ',');
        if (comma)
            *comma = '\0';
        ok = bench_assign(prepared, text);
        text = comma ? comma + 1 : NULL;
    }
    free(rest);
    return ok;
}

double bench_frame_ms(const struct bench_case *measured) {
    return measured->pass_count ? measured->passes[0].ms.median : 0;
}

double bench_step_ms(const struct bench_case *measured, enum bench_step step) {
    double sum = 0;
    for (int i = 0; i < measured->pass_count; i++)
        if (measured->passes[i].depth == 1 && bench_step_of(measured->passes[i].path) == step)
            sum += measured->passes[i].ms.median;
    return sum;
}

double bench_sum_ms(const struct bench_case *measured) {
    double sum = 0;
    for (int step = 0; step < STEP_COUNT; step++)
        sum += bench_step_ms(measured, (enum bench_step)step);
    return sum;
}

void bench_options(const struct settings *settings, char *text, size_t size) {
    struct settings defaults;
    renderer_settings_init(&defaults);
    size_t used = 0;
    text[0] = '\0';
    for (struct setting setting = {0}; settings_next(settings, &setting);) {
        char name[SETTING_NAME_SIZE], value[64];
        if (setting_equal(&setting, settings, &defaults) || used >= size)
            continue;
        setting_name(&setting, name);
        setting_format(&setting, settings, value, sizeof value);
        used += (size_t)snprintf(text + used, size - used, "%s%s=%s", used ? " " : "", name, value);
    }
}
