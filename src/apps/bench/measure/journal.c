#include "apps/bench/measure/journal.h"

#include "apps/bench/measure/result_rows.h"
#include "base/error.h"
#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char first_line[] =
    "# rows of a run of manylight bench that is not finished; the same command goes on from here\n";
static const char of_scene[] = "# of scene ", end[] = "# end\n";

enum { ALL_DIGITS = 17 };

/* A row that was found in the file. */
struct found {
    const char *subject; /* its first cells, as they stand there */
    const char *date;
    uint64_t scene;
    int block;
};

struct journal {
    struct output_journal file;
    char *mode;
    struct found *found;
    struct result *rows; /* beside found */
    int count, next;
};

/* --- reading ---------------------------------------------------------------------------------- */

/* Steps over a cell, which may have line ends within quotes; to the comma, the line's end or the text's. */
static char *skip_cell(char *at) {
    bool quoted = false;
    for (; *at && (quoted || (*at != ',' && *at != '\n')); at++)
        quoted ^= *at == '"';
    return at;
}

/* What the cell says, written over it. */
static const char *unquote(char *cell) {
    char *to = cell;
    if (*cell != '"')
        return cell;
    for (const char *from = cell + 1; *from; from++) {
        if (*from == '"' && *++from != '"')
            break;
        *to++ = *from;
    }
    *to = '\0';
    return cell;
}

/* Ends the cells of a line, and steps behind it. NULL: it has another number of cells. */
static char *split_line(char *line, char *cells[RESULT_CELLS]) {
    char *at = line;
    for (int i = 0; i < RESULT_CELLS; i++) {
        bool is_last = i + 1 == RESULT_CELLS;
        cells[i] = at;
        at = skip_cell(at);
        if (*at != (is_last ? '\n' : ','))
            return NULL;
        /* The cells of the subject stay one text. */
        if (i + 1 >= RESULT_SUBJECT_CELLS)
            *at = '\0';
        at++;
    }
    return at;
}

static bool parse_number(const char *cell, double *value) {
    char *rest;
    *value = strtod(cell, &rest);
    return rest != cell && !*rest;
}

static bool parse_row(char *const cells[RESULT_CELLS], struct found *found, struct result *row) {
    enum { WHAT = RESULT_SUBJECT_CELLS, AGAINST, UNIT, VALUE, P5, P95, MINIMUM, MAXIMUM, COUNT };
    struct summary *f = &row->figure;
    double count;
    const char *what = unquote(cells[WHAT]);
    bool ok = strlen(what) < sizeof row->what && parse_number(cells[VALUE], &f->value) &&
              parse_number(cells[P5], &f->p5) && parse_number(cells[P95], &f->p95) &&
              parse_number(cells[MINIMUM], &f->minimum) &&
              parse_number(cells[MAXIMUM], &f->maximum) && parse_number(cells[COUNT], &count) &&
              count >= 0 && count < 1e9;
    if (!ok)
        return false;
    f->count = (int)count;
    memcpy(row->what, what, strlen(what) + 1);
    row->against = unquote(cells[AGAINST]);
    row->unit = unquote(cells[UNIT]);
    found->subject = cells[0];
    found->date = unquote(cells[RESULT_CELLS - 1]);
    return strlen(found->date) < sizeof((struct subject *)0)->date;
}

/* The rows from there to the block's end, behind which it steps. NULL: they have no end, or are no rows. */
static char *read_block(struct journal *journal, char *at, int block) {
    char *rest;
    if (strncmp(at, of_scene, strlen(of_scene)) != 0)
        return NULL;
    uint64_t scene = strtoull(at + strlen(of_scene), &rest, 16);
    if (*rest++ != '\n')
        return NULL;
    while (rest && strncmp(rest, end, strlen(end)) != 0) {
        char *cells[RESULT_CELLS];
        size_t count = (size_t)journal->count;
        struct found found = {.scene = scene, .block = block};
        struct result row = {0};
        rest = split_line(rest, cells);
        if (!rest || !parse_row(cells, &found, &row))
            return NULL;
        journal->found = mem_resize(journal->found, count + 1, sizeof found);
        journal->rows = mem_resize(journal->rows, count + 1, sizeof row);
        journal->found[count] = found;
        journal->rows[count] = row;
        journal->count++;
    }
    return rest ? rest + strlen(end) : NULL;
}

/* All blocks that have an end; what a crash has left behind them is dropped. */
static bool read_blocks(struct journal *journal, size_t header) {
    char *at = journal->file.text + header;
    size_t used = header;
    for (int block = 0; strstr(at, end); block++) {
        at = read_block(journal, at, block);
        if (!at)
            return error_set("%s: what follows its first %zu bytes is no whole block of rows; "
                             "--restart drops all rows",
                             journal->file.path, used);
        used = (size_t)(at - journal->file.text);
    }
    return used == journal->file.size || output_journal_cut(&journal->file, used);
}

/* --- whose it is ------------------------------------------------------------------------------ */

static char *header_of(const struct journal_desc *desc) {
    struct text text = {0};
    text_print(&text, "%s", first_line);
    for (const char *line = desc->identity; *line; line += strcspn(line, "\n") + 1)
        text_print(&text, "# %.*s\n", (int)strcspn(line, "\n"), line);
    text_print(&text, "%s%s", result_rows_heading, end);
    return text.data;
}

/* Of the first line that differs; a heading is no setting. */
static bool refuse(const struct journal *journal, const char *header) {
    const char *was = journal->file.text, *is = header;
    while (strcspn(was, "\n") == strcspn(is, "\n") && strncmp(was, is, strcspn(is, "\n")) == 0) {
        was += strcspn(was, "\n") + 1;
        is += strcspn(is, "\n") + 1;
    }
    int was_length = *was == '#' ? (int)strcspn(was, "\n") : 0;
    int is_length = *is == '#' ? (int)strcspn(is, "\n") : 0;
    return error_set("%s has rows of a run with other settings: \"%.*s\" there, \"%.*s\" here; "
                     "--restart drops them",
                     journal->file.path, was_length ? was_length - 2 : 0, was + 2,
                     is_length ? is_length - 2 : 0, is + 2);
}

/* What is empty, or was broken off in its first lines, has no rows. */
static bool has_rows(const struct journal *journal) {
    const char *heading = strstr(journal->file.text, result_rows_heading);
    return heading && strstr(heading, end);
}

static bool is_ours(const struct journal *journal) {
    const char *text = journal->file.text;
    size_t length = strlen(text), known = strlen(first_line);
    return strncmp(text, first_line, length < known ? length : known) == 0;
}

/* Where it cannot be, no empty file is left. */
static bool write_header(struct journal *journal, const char *header, size_t length) {
    if (output_journal_cut(&journal->file, 0) &&
        output_journal_append(&journal->file, header, length))
        return true;
    unlink(journal->file.path);
    return false;
}

static bool begin(struct journal *journal, const struct journal_desc *desc) {
    char *header = header_of(desc);
    size_t length = strlen(header);
    bool ok = true, same = strncmp(journal->file.text, header, length) == 0;
    if (!is_ours(journal))
        ok = error_set("%s is there, and is not of manylight bench", journal->file.path);
    else if (desc->restart || !has_rows(journal))
        ok = write_header(journal, header, length);
    else
        ok = same ? read_blocks(journal, length) : refuse(journal, header);
    free(header);
    return ok;
}

/* --- */

char *journal_value(const char *path, const char *name) {
    char *part = mem_printf("%s.part", path), *line = mem_printf("\n# %s ", name);
    char *text = access(part, R_OK) == 0 && !file_is_stream(part) ? file_read_text(part) : NULL;
    const char *at = text ? strstr(text, line) : NULL, *value = at ? at + strlen(line) : NULL;
    char *found = value ? mem_printf("%.*s", (int)strcspn(value, "\n"), value) : NULL;
    mem_free(text, line, part);
    return found;
}

struct journal *journal_open(const struct journal_desc *desc) {
    struct journal *journal = mem_alloc(1, sizeof *journal);
    char *path = mem_printf("%s.part", desc->path);
    journal->mode = mem_strdup(desc->mode);
    bool ok = output_journal_open(&journal->file, path) && begin(journal, desc);
    int left = ok ? journal_left(journal) : 0;
    if (left > 0)
        log_note("%s has %d subjects of a run that was broken off, which goes on from there", path,
                 left);
    free(path);
    if (ok)
        return journal;
    journal_close(journal);
    return NULL;
}

void journal_close(struct journal *journal) {
    if (!journal)
        return;
    output_journal_close(&journal->file);
    mem_free(journal->found, journal->rows, journal->mode, journal);
}

bool journal_finish(struct journal *journal) {
    return output_journal_remove(&journal->file);
}

static bool is_beside(const struct found *a, const struct found *b) {
    return a->block == b->block && strcmp(a->subject, b->subject) == 0;
}

/* How many rows the subject has whose first one this is. */
static int rows_from(const struct journal *journal, int first) {
    int last = first + 1;
    while (last < journal->count && is_beside(&journal->found[last], &journal->found[first]))
        last++;
    return last - first;
}

int journal_left(const struct journal *journal) {
    int subjects = 0;
    for (int at = journal->next; at < journal->count; at += rows_from(journal, at))
        subjects++;
    return subjects;
}

const struct result *journal_next(struct journal *journal, struct subject *subject, uint64_t scene,
                                  int *rows) {
    *rows = 0;
    if (journal->next == journal->count)
        return NULL;
    const struct found *found = &journal->found[journal->next];
    char *cells = result_rows_subject(journal->mode, subject);
    if (strcmp(found->subject, cells) != 0) {
        error_set("%s has rows of %s where this run has %s; --restart drops them",
                  journal->file.path, found->subject, cells);
        *rows = -1;
    } else if (found->scene != scene) {
        error_set("%s has rows of %s as it was before it changed; --restart drops them",
                  journal->file.path, subject->scene);
        *rows = -1;
    }
    free(cells);
    if (*rows < 0)
        return NULL;
    const struct result *first = &journal->rows[journal->next];
    snprintf(subject->date, sizeof subject->date, "%s", found->date);
    *rows = rows_from(journal, journal->next);
    journal->next += *rows;
    return first;
}

bool journal_append(struct journal *journal, const struct results *results, int first,
                    uint64_t scene) {
    struct text block = {0};
    text_print(&block, "%s%016" PRIx64 "\n", of_scene, scene);
    result_rows_add(&block, results, journal->mode, first, ALL_DIGITS);
    text_print(&block, "%s", end);
    bool ok = output_journal_append(&journal->file, block.data, block.length);
    free(block.data);
    return ok;
}
