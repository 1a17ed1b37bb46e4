/* Reads a CSV file with a header row: what bench_rows.h writes, or the like. */
#ifndef APPS_BENCH_CSV_H
#define APPS_BENCH_CSV_H

#include <stdbool.h>

struct csv {
    char *text;   /* the file, cut into cells */
    char **cells; /* (row_count + 1) x column_count, the header first */
    int column_count, row_count;
};

/* Error: cannot be read, or a row has another number of cells than the header. */
bool csv_read(struct csv *csv, const char *path);
void csv_free(struct csv *csv);

/* Error: there is no such column. */
bool csv_find(const struct csv *csv, const char *name, int *column);

/* Rows count from 0, without the header. */
static inline const char *csv_cell(const struct csv *csv, int row, int column) {
    return csv->cells[(row + 1) * csv->column_count + column];
}

#endif
