#include "apps/bench_csv.h"

#include "base/error.h"
#include "base/file.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Ends the cell at *at with a zero, quotes undone, and moves on. Returns whether its row ends. */
static bool cut_cell(char **at) {
    char *from = *at, *to = *at;
    bool quoted = false;
    for (; *from && (quoted || (*from != ',' && *from != '\n')); from++)
        if (*from != '"' || (quoted && from[1] == '"' && from++))
            *to++ = *from;
        else
            quoted = !quoted;
    bool ends = *from != ',';
    *at = *from ? from + 1 : from;
    *to = '\0';
    return ends;
}

bool csv_read(struct csv *csv, const char *path) {
    *csv = (struct csv){.text = file_read_text(path)};
    if (!csv->text)
        return false;
    int count = 0, capacity = 0, in_row = 0;
    bool ok = true;
    for (char *at = csv->text; ok && *at;) {
        if (count == capacity) {
            capacity = 2 * capacity + 64;
            csv->cells = mem_resize(csv->cells, (size_t)capacity, sizeof *csv->cells);
        }
        csv->cells[count++] = at;
        in_row++;
        if (!cut_cell(&at))
            continue;
        if (csv->column_count == 0)
            csv->column_count = in_row;
        ok = in_row == csv->column_count ||
             error_set("%s: row %d has %d cells and not %d", path, count / csv->column_count + 1,
                       in_row, csv->column_count);
        in_row = 0;
    }
    if (ok && count == 0)
        ok = error_set("%s is empty", path);
    if (ok)
        csv->row_count = count / csv->column_count - 1;
    else
        csv_free(csv);
    return ok;
}

void csv_free(struct csv *csv) {
    free(csv->text);
    free(csv->cells);
    *csv = (struct csv){0};
}

bool csv_find(const struct csv *csv, const char *name, int *column) {
    for (*column = 0; *column < csv->column_count; ++*column)
        if (strcmp(csv->cells[*column], name) == 0)
            return true;
    return error_set("no column is called '%s'", name);
}
