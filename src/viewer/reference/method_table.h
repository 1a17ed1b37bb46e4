/* Measures speed against accuracy of one view: a row for each preset and technique. */
#ifndef VIEWER_METHOD_TABLE_H
#define VIEWER_METHOD_TABLE_H

#include "renderer/renderer.h"

enum { METHOD_ROWS_MAX = 16 };

struct method_row {
    char name[32];
    const struct technique *technique;
    struct settings settings;
    enum method_row_state { ROW_WAITS, ROW_MEASURED, ROW_LEFT_OUT } state;
    double ms;
    struct image indirect; /* its indirect light of the view */
    bool has_error;
    double error;
};

struct method_table {
    struct method_row rows[METHOD_ROWS_MAX];
    int count;
    int next;          /* row to measure next; count: done */
    bool is_announced; /* the panel has named the next row, which may take a while */
};

/* Plans rows: presets of the default technique, other techniques, and the picture's own settings
 * if they are none of these. */
void method_table_plan(struct method_table *table, const struct technique *technique,
                       const struct settings *settings);
void method_table_free(struct method_table *table);

/* Times frames of the next row and keeps the last. Leaves out settings that would take minutes.
 * Error: of a renderer; the row is left out. */
bool method_table_measure_next(struct method_table *table, const struct renderer_desc *shown);

/* Returns the fastest row with a smaller error, or -1. */
int method_table_cheapest(const struct method_table *table, double error);

#endif
