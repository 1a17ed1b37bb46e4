/* Which lights stand for all, by what some rows of the matrix of pixels x lights say [Hašan et al. 2007].
 *
 * A light's column, as far as the rows have it, is a vector of 3 r numbers. Lights are clustered by their columns'
 * directions; of each cluster one light is chosen with a probability p in proportion to w, the length of its
 * column, and counts as s / w, s = sum of w over its cluster: the expected sum is that of all lights. The
 * expected squared error of the rows is then
 *
 *     sum over clusters of  s sum |column|^2 / w - |sum column|^2
 *
 * and is what clusters are split by. So that a light is not lost which no row happens to see, no w is less than a
 * share of the mean, by the light's power.
 */
#ifndef TECHNIQUES_COLUMNS_H
#define TECHNIQUES_COLUMNS_H

#include <stdbool.h>
#include <stdint.h>

struct columns_desc {
    int lights; /* N */
    int rows;   /* r, at most */
    int count;  /* c: of clusters, and of lights that are chosen, at most */
};

struct column {
    int light;
    float weight; /* that the light counts */
};

/* Lights members[first] .. of one cluster, in the order of struct columns. */
struct column_cluster {
    int first, count;
    double error; /* expected, squared, of the rows */
};

struct columns {
    struct columns_desc desc;
    int width;                       /* of a vector: 3 x rows */
    float *directions;               /* of columns, unit or 0: N x width */
    float *lengths, *weights, *keys; /* of each light: |column|, w, and a number to sort by */
    int *members, *labels; /* lights by cluster; the cluster of each light, while they are found */
    double *sums[2];       /* vectors */
    struct column_cluster *clusters;
    int member_count, cluster_count; /* of lights that are not black */
};

void columns_init(struct columns *columns, const struct columns_desc *desc);
void columns_free(struct columns *columns);

/* Clusters lights by a matrix of so many rows: RGB and one unused of each light, row by row. Powers are those of the
 * lights; none of power 0 is ever chosen. Where as many may be chosen as there are, each is its own cluster. */
void columns_cluster(struct columns *columns, const float (*matrix)[4], int rows,
                     const float *powers, uint32_t seed);

/* Chooses one light of each cluster, in the order of their numbers; room for desc.count. Returns how many. */
int columns_choose(const struct columns *columns, uint32_t seed, struct column *chosen);

#endif
