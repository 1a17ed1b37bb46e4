#include "apps/frames.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FRAME = 9999999, MAX_FRAMES = 1000000 };

static bool parse_number(const char **text, int *number) {
    char *end;
    if (!isdigit((unsigned char)**text))
        return false;
    long value = strtol(*text, &end, 10);
    *text = end;
    *number = (int)value;
    return value <= MAX_FRAME;
}

/* "N" or "N..M"; leaves text behind it. */
static bool parse_range(const char **text, int *first, int *last) {
    if (!parse_number(text, first))
        return false;
    *last = *first;
    if (strncmp(*text, "..", 2) != 0)
        return true;
    *text += 2;
    return parse_number(text, last) && *last >= *first;
}

bool frames_parse(struct frames *frames, const char *text) {
    *frames = (struct frames){0};
    const char *at = text;
    for (bool more = true; more;) {
        int first, last;
        bool good = parse_range(&at, &first, &last) && (*at == ',' || !*at);
        if (!good || last - first >= MAX_FRAMES - frames->count) {
            frames_free(frames);
            return good ? error_set("frames: more than %d", MAX_FRAMES)
                        : error_set("frames: '%s' is not like 0..249 or 1,5,9", text);
        }
        frames->numbers =
            mem_resize(frames->numbers, (size_t)(frames->count + last - first + 1), sizeof(int));
        for (int i = first; i <= last; i++)
            frames->numbers[frames->count++] = i;
        more = *at++ == ',';
    }
    return true;
}

void frames_free(struct frames *frames) {
    free(frames->numbers);
    *frames = (struct frames){0};
}

static int ascending(const void *a, const void *b) {
    const int *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

bool frames_sort(struct frames *frames, int *twice) {
    qsort(frames->numbers, (size_t)frames->count, sizeof *frames->numbers, ascending);
    for (int i = 1; i < frames->count; i++)
        if (frames->numbers[i] == frames->numbers[i - 1]) {
            *twice = frames->numbers[i];
            return false;
        }
    return true;
}

char *frames_text(const struct frames *frames) {
    struct text text = {0};
    for (int first = 0, next; first < frames->count; first = next) {
        next = first + 1;
        while (next < frames->count && frames->numbers[next] == frames->numbers[next - 1] + 1)
            next++;
        text_print(&text, "%s%d", first ? "," : "", frames->numbers[first]);
        if (next - first > 1)
            text_print(&text, "..%d", frames->numbers[next - 1]);
    }
    return text.data;
}

bool frame_name_is_numbered(const char *name) {
    return strchr(name, '#') != NULL;
}

char *frame_name(const char *name, int frame) {
    const char *last = strrchr(name, '#');
    if (!last)
        return mem_strdup(name);
    const char *first = last;
    while (first > name && first[-1] == '#')
        first--;
    return mem_printf("%.*s%0*d%s", (int)(first - name), name, (int)(last - first + 1), frame,
                      last + 1);
}
