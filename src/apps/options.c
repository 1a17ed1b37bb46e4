#include "apps/options.h"

bool technique_values_resolve(const struct technique_values *values, struct renderer_desc *desc) {
    desc->technique = technique_find(values->technique);
    desc->direct = direct_find(values->direct);
    renderer_settings_init(&desc->settings);
    return desc->technique && desc->direct &&
           renderer_settings_assign(&desc->settings, desc->technique, values->settings.items,
                                    values->settings.count) &&
           technique_check(desc->technique, &desc->settings);
}

void technique_values_print_help(FILE *out, const struct technique_values *values) {
    const struct technique *named = technique_find(values->technique);
    fprintf(out, "\ntechniques:\n");
    for (const struct technique *const *t = techniques; *t; t++)
        fprintf(out, "  %-26s %s%s\n", (*t)->name, (*t)->help,
                *t == technique_default ? " [default]" : "");
    fprintf(out, "\ndirect light:\n");
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        fprintf(out, "  %-26s %s%s\n", (*d)->name, (*d)->help,
                *d == direct_default ? " [default]" : "");
    renderer_settings_print_help(out, named ? named : technique_default);
}
