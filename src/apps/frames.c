#include "apps/frames.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
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

/* "N", "N..M" or "N..MxSTEP"; leaves text behind it. */
static bool parse_range(const char **text, int *first, int *last, int *step) {
    if (!parse_number(text, first))
        return false;
    *last = *first;
    *step = 1;
    if (strncmp(*text, "..", 2) != 0)
        return true;
    *text += 2;
    if (!parse_number(text, last) || *last < *first)
        return false;
    if (**text != 'x')
        return true;
    *text += 1;
    return parse_number(text, step) && *step > 0;
}

bool frames_parse(struct frames *frames, const char *text) {
    *frames = (struct frames){0};
    const char *at = text;
    for (bool more = true; more;) {
        int first, last, step;
        bool good = parse_range(&at, &first, &last, &step) && (*at == ',' || !*at);
        if (!good || (last - first) / step >= MAX_FRAMES - frames->count) {
            frames_free(frames);
            return good ? error_set("frames: more than %d", MAX_FRAMES)
                        : error_set("frames: '%s' is not like 0..249, 0..100x5 or 1,5,9", text);
        }
        frames->numbers = mem_resize(
            frames->numbers, (size_t)(frames->count + (last - first) / step + 1), sizeof(int));
        for (int i = first; i <= last; i += step)
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

/* --- names ------------------------------------------------------------------------------------ */

/* A part of a name that stands for the number. */
struct place {
    const char *at; /* NULL: there is none */
    int length, digits;
};

/* Of '#' and '@' as many as digits; a single '@' is a letter. */
static int take_run(const char *text, int *digits) {
    int length = 0;
    while (text[length] == *text)
        length++;
    *digits = length;
    return *text == '#' || (*text == '@' && length > 1) ? length : 0;
}

/* "####" of Blender, "@@@@" of RV, "%04d" of Nuke and ffmpeg, "$F4" of Houdini; else of
 * no length. */
static struct place place_at(const char *text) {
    static const char *const with_digits[] = {"%%%2[0-9]d%n", "$F%2[0-9]%n", "${F%2[0-9]}%n"},
                             *const alone[] = {"%d", "${F}", "$F"};
    struct place place = {.at = text};
    char digits[3] = "1";
    place.length = take_run(text, &place.digits);
    for (int i = 0; i < 3 && !place.length; i++)
        if (sscanf(text, with_digits[i], digits, &place.length) == 1)
            place.digits = atoi(digits);
    for (int i = 0; i < 3 && !place.length; i++)
        if (strncmp(text, alone[i], strlen(alone[i])) == 0) {
            place.length = (int)strlen(alone[i]);
            place.digits = 1;
        }
    if (strncmp(text, "$F", 2) == 0 && (isalpha((unsigned char)text[2]) || text[2] == '_'))
        place.length = 0; /* another variable */
    return place;
}

/* The last one of the name. */
static struct place find_place(const char *name) {
    struct place found = {0};
    while (*name) {
        struct place place = place_at(name);
        found = place.length ? place : found;
        name += place.length ? place.length : 1;
    }
    return found;
}

bool frame_name_refuse(const char *name, const char *reason) {
    struct place place = find_place(name);
    return error_set("%s: '%.*s' stands for the number of a frame, and %s", name, place.length,
                     place.at, reason);
}

bool frame_name_is_plain(const char *name) {
    const char *slash = strrchr(name, '/');
    return !strpbrk(slash ? slash : name, "%$<{") || find_place(name).at;
}

bool frame_name_is_numbered(const char *name) {
    return find_place(name).at;
}

char *frame_name(const char *name, int frame) {
    struct place place = find_place(name);
    if (!place.at)
        return mem_strdup(name);
    return mem_printf("%.*s%0*d%s", (int)(place.at - name), name, place.digits, frame,
                      place.at + place.length);
}

/* --- rates ------------------------------------------------------------------------------------ */

/* 29.97 and 23.98 are short for n * 1000 / 1001. */
static bool find_ntsc(struct frame_rate *rate, double fps) {
    static const int counts[] = {24, 30, 48, 60, 96, 120, 240};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        if (fabs(fps - counts[i] / 1.001) < .005) {
            rate->fps = counts[i] * 1000 / 1001.;
            snprintf(rate->text, sizeof rate->text, "%d000/1001", counts[i]);
            return true;
        }
    return false;
}

bool frame_rate_parse(struct frame_rate *rate, const char *text) {
    double above = 0, below = 1;
    int end = 0;
    if (strchr(text, '/'))
        sscanf(text, "%lf/%lf%n", &above, &below, &end);
    else
        sscanf(text, "%lf%n", &above, &end);
    rate->fps = above / below;
    if (!end || text[end] || !(below > 0 && rate->fps >= 1e-3 && rate->fps <= 1e6))
        return error_set("fps: '%s' is neither a number from 0.001 to 1e+06 nor a fraction like "
                         "24000/1001",
                         text);
    if (below != 1)
        snprintf(rate->text, sizeof rate->text, "%.9g/%.9g", above, below);
    else if (!find_ntsc(rate, rate->fps))
        snprintf(rate->text, sizeof rate->text, "%.7g", rate->fps);
    return true;
}
