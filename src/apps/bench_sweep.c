#include "apps/bench_sweep.h"

#include "base/error.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *full_name(const char *name) {
    static const char *const letters[][2] = {{"N", "vpls"}, {"M", "vals"}, {"K", "terms"}};
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (strcmp(name, letters[i][0]) == 0)
            return letters[i][1];
    return name;
}

static bool is_numeric(const char *name) {
    struct settings settings;
    struct setting found = {0};
    renderer_settings_init(&settings);
    bool known = settings_find(&settings, name, &found);
    return strcmp(name, "size") == 0 ||
           (known && (found.option->type == OPTION_INT || found.option->type == OPTION_FLOAT));
}

static bool add_axis(struct sweep *sweep, const char *name, size_t length) {
    char text[SWEEP_TEXT_SIZE];
    if (sweep->axis_count == SWEEP_AXES_MAX)
        return error_set("more than %d things to vary", SWEEP_AXES_MAX);
    snprintf(text, sizeof text, "%.*s", (int)length, name);
    struct sweep_axis *axis = &sweep->axes[sweep->axis_count++];
    *axis = (struct sweep_axis){.numeric = is_numeric(full_name(text))};
    snprintf(axis->name, sizeof axis->name, "%s", full_name(text));
    return true;
}

/* Assigns to a case that nobody needs, to hear early of mistakes. */
static bool check_value(const struct sweep_axis *axis, const char *value) {
    struct bench_case scratch = {.technique = technique_default};
    renderer_settings_init(&scratch.settings);
    char assignment[2 * SWEEP_TEXT_SIZE + 2];
    snprintf(assignment, sizeof assignment, "%s=%s", axis->name, value);
    return bench_assign(&scratch, assignment);
}

static bool add_value(struct sweep_axis *axis, const char *value) {
    if (axis->count == SWEEP_VALUES_MAX)
        return error_set("%s: more than %d values", axis->name, SWEEP_VALUES_MAX);
    snprintf(axis->values[axis->count++], SWEEP_TEXT_SIZE, "%s", value);
    return check_value(axis, value);
}

/* "2..120": 2, 4, 8, ... 64, 120. */
static bool add_range(struct sweep_axis *axis, const char *text, bool *is_range) {
    char *end;
    long first = strtol(text, &end, 10);
    *is_range = end != text && strncmp(end, "..", 2) == 0;
    if (!*is_range)
        return true;
    const char *last_text = end + 2;
    long last = strtol(last_text, &end, 10);
    if (end == last_text || *end || first < 1 || last < first)
        return error_set("%s: '%s' is not a range such as 2..128", axis->name, text);
    for (long value = first;; value *= 2) {
        char number[SWEEP_TEXT_SIZE];
        snprintf(number, sizeof number, "%ld", value < last ? value : last);
        if (!add_value(axis, number))
            return false;
        if (value >= last)
            return true;
    }
}

bool sweep_parse(struct sweep *sweep, const char *text) {
    struct sweep_axis *axis = NULL;
    for (const char *at = text; *at;) {
        size_t length = strcspn(at, ","), name_length = strcspn(at, "=");
        if (name_length < length) {
            if (!add_axis(sweep, at, name_length))
                return false;
            axis = &sweep->axes[sweep->axis_count - 1];
            at += name_length + 1, length -= name_length + 1;
        }
        bool more = at[length] == ',';
        if (!axis || length == 0 || length >= SWEEP_TEXT_SIZE || (more && !at[length + 1]))
            return error_set("sweep: '%s' is not KEY=VALUE,VALUE...", text);
        char value[SWEEP_TEXT_SIZE];
        bool is_range = false;
        snprintf(value, sizeof value, "%.*s", (int)length, at);
        if (axis->numeric && !add_range(axis, value, &is_range))
            return false;
        if (!is_range && !add_value(axis, value))
            return false;
        at += length + more;
    }
    return axis || error_set("sweep: nothing to vary");
}

bool sweep_has_series(const struct sweep *sweep) {
    for (int i = 0; i < sweep->axis_count; i++)
        if (!sweep->axes[i].numeric)
            return true;
    return false;
}

int sweep_point_count(const struct sweep *sweep) {
    int count = 1;
    for (int i = 0; i < sweep->axis_count; i++)
        count *= sweep->axes[i].count;
    return count;
}

static void append(char *text, size_t size, const char *word) {
    size_t used = strlen(text);
    snprintf(text + used, size - used, "%s%s", used ? " " : "", word);
}

void sweep_apply(const struct sweep *sweep, int point, struct bench_case *prepared) {
    int stride = sweep_point_count(sweep);
    for (int i = 0; i < sweep->axis_count; i++) {
        const struct sweep_axis *axis = &sweep->axes[i];
        stride /= axis->count;
        const char *value = axis->values[point / stride % axis->count];
        char assignment[2 * SWEEP_TEXT_SIZE + 2];
        snprintf(assignment, sizeof assignment, "%s=%s", axis->name, value);
        bool ok = bench_assign(prepared, assignment);
        assert(ok); /* parsing checked it */
        (void)ok;
        if (axis->numeric)
            append(prepared->label, sizeof prepared->label, assignment);
        else
            append(prepared->series, sizeof prepared->series, value);
    }
}
