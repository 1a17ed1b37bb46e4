/* What can be named: techniques, direct methods, qualities, metrics, settings. */
#include "base/error.h"
#include "direct/direct.h"
#include "library/desc.h"
#include "library/door.h"
#include "metrics/metric.h"
#include "quality/quality.h"
#include "renderer/settings.h"
#include "techniques/technique.h"

#include "version.h"

#include <stdio.h>

const char *manylight_version(void) {
    return MANYLIGHT_VERSION " (" MANYLIGHT_COMMIT ")";
}

const char *manylight_technique_name(int n) {
    for (int i = 0; n >= 0 && techniques[i]; i++)
        if (i == n)
            return techniques[i]->name;
    return NULL;
}

const char *manylight_direct_name(int n) {
    for (int i = 0; n >= 0 && direct_methods[i]; i++)
        if (i == n)
            return direct_methods[i]->name;
    return NULL;
}

const char *manylight_quality_name(int n) {
    for (int i = 0; n >= 0 && quality_names[i]; i++)
        if (i == n)
            return quality_names[i];
    return NULL;
}

const char *manylight_metric_name(int n) {
    return n >= 0 && n < METRIC_COUNT ? metrics[n].name : NULL;
}

static bool give_setting(int n, struct manylight_setting *out) {
    struct settings settings;
    struct setting setting = {0};
    struct manylight_setting given = {0};
    renderer_settings_init(&settings);
    for (int i = 0; settings_next(&settings, &setting); i++)
        if (i == n) {
            setting_name(&setting, given.name);
            setting_format(&setting, &settings, given.value, sizeof given.value);
            given.help = setting.option->help;
            return desc_give(out, &given, sizeof given, "manylight_setting");
        }
    return error_set("there is no setting %d", n);
}

enum manylight_status manylight_setting_at(int n, struct manylight_setting *setting) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, give_setting(n, setting), MANYLIGHT_BAD_ARGUMENT);
}
