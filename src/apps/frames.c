#include "apps/frames.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
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

static int run_of(const char *text, char c) {
    int length = 0;
    while (text[length] == c)
        length++;
    return length;
}

/* The digits that a number is to have at least, and 1 without a word of it; counts their length in. */
static int take_digits(const char *text, int *length) {
    int digits = 1, used = 0;
    if (sscanf(text + *length, "%2d%n", &digits, &used) == 1 &&
        isdigit((unsigned char)text[*length]))
        *length += used;
    else
        digits = 1;
    return digits > 0 ? digits : 1;
}

/* "####" of Blender, "@@@@" of viewers, "%04d" of Nuke and ffmpeg, "$F4" and "${F4}" of Houdini. */
static struct place place_at(const char *text) {
    struct place place = {.at = text};
    char last = text[run_of(text, *text)];
    if (*text == '#' || (*text == '@' && text[1] == '@')) {
        place.length = place.digits = run_of(text, *text);
    } else if (*text == '%') {
        place.length = 1;
        place.digits = text[1] == '0' ? take_digits(text, &place.length) : 1;
        last = text[place.length++];
        place.at = last == 'd' ? text : NULL;
    } else if (strncmp(text, "$F", 2) == 0 || strncmp(text, "${F", 3) == 0) {
        bool closed = text[1] == '{';
        place.length = closed ? 3 : 2;
        place.digits = take_digits(text, &place.length);
        last = text[place.length];
        place.length += closed;
        place.at =
            (closed ? last == '}' : !isalpha((unsigned char)last) && last != '_') ? text : NULL;
    } else {
        place.at = NULL;
    }
    return place;
}

/* The last one of the name. */
static struct place find_place(const char *name) {
    struct place found = {0};
    while (*name) {
        struct place place = place_at(name);
        found = place.at ? place : found;
        name += place.at ? place.length : 1;
    }
    return found;
}

bool frame_name_refuse(const char *name, const char *reason) {
    struct place place = find_place(name);
    return error_set("%s: '%.*s' stands for the number of a frame, and %s", name, place.length,
                     place.at, reason);
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
    char *end;
    double above = strtod(text, &end), below = 1;
    bool good = end != text, is_fraction = good && *end == '/';
    if (is_fraction) {
        text = end + 1;
        below = strtod(text, &end);
        good = end != text && below > 0;
    }
    rate->fps = above / below;
    if (!good || *end || !(rate->fps >= 1e-3 && rate->fps <= 1e6))
        return error_set("fps: '%s' is neither a number from 0.001 to 1e+06 nor a fraction like "
                         "24000/1001",
                         text);
    if (is_fraction)
        snprintf(rate->text, sizeof rate->text, "%.9g/%.9g", above, below);
    else if (!find_ntsc(rate, rate->fps))
        snprintf(rate->text, sizeof rate->text, "%.7g", rate->fps);
    return true;
}
