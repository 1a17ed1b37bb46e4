#include "apps/points.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/memory.h"
#include "base/unit.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

enum { COLUMNS = 6, POINTS_MAX = 1000000 };

static const char header[] = "x,y,z,nx,ny,nz";

/* Steps over a finite number and the comma after it. */
static bool take_number(const char **text, double *number) {
    char *end;
    *number = strtod(*text, &end);
    end += strspn(end, " \t\r");
    if (end == *text || (*end && *end != ',') || !isfinite(*number) || fabs(*number) > 1e9)
        return error_set("'%.*s' is no number from -1e9 to 1e9", (int)strcspn(*text, ",\r"), *text);
    *text = end + (*end == ',');
    return true;
}

static bool take_row(const char *line, double row[COLUMNS]) {
    for (int c = 0; c < COLUMNS; c++) {
        if (line[strspn(line, " \t\r")] == '\0')
            return error_set("%d columns of %d: %s", c, COLUMNS, header);
        if (!take_number(&line, &row[c]))
            return error_prefix("column %d", c + 1);
    }
    return hypot(hypot(row[3], row[4]), row[5]) > 1e-9 || error_set("the normal has no length");
}

static bool is_header(const char *line) {
    return strncmp(line, header, sizeof header - 1) == 0;
}

static bool add_line(struct points *points, const char *line, int number) {
    line += strspn(line, " \t\r");
    if (*line == '\0' || *line == '#' || (points->count == 0 && is_header(line)))
        return true;
    if (points->count == POINTS_MAX)
        return error_set("more than %d points", POINTS_MAX);
    if (!take_row(line, points->rows[points->count]))
        return error_prefix("line %d", number);
    points->count++;
    return true;
}

static int count_lines(const char *text) {
    int count = 1;
    for (const char *c = text; (c = strchr(c, '\n')) != NULL; c++)
        count++;
    return count;
}

bool points_read(struct points *points, const char *path) {
    char *text = file_read_text(path), *line = text;
    *points = (struct points){0};
    if (!text)
        return false;
    points->rows = mem_alloc((size_t)count_lines(text), sizeof *points->rows);
    bool ok = true;
    for (int number = 1; ok && line; number++) {
        char *end = strchr(line, '\n');
        if (end)
            *end = '\0';
        ok = add_line(points, line, number);
        line = end ? end + 1 : NULL;
    }
    free(text);
    if (ok && points->count == 0)
        ok = error_set("it has no point: lines of %s", header);
    if (ok)
        return true;
    points_free(points);
    return error_prefix("%s", path);
}

/* Two counts and nothing after them. */
static bool take_counts(const char *text, int counts[2]) {
    int end = 0;
    return (isdigit((unsigned char)*text) &&
            sscanf(text, "%5dx%5d%n", &counts[0], &counts[1], &end) == 2 && text[end] == '\0' &&
            counts[0] > 0 && counts[1] > 0 && counts[0] <= POINTS_MAX / counts[1]) ||
           error_set("'%s' is no NUxNV of 1 to %d points", text, POINTS_MAX);
}

bool points_parse_grid(struct points *points, const char *text) {
    double at[9];
    int counts[2];
    const char *rest = text;
    *points = (struct points){0};
    for (int i = 0; i < 9; i++)
        if (!take_number(&rest, &at[i]))
            return error_prefix("grid: number %d of x,y,z,ux,uy,uz,vx,vy,vz,NUxNV", i + 1);
    const double *u = at + 3, *v = at + 6;
    double normal[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                        u[0] * v[1] - u[1] * v[0]};
    double area = hypot(hypot(normal[0], normal[1]), normal[2]);
    if (!take_counts(rest, counts))
        return error_prefix("grid");
    if (area < 1e-12)
        return error_set("grid: its sides span no area");
    points->count = counts[0] * counts[1];
    points->columns = counts[0];
    points->rows = mem_alloc((size_t)points->count, sizeof *points->rows);
    for (int i = 0; i < points->count; i++)
        for (int c = 0; c < 3; c++) {
            double a = (i % counts[0] + .5) / counts[0], b = (i / counts[0] + .5) / counts[1];
            points->rows[i][c] = at[c] + a * u[c] + b * v[c];
            points->rows[i][3 + c] = normal[c] / area + 0.; /* no -0 */
        }
    return true;
}

void points_place(struct points *points, const double origin[3]) {
    points->sensors = mem_alloc((size_t)points->count, sizeof *points->sensors);
    for (int i = 0; i < points->count; i++) {
        struct sensor *sensor = &points->sensors[i];
        for (int c = 0; c < 3; c++) {
            sensor->position[c] = (float)(points->rows[i][c] - origin[c]);
            sensor->normal[c] = (float)points->rows[i][3 + c];
        }
        vec3_unit(sensor->normal);
    }
}

void points_free(struct points *points) {
    mem_free(points->rows, points->sensors);
    *points = (struct points){0};
}
