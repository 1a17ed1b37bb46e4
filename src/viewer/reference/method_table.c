#include "viewer/reference/method_table.h"

#include "base/clock.h"
#include "metrics/layer.h"
#include "metrics/summary.h"
#include "viewer/picture/preset.h"

#include <stdio.h>
#include <string.h>

/* --- what is measured --- */

static void add(struct method_table *table, const char *name, const struct technique *technique,
                const struct settings *settings) {
    if (table->count == METHOD_ROWS_MAX)
        return;
    struct method_row *row = &table->rows[table->count++];
    *row = (struct method_row){.technique = technique, .settings = *settings};
    snprintf(row->name, sizeof row->name, "%s", name);
}

static bool has(const struct method_table *table, const struct technique *technique,
                const struct settings *settings) {
    for (int i = 0; i < table->count; i++)
        if (table->rows[i].technique == technique &&
            renderer_settings_same(&table->rows[i].settings, settings, technique->parts))
            return true;
    return false;
}

void method_table_plan(struct method_table *table, const struct technique *technique,
                       const struct settings *settings) {
    method_table_free(table);
    for (const struct preset *p = technique_default->presets; p && p->name; p++) {
        struct settings with = preset_settings(p, settings);
        char title[PRESET_TITLE_SIZE];
        preset_title(p, title);
        add(table, title, technique_default, &with);
    }
    struct settings usual = preset_settings(NULL, settings);
    for (const struct technique *const *t = techniques; *t; t++)
        if (*t != technique_default)
            add(table, (*t)->name, *t, &usual);
    if (!has(table, technique, settings))
        add(table, "as it is", technique, settings);
}

void method_table_free(struct method_table *table) {
    for (int i = 0; i < table->count; i++)
        image_free(&table->rows[i].indirect);
    *table = (struct method_table){0};
}

/* --- measuring --- */

/* Triangles drawn into maps of single lights: software OpenGL draws some millions a second. */
static bool takes_minutes(const struct method_row *row, const struct renderer_desc *shown) {
    static const double triangles_at_most = 6e7;
    bool map_per_light = strcmp(row->technique->name, "instant-radiosity") == 0;
    struct settings chosen =
        renderer_settings_chosen(&row->settings, row->technique, shown->scene, shown->geometry);
    return gl.software && map_per_light &&
           settings_number(&chosen, "lights.vpls") *
                   (double)geometry_triangle_count(shown->geometry) >
               triangles_at_most;
}

/* The median of a few frames, after one that warms up; of one, where it is slow. */
static double time_frames(struct renderer *renderer) {
    enum { FRAMES = 5 };
    static const double enough_ms = 1500;
    float ms[FRAMES];
    double all = 0;
    int count = 0;
    renderer_render(renderer);
    gl.Finish();
    while (count < FRAMES && (count == 0 || all < enough_ms)) {
        double start = clock_ms();
        renderer_render(renderer);
        gl.Finish();
        ms[count] = (float)(clock_ms() - start);
        all += (double)ms[count++];
    }
    return summary_of(ms, count).value;
}

static bool measure(struct method_row *row, const struct renderer_desc *shown) {
    struct renderer renderer;
    struct image all = {0};
    struct renderer_desc desc = *shown;
    desc.technique = row->technique;
    desc.settings = row->settings;
    desc.progressive = desc.timed = desc.keep_lights = false;
    if (!renderer_init(&renderer, &desc))
        return false;
    row->ms = time_frames(&renderer);
    bool ok =
        renderer_read_layers(&renderer, &all) && layer_extract(&row->indirect, &all, "indirect");
    image_free(&all);
    renderer_free(&renderer);
    return ok;
}

bool method_table_measure_next(struct method_table *table, const struct renderer_desc *shown) {
    struct method_row *row = &table->rows[table->next++];
    table->is_announced = false;
    row->state = ROW_LEFT_OUT;
    if (takes_minutes(row, shown))
        return true;
    bool ok = measure(row, shown);
    if (ok)
        row->state = ROW_MEASURED;
    return ok;
}

int method_table_cheapest(const struct method_table *table, double error) {
    int best = -1;
    for (int i = 0; i < table->count; i++) {
        const struct method_row *row = &table->rows[i];
        if (row->has_error && row->error < error && (best < 0 || row->ms < table->rows[best].ms))
            best = i;
    }
    return best;
}
