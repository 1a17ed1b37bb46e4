#include "scene/lights/lamp_parts.h"

#include "base/memory.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A rectangle is no thinner than this, of its length. */
static const double least_aspect = 1e-3;

/* Places over the surface's extent, and normals. */
struct feature {
    double at[6];
    double power;
};

static void middle_of(const struct lamp_triangle *triangle, double middle[3]) {
    for (int c = 0; c < 3; c++)
        middle[c] =
            (triangle->corners[0][c] + triangle->corners[1][c] + triangle->corners[2][c]) / 3;
}

static double power_of(const struct lamp_triangle *triangle) {
    return triangle->area * (triangle->radiance[0] + triangle->radiance[1] + triangle->radiance[2]);
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* --- clusters --------------------------------------------------------------------------------- */

static struct feature *make_features(const struct lamp_triangle *triangles, int count) {
    struct feature *features = mem_alloc((size_t)count, sizeof *features);
    double center[3] = {0}, power = 0, spread = 0;
    for (int i = 0; i < count; i++) {
        struct feature *feature = &features[i];
        middle_of(&triangles[i], feature->at);
        memcpy(&feature->at[3], triangles[i].normal, sizeof triangles[i].normal);
        feature->power = power_of(&triangles[i]);
        power += feature->power;
        for (int c = 0; c < 3; c++)
            center[c] += feature->power * feature->at[c];
    }
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            spread += features[i].power * pow(features[i].at[c] - center[c] / power, 2);
    double scale = spread > 0 ? sqrt(power / spread) : 1;
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            features[i].at[c] = scale * (features[i].at[c] - center[c] / power);
    return features;
}

static double distance2(const double a[6], const double b[6]) {
    double sum = 0;
    for (int k = 0; k < 6; k++)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

static int nearest(const double at[6], double (*means)[6], int count, double *apart) {
    int best = 0;
    *apart = INFINITY;
    for (int k = 0; k < count; k++) {
        double distance = distance2(at, means[k]);
        if (distance < *apart) {
            *apart = distance;
            best = k;
        }
    }
    return best;
}

/* The most powerful, then each time what is farthest from those that there are, and powerful; fewer
 * where all lie at them. */
static int seed(const struct feature *features, int count, double (*means)[6], int most) {
    int made = 0;
    while (made < most) {
        int best = -1;
        double most_worth = 0;
        for (int i = 0; i < count; i++) {
            double apart = 1;
            if (made > 0)
                nearest(features[i].at, means, made, &apart);
            if (apart > 1e-9 && apart * features[i].power > most_worth) {
                most_worth = apart * features[i].power;
                best = i;
            }
        }
        if (best < 0)
            break;
        memcpy(means[made++], features[best].at, sizeof means[0]);
    }
    return made;
}

/* Lloyd's iteration: whose cluster each is. */
static int cluster(const struct feature *features, int count, int most, int *owner) {
    enum { ROUNDS = 12 };
    double(*means)[6] = mem_alloc((size_t)most, sizeof *means), apart;
    double(*sums)[7] = mem_alloc((size_t)most, sizeof *sums);
    int made = seed(features, count, means, most);
    for (int round = 0; round < ROUNDS; round++) {
        memset(sums, 0, (size_t)most * sizeof *sums);
        for (int i = 0; i < count; i++) {
            double *sum = sums[owner[i] = nearest(features[i].at, means, made, &apart)];
            for (int k = 0; k < 6; k++)
                sum[k] += features[i].power * features[i].at[k];
            sum[6] += features[i].power;
        }
        for (int k = 0; k < made; k++)
            for (int j = 0; j < 6 && sums[k][6] > 0; j++)
                means[k][j] = sums[k][j] / sums[k][6];
    }
    mem_free(means, sums);
    return made;
}

/* --- rectangles ------------------------------------------------------------------------------- */

/* Of a cluster. */
struct sums {
    double area, flux[3], center[3], normal[3];
    double right[3], up[3]; /* across the normal, any way */
    double moments[3];      /* right right, right up, up up */
    double foremost;        /* along the normal, from the centre */
    const struct lamp_triangle *first;
};

static void add_triangle(struct sums *sums, const struct lamp_triangle *triangle) {
    double middle[3];
    middle_of(triangle, middle);
    sums->area += triangle->area;
    for (int c = 0; c < 3; c++) {
        sums->flux[c] += triangle->area * triangle->radiance[c];
        sums->center[c] += triangle->area * middle[c];
        sums->normal[c] += triangle->area * triangle->normal[c];
    }
    if (!sums->first)
        sums->first = triangle;
}

static void set_axes(struct sums *sums) {
    double length = sqrt(dot(sums->normal, sums->normal));
    for (int c = 0; c < 3; c++) {
        sums->center[c] /= sums->area;
        sums->normal[c] =
            length > 1e-6 * sums->area ? sums->normal[c] / length : sums->first->normal[c];
    }
    /* The axis that is farthest from the normal. */
    int aside = 0;
    for (int c = 1; c < 3; c++)
        if (fabs(sums->normal[c]) < fabs(sums->normal[aside]))
            aside = c;
    for (int c = 0; c < 3; c++)
        sums->right[c] = (c == aside) - sums->normal[aside] * sums->normal[c];
    length = sqrt(dot(sums->right, sums->right));
    for (int c = 0; c < 3; c++)
        sums->right[c] /= length;
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        sums->up[c] = sums->normal[d] * sums->right[e] - sums->normal[e] * sums->right[d];
    }
}

/* Second moments of a triangle about a point: area / 12 times those of its corners and of their
 * sum. */
static void add_moments(struct sums *sums, const struct lamp_triangle *triangle) {
    double x[4] = {0}, y[4] = {0};
    for (int k = 0; k < 3; k++) {
        double from[3];
        for (int c = 0; c < 3; c++)
            from[c] = triangle->corners[k][c] - sums->center[c];
        x[k] = dot(from, sums->right), y[k] = dot(from, sums->up);
        x[3] += x[k], y[3] += y[k];
        sums->foremost = fmax(sums->foremost, dot(from, sums->normal));
    }
    for (int k = 0; k < 4; k++) {
        sums->moments[0] += triangle->area / 12 * x[k] * x[k];
        sums->moments[1] += triangle->area / 12 * x[k] * y[k];
        sums->moments[2] += triangle->area / 12 * y[k] * y[k];
    }
}

/* A rectangle's second moment along a side is its area times the side's square over 12. */
static void make_part(struct lamp_part *part, const struct sums *sums) {
    const double *m = sums->moments;
    double turn = atan2(2 * m[1], m[0] - m[2]) / 2, c = cos(turn), s = sin(turn);
    double along = c * c * m[0] + 2 * c * s * m[1] + s * s * m[2];
    double across = fmax(m[0] + m[2] - along, 0);
    double width = sqrt(12 * along / sums->area), height = sqrt(12 * across / sums->area);
    height = fmax(height, least_aspect * width);
    double before = sums->foremost + 1e-4 * width;
    part->size[0] = (float)width;
    part->size[1] = (float)height;
    for (int i = 0; i < 3; i++) {
        part->center[i] = (float)(sums->center[i] + before * sums->normal[i]);
        part->normal[i] = (float)sums->normal[i];
        part->right[i] = (float)(c * sums->right[i] + s * sums->up[i]);
        part->up[i] = (float)(c * sums->up[i] - s * sums->right[i]);
        part->radiance[i] = (float)(sums->flux[i] / (width * height));
    }
}

int lamp_parts_make(const struct lamp_triangle *triangles, int count, struct lamp_part *parts,
                    int most) {
    struct feature *features = make_features(triangles, count);
    int *owner = mem_alloc((size_t)count, sizeof *owner), made = 0;
    int clusters = cluster(features, count, most, owner);
    for (int k = 0; k < clusters; k++) {
        struct sums sums = {.foremost = -INFINITY};
        for (int i = 0; i < count; i++)
            if (owner[i] == k)
                add_triangle(&sums, &triangles[i]);
        if (!sums.first)
            continue;
        set_axes(&sums);
        for (int i = 0; i < count; i++)
            if (owner[i] == k)
                add_moments(&sums, &triangles[i]);
        make_part(&parts[made++], &sums);
    }
    mem_free(features, owner);
    return made;
}
