#include "apps/options.h"

#include <string.h>

bool technique_values_resolve(const struct technique_values *values,
                              const struct technique **technique,
                              const struct direct_method **direct, struct settings *settings) {
    renderer_settings_init(settings);
    *direct = NULL;
    return (*technique = technique_find(values->technique)) &&
           (!values->direct || (*direct = direct_find(values->direct))) &&
           renderer_settings_assign(settings, *technique, values->settings.items,
                                    values->settings.count) &&
           technique_check(*technique, settings);
}

void technique_values_print_help(FILE *out, const struct technique_values *values, bool all) {
    const struct technique *named = technique_find(values->technique);
    fprintf(out, "\ntechniques:\n");
    for (const struct technique *const *t = techniques; *t; t++)
        fprintf(out, "  %-26s %s%s\n", (*t)->name, (*t)->help,
                *t == technique_default ? " [default]" : "");
    fprintf(out, "\ndirect light [default: hard, or pcss where a light has a size]:\n");
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        fprintf(out, "  %-26s %s\n", (*d)->name, (*d)->help);
    renderer_settings_print_help(out, named ? named : technique_default, all);
}

bool technique_values_name(const struct technique_values *values, const struct settings_part *part,
                           const char *name) {
    struct settings settings;
    struct setting setting;
    renderer_settings_init(&settings);
    for (int i = 0; i < values->settings.count; i++)
        for (struct word word = {.at = values->settings.items[i]}; word_next(&word);) {
            char named[SETTING_NAME_SIZE];
            snprintf(named, sizeof named, "%.*s", (int)strcspn(word.at, "="), word.at);
            if (settings_find(&settings, named, &setting) && setting.part == part &&
                strcmp(setting.option->name, name) == 0)
                return true;
        }
    return false;
}
