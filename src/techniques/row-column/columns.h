/* Chooses lights that represent all, from some rows of the matrix of pixels x lights [Hašan et al.
 * 2007].
 *
 * A light's column in these rows is a vector of 3 r numbers. Lights are clustered by column
 * direction. In a cluster one light is chosen with probability p proportional to w, the length of
 * its column. It counts s / w, s = sum of w over the cluster, so the expected sum is that of all
 * lights. Clusters are split by the expected squared error of the rows:
 *
 *     sum over clusters of  s sum |column|^2 / w - |sum column|^2
 *
 * So that lights outside the rows are not lost, w is at least a fraction of the mean, by the
 * light's power. */
#ifndef TECHNIQUES_COLUMNS_H
#define TECHNIQUES_COLUMNS_H

#include <stdbool.h>
#include <stdint.h>

struct columns_desc {
    int lights; /* N */
    int rows;   /* r, the most rows */
    int count;  /* c, the most clusters and chosen lights */
};

struct column {
    int light;
    float weight; /* factor of the light */
};

/* Lights of a cluster: members[first] and the next ones, in the order of struct columns. */
struct column_cluster {
    int first, count;
    double error; /* expected squared error of the rows */
};

struct columns {
    struct columns_desc desc;
    int width;                       /* length of a vector: 3 x rows */
    float *directions;               /* N x width: directions of columns, unit or 0 */
    float *lengths, *weights, *keys; /* for each light: |column|, w, and a sort key */
    int *members, *labels; /* lights by cluster; cluster of each light during the search */
    double *sums[2];       /* vectors */
    struct column_cluster *clusters;
    int member_count, cluster_count; /* members are the lights that are not black */
};

void columns_init(struct columns *columns, const struct columns_desc *desc);
void columns_free(struct columns *columns);

/* Clusters lights by a matrix of `rows` rows. A row has four floats a light: RGB and one unused.
 * Lights of power 0 are never chosen. With enough room each light is its own cluster. */
void columns_cluster(struct columns *columns, const float (*matrix)[4], int rows,
                     const float *powers, uint32_t seed);

/* Chooses one light of each cluster, in ascending order, into `chosen` (room for desc.count).
 * Returns their number. */
int columns_choose(const struct columns *columns, uint32_t seed, struct column *chosen);

#endif
