/* Which channels a layer's name stands for. Channels are named LAYER.CHANNEL; in a file of several
 * parts, PART.CHANNEL or PART.LAYER.CHANNEL. */
#include "base/image.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* ALONE: the layer's only channel, of any name, but for alpha. */
enum kind { NOTHING, COLOURS, VECTORS, GREY, ALONE };

struct choice {
    int first; /* a channel of the layer; -1: there is no such layer */
    enum kind kind;
    int channels[3];
};

static const char *const colours[3][2] = {{"R", "red"}, {"G", "green"}, {"B", "blue"}};
static const char *const axes[3][2] = {{"X", "X"}, {"Y", "Y"}, {"Z", "Z"}};

/* How programs name the whole picture where they name it, the likeliest first. */
static const char *const beauty_names[] = {
    "beauty", "rgba", "rgb", "combined", "composite", "ci", "c", "final", "image", "main", NULL};

/* Of parts that are no picture, though red, green and blue. */
static const char *const other_names[] = {"n",     "normal", "normals", "p",  "position", "albedo",
                                          "depth", "z",      "motion",  "uv", "variance", NULL};

enum {
    RANK_OWN,
    RANK_NAMED,
    RANK_PART = 20,
    RANK_OTHER_PART,
    RANK_ANY,
    RANK_OTHER,
    RANK_ANY_OTHER,
    RANK_NONE
};

/* --- names ------------------------------------------------------------------------------------ */

static size_t layer_length(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot ? (size_t)(dot - name) : 0;
}

static const char *last_word(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot ? dot + 1 : name;
}

static bool is_in_layer(const char *name, const char *layer, size_t length) {
    return layer_length(name) == length && memcmp(name, layer, length) == 0;
}

static bool is_same_layer(const struct image *image, int a, int b) {
    return is_in_layer(image->names[a], image->names[b], layer_length(image->names[b]));
}

static bool is_first(const struct image *image, int channel) {
    for (int i = 0; i < channel; i++)
        if (is_same_layer(image, i, channel))
            return false;
    return true;
}

/* Whether a name of that length begins with scope, as a whole or as far as a dot. */
static bool is_below(const char *name, size_t length, const char *scope) {
    size_t of_scope = strlen(scope);
    return of_scope == 0 || (length >= of_scope && memcmp(name, scope, of_scope) == 0 &&
                             (length == of_scope || name[of_scope] == '.'));
}

static bool ends_with_word(const char *name, size_t length, const char *word) {
    size_t of_word = strlen(word);
    return length > of_word && name[length - of_word - 1] == '.' &&
           memcmp(name + length - of_word, word, of_word) == 0;
}

/* The index of the last word of a layer's name, or -1. */
static int find_word(const char *const words[], const char *name, size_t length) {
    size_t begin = length;
    while (begin > 0 && name[begin - 1] != '.')
        begin--;
    for (int i = 0; words[i]; i++)
        if (strlen(words[i]) == length - begin &&
            strncasecmp(name + begin, words[i], length - begin) == 0)
            return i;
    return -1;
}

static bool is_part(const struct image *image, const char *name, size_t length) {
    for (int i = 0; i < image->part_count; i++)
        if (strlen(image->parts[i]) == length && memcmp(image->parts[i], name, length) == 0)
            return true;
    return false;
}

static bool is_alpha(const char *name) {
    return strcasecmp(last_word(name), "A") == 0 || strcasecmp(last_word(name), "alpha") == 0;
}

/* --- what a layer is -------------------------------------------------------------------------- */

/* The channel of that name in the layer of channel `of`; upper case goes first. */
static int find_beside(const struct image *image, int of, const char *const names[2]) {
    int found = -1;
    for (int i = 0; i < image->channel_count; i++) {
        const char *word = last_word(image->names[i]);
        if (strcasecmp(word, names[0]) != 0 && strcasecmp(word, names[1]) != 0)
            continue;
        if (!is_same_layer(image, i, of))
            continue;
        if (strcmp(word, names[0]) == 0)
            return i;
        found = found < 0 ? i : found;
    }
    return found;
}

static bool find_three(const struct image *image, int of, const char *const names[3][2],
                       int channels[3]) {
    for (int c = 0; c < 3; c++)
        channels[c] = find_beside(image, of, names[c]);
    return channels[0] >= 0 && channels[1] >= 0 && channels[2] >= 0;
}

/* The only channel of its layer but for alpha, or -1. */
static int find_alone(const struct image *image, int of) {
    int alone = -1;
    for (int i = 0; i < image->channel_count; i++) {
        if (!is_same_layer(image, i, of) || is_alpha(image->names[i]))
            continue;
        if (alone >= 0)
            return -1;
        alone = i;
    }
    return alone;
}

static void fill(struct choice *choice, enum kind kind, int channel) {
    choice->kind = kind;
    for (int c = 0; c < 3; c++)
        choice->channels[c] = channel;
}

/* Y is luminance where no X and no red lie beside it. */
static struct choice look_at(const struct image *image, int of) {
    struct choice choice = {.first = of, .kind = COLOURS};
    if (find_three(image, of, colours, choice.channels))
        return choice;
    choice.kind = VECTORS;
    if (find_three(image, of, axes, choice.channels))
        return choice;
    int alone = find_alone(image, of), luminance = find_beside(image, of, axes[1]);
    fill(&choice, NOTHING, -1);
    if (luminance >= 0 && find_beside(image, of, axes[0]) < 0 &&
        find_beside(image, of, colours[0]) < 0)
        fill(&choice, GREY, luminance);
    else if (alone >= 0)
        fill(&choice, ALONE, alone);
    return choice;
}

/* --- which layer ------------------------------------------------------------------------------ */

/* How likely it is the picture among the layers below scope; the least is taken. */
static int rank_of(const struct image *image, const struct choice *choice, const char *scope) {
    const char *name = image->names[choice->first];
    size_t length = layer_length(name);
    bool own = length == strlen(scope);
    int beauty = find_word(beauty_names, name, length);
    if (choice->kind == NOTHING || choice->kind == ALONE)
        return RANK_NONE;
    if (choice->kind != COLOURS)
        return own || is_part(image, name, length) ? RANK_OTHER : RANK_ANY_OTHER;
    if (own)
        return RANK_OWN;
    if (beauty >= 0)
        return RANK_NAMED + beauty;
    if (!is_part(image, name, length))
        return RANK_ANY;
    return find_word(other_names, name, length) < 0 ? RANK_PART : RANK_OTHER_PART;
}

/* Of several of one rank the first is taken. Where neither name nor part tells, it is alone. */
static struct choice find_beauty(const struct image *image, const char *scope) {
    struct choice best = {.first = -1};
    int least = RANK_NONE, alike = 0;
    for (int i = 0; i < image->channel_count; i++) {
        const char *name = image->names[i];
        if (!is_below(name, layer_length(name), scope) || !is_first(image, i))
            continue;
        struct choice choice = look_at(image, i);
        int rank = rank_of(image, &choice, scope);
        alike = rank == least ? alike + 1 : rank < least ? 1 : alike;
        if (rank < least) {
            least = rank;
            best = choice;
        }
    }
    if ((least == RANK_ANY || least == RANK_ANY_OTHER) && alike > 1)
        best.first = -1;
    return best;
}

static struct choice find_exact(const struct image *image, const char *layer) {
    struct choice choice = {.first = -1};
    for (int i = 0; i < image->channel_count; i++)
        if (is_in_layer(image->names[i], layer, strlen(layer))) {
            choice = look_at(image, i);
            break;
        }
    int channel = image_find_channel(image, layer);
    if (channel >= 0 && (choice.first < 0 || choice.kind == NOTHING)) {
        choice.first = channel;
        fill(&choice, ALONE, channel);
    }
    return choice;
}

/* The end of a layer's name or of a channel's: Combined of ViewLayer.Combined.R. */
static struct choice find_ending(const struct image *image, const char *end) {
    for (int i = 0; i < image->channel_count; i++) {
        const char *name = image->names[i];
        struct choice choice = {.first = i};
        if (ends_with_word(name, layer_length(name), end))
            choice = look_at(image, i);
        else if (ends_with_word(name, strlen(name), end))
            fill(&choice, ALONE, i);
        if (choice.kind != NOTHING)
            return choice;
    }
    return (struct choice){.first = -1};
}

static bool is_any(const char *layer) {
    return layer[0] == '\0' || strcmp(layer, "beauty") == 0;
}

static struct choice find(const struct image *image, const char *layer) {
    if (is_any(layer))
        return find_beauty(image, "");
    struct choice exact = find_exact(image, layer), choice = exact;
    if (choice.first < 0 || choice.kind == NOTHING)
        choice = find_beauty(image, layer);
    if (choice.first < 0)
        choice = find_ending(image, layer);
    if (choice.first < 0 && exact.first < 0 && find_word(beauty_names, layer, strlen(layer)) >= 0)
        choice = find_beauty(image, "");
    return choice.first < 0 ? exact : choice;
}

/* --- colours ---------------------------------------------------------------------------------- */

/* A pixel that is not finite stays: who reads it refuses or replaces it. */
static void convert_pixel(float *pixel, const int channels[3], float matrix[3][3]) {
    vec3 rgb;
    for (int c = 0; c < 3; c++)
        rgb[c] = pixel[channels[c]];
    if (!isfinite(rgb[0] + rgb[1] + rgb[2]))
        return;
    glm_mat3_mulv(matrix, rgb, rgb);
    for (int c = 0; c < 3; c++)
        pixel[channels[c]] = rgb[c];
}

int image_convert_colours(struct image *image, float matrix[3][3]) {
    int converted = 0;
    size_t count = (size_t)image->width * (size_t)image->height;
    for (int i = 0; i < image->channel_count; i++) {
        struct choice choice = look_at(image, i);
        const char *name = image->names[i];
        if (!is_first(image, i) || choice.kind != COLOURS ||
            find_word(other_names, name, layer_length(name)) >= 0)
            continue;
        converted++;
        for (size_t p = 0; p < count; p++)
            convert_pixel(image->pixels + p * (size_t)image->channel_count, choice.channels,
                          matrix);
    }
    return converted;
}

/* --- what is told of it ----------------------------------------------------------------------- */

/* More than these would fill a terminal and the message. */
enum { LISTED = 60, LIST_LENGTH = 1200 };

static void list_name(struct text *list, int *count, const char *name, size_t length) {
    if (++*count <= LISTED && list->length + length < LIST_LENGTH)
        text_print(list, "%s%.*s", list->length ? ", " : "", (int)length, name);
    else if (*count <= LISTED)
        *count = LISTED + 1;
}

static bool is_chosen(const struct choice *choice, int channel) {
    return choice->channels[0] == channel || choice->channels[1] == channel ||
           choice->channels[2] == channel;
}

/* A layer by its name where it can be compared, and its other channels each. */
static void list_layer(const struct image *image, int first, struct text *list, int *count) {
    const char *name = image->names[first];
    size_t length = layer_length(name);
    struct choice choice = look_at(image, first);
    bool whole = length ? choice.kind != NOTHING : choice.kind == COLOURS || choice.kind == GREY;
    if (whole)
        list_name(list, count, length ? name : "beauty", length ? length : strlen("beauty"));
    for (int i = first; i < image->channel_count; i++) {
        const char *other = image->names[i];
        if (is_same_layer(image, i, first) && !(whole && is_chosen(&choice, i)) &&
            !(length && is_alpha(other)))
            list_name(list, count, other, strlen(other));
    }
}

/* To be freed. */
static char *list_layers(const struct image *image) {
    struct text list = {0};
    int count = 0;
    for (int i = 0; i < image->channel_count; i++)
        if (is_first(image, i))
            list_layer(image, i, &list, &count);
    if (count > LISTED)
        text_print(&list, ", ...");
    return list.data ? list.data : mem_strdup("none");
}

/* ": G and B are missing" of a layer that has some of its colours; "" of others. */
static void tell_missing(const struct image *image, int of, char *text, size_t size) {
    int channels[3], missing = 0;
    find_three(image, of, colours, channels);
    *text = '\0';
    for (int c = 0; c < 3; c++)
        if (channels[c] < 0)
            snprintf(text + strlen(text), size - strlen(text), "%s%s", missing++ ? " and " : ": ",
                     colours[c][0]);
    snprintf(text + strlen(text), size - strlen(text), " %s missing", missing > 1 ? "are" : "is");
    if (missing == 0 || missing == 3)
        *text = '\0';
}

bool image_find_layer(const struct image *image, const char *layer, int channels[3]) {
    struct choice choice = find(image, layer);
    if (choice.first >= 0 && choice.kind != NOTHING) {
        memcpy(channels, choice.channels, sizeof choice.channels);
        return true;
    }
    char missing[32] = "", *list = list_layers(image);
    for (int i = 0; !*missing && i < image->channel_count; i++)
        if (choice.first >= 0 ? i == choice.first : layer_length(image->names[i]) == 0)
            tell_missing(image, i, missing, sizeof missing);
    error_set("no layer '%s'%s (there is: %s)", is_any(layer) ? "beauty" : layer, missing, list);
    free(list);
    return false;
}

char *image_layer_note(const struct image *image, const char *layer) {
    struct choice choice = find(image, layer);
    if (choice.first < 0 || choice.kind == NOTHING)
        return NULL;
    const char *name = image->names[choice.first];
    size_t length = layer_length(name);
    bool plain = length == 0 && (choice.kind == COLOURS || choice.kind == GREY);
    bool asked = is_any(layer) ? plain
                               : strcmp(image->names[choice.channels[0]], layer) == 0 ||
                                     is_in_layer(name, layer, strlen(layer));
    if (asked)
        return NULL;
    char *list = list_layers(image), *note;
    if (choice.kind == ALONE)
        note = mem_printf("channel '%s' is taken (there is: %s)", image->names[choice.channels[0]],
                          list);
    else if (length == 0)
        note = mem_printf("channels %s are taken (there is: %s)",
                          choice.kind == VECTORS ? "X, Y and Z" : "R, G and B", list);
    else
        note = mem_printf("layer '%.*s' is taken (there is: %s)", (int)length, name, list);
    free(list);
    return note;
}
