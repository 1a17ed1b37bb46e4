#include "techniques/row-column/columns.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

void columns_init(struct columns *columns, const struct columns_desc *desc) {
    *columns = (struct columns){.desc = *desc};
    size_t lights = (size_t)desc->lights, width = 3 * (size_t)desc->rows;
    columns->directions = mem_alloc(lights * width, sizeof *columns->directions);
    columns->lengths = mem_alloc(lights, sizeof *columns->lengths);
    columns->weights = mem_alloc(lights, sizeof *columns->weights);
    columns->keys = mem_alloc(lights, sizeof *columns->keys);
    columns->members = mem_alloc(lights, sizeof *columns->members);
    columns->labels = mem_alloc(lights, sizeof *columns->labels);
    for (int i = 0; i < 2; i++)
        columns->sums[i] = mem_alloc(width, sizeof *columns->sums[i]);
    columns->clusters = mem_alloc((size_t)desc->count, sizeof *columns->clusters);
}

void columns_free(struct columns *columns) {
    mem_free(columns->directions, columns->lengths, columns->weights, columns->keys,
             columns->members, columns->labels);
    for (int i = 0; i < 2; i++)
        free(columns->sums[i]);
    free(columns->clusters);
    *columns = (struct columns){0};
}

/* In [0, 1): xorshift [Marsaglia 2003]. */
static double next_random(uint32_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return (double)*state / 4294967296.;
}

static uint32_t random_state(uint32_t seed) {
    uint32_t state = (seed + 1) * 2654435769u;
    state ^= state >> 15;
    return state ? state : 1;
}

/* --- columns ---------------------------------------------------------------------------------- */

static const float *direction_of(const struct columns *columns, int light) {
    return &columns->directions[(size_t)light * (size_t)columns->width];
}

static double dot(const float *a, const float *b, int width) {
    float sums[4] = {0};
    int i = 0;
    for (; i + 4 <= width; i += 4)
        for (int k = 0; k < 4; k++)
            sums[k] += a[i + k] * b[i + k];
    for (; i < width; i++)
        sums[0] += a[i] * b[i];
    return (double)(sums[0] + sums[1] + sums[2] + sums[3]);
}

static void take_column(struct columns *columns, const float (*matrix)[4], int rows, int light) {
    float *direction = &columns->directions[(size_t)light * (size_t)columns->width];
    for (int r = 0; r < rows; r++)
        memcpy(&direction[3 * r], matrix[(size_t)r * (size_t)columns->desc.lights + (size_t)light],
               3 * sizeof *direction);
    float length = (float)sqrt(dot(direction, direction, columns->width));
    for (int i = 0; i < columns->width && length > 0; i++)
        direction[i] /= length;
    columns->lengths[light] = length;
}

/* What no row sees, or hardly: at least so much of the mean. */
static const double least_share = .1;

static void weigh(struct columns *columns, const float *powers) {
    double lengths = 0, whole = 0;
    int n = columns->desc.lights, count = 0;
    for (int i = 0; i < n; i++) {
        lengths += (double)columns->lengths[i];
        whole += (double)powers[i];
    }
    for (int i = 0; i < n; i++) {
        double least = whole > 0 ? least_share * lengths * (double)powers[i] / whole : 0;
        columns->weights[i] = powers[i] > 0 ? (float)fmax((double)columns->lengths[i], least) : 0;
        if (columns->weights[i] > 0)
            columns->members[count++] = i;
    }
    columns->member_count = count;
}

/* --- clusters --------------------------------------------------------------------------------- */

/* |u - v|^2 of two directions, either of which may be 0. */
static double apart(const struct columns *columns, int a, int b) {
    double cosine = dot(direction_of(columns, a), direction_of(columns, b), columns->width);
    return fmax(0, (columns->lengths[a] > 0) + (columns->lengths[b] > 0) - 2 * cosine);
}

/* A sum over lights, as the error needs it; and |sum of columns|^2, from the vector. */
struct sums {
    double weight, squares; /* sum of w, of |column|^2 / w */
};

static void add_light(const struct columns *columns, int light, struct sums *sums, double *vector) {
    double length = (double)columns->lengths[light], weight = (double)columns->weights[light];
    const float *direction = direction_of(columns, light);
    sums->weight += weight;
    sums->squares += length * length / weight;
    for (int i = 0; i < columns->width; i++)
        vector[i] += length * (double)direction[i];
}

static double error_of(const struct sums *sums, double squared_sum) {
    return fmax(0, sums->weight * sums->squares - squared_sum);
}

static double square_of(const struct columns *columns, const double *vector) {
    double sum = 0;
    for (int i = 0; i < columns->width; i++)
        sum += vector[i] * vector[i];
    return sum;
}

static double cluster_error(struct columns *columns, int first, int count) {
    struct sums sums = {0};
    double *vector = columns->sums[0];
    memset(vector, 0, (size_t)columns->width * sizeof *vector);
    for (int i = first; i < first + count; i++)
        add_light(columns, columns->members[i], &sums, vector);
    return error_of(&sums, square_of(columns, vector));
}

static void add_cluster(struct columns *columns, int first, int count) {
    columns->clusters[columns->cluster_count++] =
        (struct column_cluster){first, count, cluster_error(columns, first, count)};
}

/* One of members first .. first + count, with a probability by its key. */
static int draw(const struct columns *columns, int first, int count, uint32_t *state) {
    double sum = 0;
    for (int i = first; i < first + count; i++)
        sum += (double)columns->keys[columns->members[i]];
    double left = next_random(state) * sum;
    int drawn = -1;
    for (int i = first; i < first + count && (drawn < 0 || left >= 0); i++) {
        double key = (double)columns->keys[columns->members[i]];
        drawn = key > 0 ? columns->members[i] : drawn;
        left -= key;
    }
    return drawn < 0 ? columns->members[first] : drawn;
}

/* Centres far from those before, and where much light is; each light is labelled with the nearest
 * one. Returns how many there are: fewer where all others lie on them. */
static int find_centers(struct columns *columns, int most, uint32_t *state) {
    int n = columns->member_count, count = 0;
    for (int i = 0; i < n; i++) {
        int light = columns->members[i];
        columns->keys[light] = columns->weights[light];
        columns->labels[light] = -1;
    }
    for (; count < most; count++) {
        int center = draw(columns, 0, n, state);
        if (count > 0 && columns->keys[center] <= 0)
            break;
        for (int i = 0; i < n; i++) {
            int light = columns->members[i];
            float key = columns->weights[light] * (float)apart(columns, light, center);
            if (columns->labels[light] >= 0 && key >= columns->keys[light])
                continue;
            columns->keys[light] = key;
            columns->labels[light] = count;
        }
        columns->keys[center] = 0;
    }
    return count;
}

/* Puts the members of each label side by side, in their order. */
static void gather_labels(struct columns *columns, int labels) {
    int n = columns->member_count, at = 0;
    int *sorted = columns->labels,
        *members = mem_copy(columns->members, (size_t)n, sizeof *members);
    for (int label = 0; label < labels; label++) {
        int first = at;
        for (int i = 0; i < n; i++)
            if (sorted[members[i]] == label)
                columns->members[at++] = members[i];
        if (at > first)
            add_cluster(columns, first, at - first);
    }
    free(members);
}

/* --- splitting -------------------------------------------------------------------------------- */

struct keyed {
    float key;
    int light;
};

static int compare_keys(const void *a, const void *b) {
    const struct keyed *left = a, *right = b;
    if (left->key != right->key)
        return left->key < right->key ? -1 : 1;
    return left->light - right->light;
}

/* Sorts a cluster's members along the line through two of them. */
static void sort_along_line(struct columns *columns, const struct column_cluster *cluster,
                            uint32_t *state) {
    int first = cluster->first, count = cluster->count;
    for (int i = first; i < first + count; i++)
        columns->keys[columns->members[i]] = columns->weights[columns->members[i]];
    int a = draw(columns, first, count, state);
    for (int i = first; i < first + count; i++)
        columns->keys[columns->members[i]] *= (float)apart(columns, columns->members[i], a);
    int b = draw(columns, first, count, state);
    struct keyed *sorted = mem_alloc((size_t)count, sizeof *sorted);
    for (int i = 0; i < count; i++) {
        const float *own = direction_of(columns, columns->members[first + i]);
        sorted[i].light = columns->members[first + i];
        sorted[i].key = (float)(dot(own, direction_of(columns, b), columns->width) -
                                dot(own, direction_of(columns, a), columns->width));
    }
    qsort(sorted, (size_t)count, sizeof *sorted, compare_keys);
    for (int i = 0; i < count; i++)
        columns->members[first + i] = sorted[i].light;
    free(sorted);
}

/* After how many of the sorted members both halves have the least error. */
static int best_cut(struct columns *columns, const struct column_cluster *cluster) {
    struct sums left = {0}, all = {0};
    double *left_vector = columns->sums[0], *all_vector = columns->sums[1];
    size_t bytes = (size_t)columns->width * sizeof *left_vector;
    memset(left_vector, 0, bytes);
    memset(all_vector, 0, bytes);
    for (int i = 0; i < cluster->count; i++)
        add_light(columns, columns->members[cluster->first + i], &all, all_vector);
    int best = 1;
    double least = INFINITY;
    for (int i = 0; i + 1 < cluster->count; i++) {
        add_light(columns, columns->members[cluster->first + i], &left, left_vector);
        struct sums right = {all.weight - left.weight, all.squares - left.squares};
        double rest = 0;
        for (int k = 0; k < columns->width; k++)
            rest += (all_vector[k] - left_vector[k]) * (all_vector[k] - left_vector[k]);
        double error = error_of(&left, square_of(columns, left_vector)) + error_of(&right, rest);
        if (error < least) {
            least = error;
            best = i + 1;
        }
    }
    return best;
}

/* False where no split would do better. */
static bool split_dearest(struct columns *columns, uint32_t *state) {
    struct column_cluster *dearest = NULL;
    for (int i = 0; i < columns->cluster_count; i++) {
        struct column_cluster *cluster = &columns->clusters[i];
        if (cluster->count > 1 && (!dearest || cluster->error > dearest->error))
            dearest = cluster;
    }
    if (!dearest || dearest->error <= 0)
        return false;
    sort_along_line(columns, dearest, state);
    int cut = best_cut(columns, dearest), rest = dearest->count - cut;
    dearest->count = cut;
    dearest->error = cluster_error(columns, dearest->first, cut);
    add_cluster(columns, dearest->first + cut, rest);
    return true;
}

void columns_cluster(struct columns *columns, const float (*matrix)[4], int rows,
                     const float *powers, uint32_t seed) {
    uint32_t state = random_state(seed);
    columns->width = 3 * rows;
    columns->cluster_count = 0;
    for (int i = 0; i < columns->desc.lights; i++)
        take_column(columns, matrix, rows, i);
    weigh(columns, powers);
    int count = columns->desc.count;
    if (columns->member_count <= count) {
        for (int i = 0; i < columns->member_count; i++)
            add_cluster(columns, i, 1);
        return;
    }
    /* The paper leaves open how many come from either. */
    int centers = 2 * count / 3 > 1 ? 2 * count / 3 : 1;
    gather_labels(columns, find_centers(columns, centers, &state));
    while (columns->cluster_count < count && split_dearest(columns, &state))
        ;
}

static int compare_lights(const void *a, const void *b) {
    const struct column *left = a, *right = b;
    return left->light - right->light;
}

int columns_choose(const struct columns *columns, uint32_t seed, struct column *chosen) {
    uint32_t state = random_state(~seed);
    for (int c = 0; c < columns->cluster_count; c++) {
        const struct column_cluster *cluster = &columns->clusters[c];
        const int *members = &columns->members[cluster->first];
        double sum = 0;
        for (int i = 0; i < cluster->count; i++)
            sum += (double)columns->weights[members[i]];
        double left = next_random(&state) * sum;
        int at = 0;
        while (at + 1 < cluster->count && left >= (double)columns->weights[members[at]])
            left -= (double)columns->weights[members[at++]];
        double weight = (double)columns->weights[members[at]];
        chosen[c] = (struct column){members[at], cluster->count > 1 ? (float)(sum / weight) : 1};
    }
    qsort(chosen, (size_t)columns->cluster_count, sizeof *chosen, compare_lights);
    return columns->cluster_count;
}
