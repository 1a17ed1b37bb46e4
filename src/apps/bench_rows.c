#include "apps/bench_rows.h"

#include "base/json.h"
#include "base/output_file.h"

#include <string.h>

/* One value of a case. */
struct quantity {
    const char *name, *unit;
    struct summary values;
};

enum { QUANTITIES_MAX = TIMERS_MAX + 8 };

static struct summary single(double value) {
    return (struct summary){1, value, value, value, value, value};
}

static int list_quantities(const struct bench_case *measured, struct quantity *quantities) {
    int count = 0;
    for (int i = 0; i < measured->pass_count; i++)
        quantities[count++] =
            (struct quantity){measured->passes[i].path, "ms", measured->passes[i].ms};
    if (measured->pass_count) {
        quantities[count++] = (struct quantity){"wall", "ms", measured->wall_ms};
        quantities[count++] = (struct quantity){"gpu-memory", "MiB", single(measured->gpu_memory)};
    }
    const struct bench_errors *errors = &measured->errors;
    if (errors->measured) {
        quantities[count++] =
            (struct quantity){"relative-rmse", "1", single(errors->relative_rmse)};
        quantities[count++] =
            (struct quantity){"relative-bias", "1", single(errors->relative_bias)};
        quantities[count++] = (struct quantity){"gradient", "1", single(errors->gradient)};
        quantities[count++] = (struct quantity){"ldr-flip", "1", single(errors->ldr_flip)};
    }
    return count;
}

/* Nanoseconds of a time per unit of work; what is no time has none. */
static double ns_per(const struct quantity *quantity, double work) {
    return strcmp(quantity->unit, "ms") == 0 ? quantity->values.median * 1e6 / work : 0;
}

static double pixels_of(const struct bench_case *measured) {
    return (double)measured->width * measured->height;
}

/* Each pixel takes the VPLs of its interleave slot. */
static double pixel_vpls_of(const struct bench_case *measured) {
    int slots = (int)settings_number(&measured->settings, "interleave") *
                (int)settings_number(&measured->settings, "interleave");
    return pixels_of(measured) * (int)settings_number(&measured->settings, "vpls") / slots;
}

static void print_cell(FILE *out, const char *text) {
    if (!strpbrk(text, ",\"\n")) {
        fprintf(out, "%s,", text);
        return;
    }
    fputc('"', out);
    for (const char *c = text; *c; c++)
        fprintf(out, *c == '"' ? "\"\"" : "%c", *c);
    fprintf(out, "\",");
}

static void print_row(FILE *out, const struct bench_case *measured, const struct quantity *quantity,
                      const struct bench_machine *machine) {
    char options[512];
    bench_options(&measured->settings, options, sizeof options);
    double frame = bench_frame_ms(measured);
    bool timed = strcmp(quantity->unit, "ms") == 0;
    print_cell(out, measured->scene);
    fprintf(out, "%u,%d,%d,%d,%d,", measured->faces, measured->width, measured->height,
            (int)settings_number(&measured->settings, "vpls"),
            (int)settings_number(&measured->settings, "vals"));
    print_cell(out, measured->technique->name);
    print_cell(out, measured->series);
    print_cell(out, measured->label);
    print_cell(out, options);
    print_cell(out, quantity->name);
    const struct summary *v = &quantity->values;
    fprintf(out, "%s,%d,%.6g,%.6g,%.6g,%.6g,%.6g,", quantity->unit, v->count, v->median, v->p5,
            v->p95, v->minimum, v->maximum);
    if (timed)
        fprintf(out, "%.4g,%.4g,%.4g,", frame > 0 ? v->median / frame : 0,
                ns_per(quantity, pixels_of(measured)), ns_per(quantity, pixel_vpls_of(measured)));
    else
        fprintf(out, ",,,");
    print_cell(out, machine->vendor);
    print_cell(out, machine->renderer);
    print_cell(out, machine->version);
    fprintf(out, "%s,", machine->software ? "yes" : "no");
    print_cell(out, machine->cpu);
    fprintf(out, "%d,%s,%s\n", machine->cores, machine->commit, machine->date);
}

bool bench_write_csv(const char *path, const struct bench_case *cases, int count,
                     const struct bench_machine *machine) {
    struct output_text text;
    output_text_init(&text);
    FILE *out = text.stream;
    fprintf(out, "scene,faces,width,height,vpls,vals,technique,series,label,options,quantity,unit,"
                 "count,median,p5,p95,min,max,share,ns_per_pixel,ns_per_pixel_vpl,gl_vendor,"
                 "gl_renderer,gl_version,software,cpu,cores,commit,date\n");
    for (int i = 0; i < count; i++) {
        struct quantity quantities[QUANTITIES_MAX];
        int quantity_count = list_quantities(&cases[i], quantities);
        for (int q = 0; q < quantity_count; q++)
            print_row(out, &cases[i], &quantities[q], machine);
    }
    return output_text_end(&text, path);
}

static void print_text_member(FILE *out, const char *name, const char *text) {
    fprintf(out, "\"%s\": ", name);
    json_print_text(out, text);
    fprintf(out, ", ");
}

static void print_number_member(FILE *out, const char *name, double number, const char *after) {
    fprintf(out, "\"%s\": ", name);
    json_print_number(out, number);
    fprintf(out, "%s", after);
}

static void print_machine(FILE *out, const struct bench_machine *machine) {
    fprintf(out, "  \"machine\": {");
    print_text_member(out, "gl_vendor", machine->vendor);
    print_text_member(out, "gl_renderer", machine->renderer);
    print_text_member(out, "gl_version", machine->version);
    fprintf(out, "\"software\": %s, ", machine->software ? "true" : "false");
    print_text_member(out, "cpu", machine->cpu);
    print_text_member(out, "commit", machine->commit);
    print_text_member(out, "date", machine->date);
    print_number_member(out, "cores", machine->cores, "},\n");
}

static void print_quantity(FILE *out, const struct bench_case *measured,
                           const struct quantity *quantity) {
    const struct summary *v = &quantity->values;
    fprintf(out, "      {");
    print_text_member(out, "quantity", quantity->name);
    print_text_member(out, "unit", quantity->unit);
    print_number_member(out, "median", v->median, ", ");
    print_number_member(out, "p5", v->p5, ", ");
    print_number_member(out, "p95", v->p95, ", ");
    print_number_member(out, "min", v->minimum, ", ");
    print_number_member(out, "max", v->maximum, ", ");
    print_number_member(out, "ns_per_pixel", ns_per(quantity, pixels_of(measured)), ", ");
    print_number_member(out, "ns_per_pixel_vpl", ns_per(quantity, pixel_vpls_of(measured)), ", ");
    print_number_member(out, "count", v->count, "}");
}

static void print_settings(FILE *out, const struct settings *settings) {
    fprintf(out, "\"settings\": {");
    const char *separator = "";
    for (struct setting s = {0}; settings_next(settings, &s); separator = ", ") {
        char name[SETTING_NAME_SIZE], value[64];
        setting_name(&s, name);
        setting_format(&s, settings, value, sizeof value);
        fprintf(out, "%s\"%s\": ", separator, name);
        json_print_text(out, value);
    }
    fprintf(out, "},\n");
}

static void print_case(FILE *out, const struct bench_case *measured) {
    struct quantity quantities[QUANTITIES_MAX];
    int count = list_quantities(measured, quantities);
    fprintf(out, "    {");
    print_text_member(out, "scene", measured->scene);
    print_number_member(out, "faces", measured->faces, ", ");
    print_number_member(out, "width", measured->width, ", ");
    print_number_member(out, "height", measured->height, ", ");
    print_text_member(out, "technique", measured->technique->name);
    print_text_member(out, "series", measured->series);
    print_text_member(out, "label", measured->label);
    print_settings(out, &measured->settings);
    fprintf(out, "     \"quantities\": [\n");
    for (int i = 0; i < count; i++) {
        print_quantity(out, measured, &quantities[i]);
        fprintf(out, "%s\n", i + 1 < count ? "," : "]}");
    }
    if (count == 0)
        fprintf(out, "]}\n");
}

bool bench_write_json(const char *path, const struct bench_case *cases, int count,
                      const struct bench_machine *machine) {
    struct output_text text;
    output_text_init(&text);
    FILE *out = text.stream;
    fprintf(out, "{\n");
    print_machine(out, machine);
    fprintf(out, "  \"cases\": [\n");
    for (int i = 0; i < count; i++) {
        print_case(out, &cases[i]);
        fprintf(out, i + 1 < count ? "    ,\n" : "");
    }
    fprintf(out, "  ]\n}\n");
    return output_text_end(&text, path);
}
