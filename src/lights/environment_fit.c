#include "lights/environment_fit.h"

#include "base/memory.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = SKY_FACE_SIZE, SIDE_SUMS = N + 1 };

/* Texels of a face from (x, y) to before (x_end, y_end). */
struct area {
    int face, x, y, x_end, y_end;
};

/* Six faces of texels, and of each what lies left of and below a corner: by luminance. */
struct cube {
    double energy[6][N][N][3]; /* radiance times solid angle, W/m2 */
    double sums[6][SIDE_SUMS][SIDE_SUMS];
    double squares[6][SIDE_SUMS][SIDE_SUMS]; /* of radiance, times solid angle */
    bool taken[6][N][N];
};

/* right x up = forward */
static const float face_axes[6][3][3] = {
    {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
};

/* --- the cube --------------------------------------------------------------------------------- */

/* Of texels a face is n wide. */
static double edge_of(int i) {
    return 2.0 * i / N - 1;
}

/* From the middle of a face to its point (x, y), sr: by differences, that of any rectangle. */
static double corner_angle(double x, double y) {
    return atan2(x * y, sqrt(1 + x * x + y * y));
}

static double solid_angle(const struct area *area) {
    double left = edge_of(area->x), right = edge_of(area->x_end);
    double bottom = edge_of(area->y), top = edge_of(area->y_end);
    return corner_angle(right, top) - corner_angle(left, top) - corner_angle(right, bottom) +
           corner_angle(left, bottom);
}

static void find_texel(const float direction[3], int *face, int *x, int *y) {
    float size[3] = {fabsf(direction[0]), fabsf(direction[1]), fabsf(direction[2])};
    int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    *face = 2 * axis + (direction[axis] < 0);
    const float(*axes)[3] = face_axes[*face];
    float right = glm_vec3_dot((float *)axes[0], (float *)direction) / size[axis];
    float up = glm_vec3_dot((float *)axes[1], (float *)direction) / size[axis];
    *x = (int)glm_clamp((right + 1) / 2 * N, 0, N - 1);
    *y = (int)glm_clamp((up + 1) / 2 * N, 0, N - 1);
}

/* Draws a row of places of the map: each adds its radiance to a texel of the cube. */
static void draw_row(struct cube *cube, double (*weights)[N][N], const struct environment *map,
                     int row, int parts) {
    int columns = map->width * parts;
    double polar = GLM_PI * (row + .5) / (map->height * parts);
    double weight = sin(polar);
    for (int column = 0; column < columns; column++) {
        double azimuth = 2 * GLM_PI * ((column + .5) / columns - .5);
        float direction[3] = {(float)(sin(polar) * cos(azimuth)), (float)cos(polar),
                              (float)(sin(polar) * sin(azimuth))};
        size_t texel = (size_t)(row / parts) * (size_t)map->width + (size_t)(column / parts);
        int face, x, y;
        find_texel(direction, &face, &x, &y);
        weights[face][y][x] += weight;
        for (int c = 0; c < 3; c++)
            cube->energy[face][y][x][c] += weight * (double)map->texels[texel][c];
    }
}

/* Channel by channel, without strength, W/m2. */
static void map_energy(const struct environment *map, double energy[3]) {
    for (int y = 0; y < map->height; y++)
        for (int x = 0; x < map->width; x++)
            for (int c = 0; c < 3; c++)
                energy[c] += environment_solid_angle(map, y) *
                             (double)map->texels[(size_t)y * (size_t)map->width + (size_t)x][c];
}

/* Makes means of what was added up, energy of means, and the cube's energy the map's. */
static void weigh(struct cube *cube, double (*weights)[N][N], const struct environment *map) {
    double wanted[3] = {0}, got[3] = {0};
    map_energy(map, wanted);
    for (int pass = 0; pass < 2; pass++)
        for (int face = 0; face < 6; face++)
            for (int y = 0; y < N; y++)
                for (int x = 0; x < N; x++)
                    for (int c = 0; c < 3; c++) {
                        double *energy = &cube->energy[face][y][x][c];
                        struct area texel = {face, x, y, x + 1, y + 1};
                        if (pass == 0)
                            got[c] += *energy *= solid_angle(&texel) / weights[face][y][x];
                        else
                            *energy *= got[c] > 0 ? wanted[c] / got[c] : 0;
                    }
}

/* Some 250 places a texel, whatever the map's size. */
static void draw_map(struct cube *cube, const struct environment *map) {
    double(*weights)[N][N] = mem_alloc(6, sizeof *weights);
    double share = 256.0 * 6 * N * N / ((double)map->width * map->height);
    int parts = (int)fmax(1, ceil(sqrt(share)));
    for (int row = 0; row < map->height * parts; row++)
        draw_row(cube, weights, map, row, parts);
    weigh(cube, weights, map);
    free(weights);
}

/* --- sums ------------------------------------------------------------------------------------- */

static double luminance(const double rgb[3]) {
    return .2126 * rgb[0] + .7152 * rgb[1] + .0722 * rgb[2];
}

static void sum_up(struct cube *cube) {
    for (int face = 0; face < 6; face++)
        for (int y = 0; y < N; y++) {
            double row = 0, row_squares = 0;
            for (int x = 0; x < N; x++) {
                double energy = luminance(cube->energy[face][y][x]);
                struct area texel = {face, x, y, x + 1, y + 1};
                row += energy;
                row_squares += energy * energy / solid_angle(&texel);
                cube->sums[face][y + 1][x + 1] = cube->sums[face][y][x + 1] + row;
                cube->squares[face][y + 1][x + 1] = cube->squares[face][y][x + 1] + row_squares;
            }
        }
}

static double sum_of(const double (*sums)[SIDE_SUMS], const struct area *area) {
    return sums[area->y_end][area->x_end] - sums[area->y_end][area->x] -
           sums[area->y][area->x_end] + sums[area->y][area->x];
}

static double energy_of(const struct cube *cube, const struct area *area) {
    return sum_of(cube->sums[area->face], area);
}

/* --- growing ---------------------------------------------------------------------------------- */

/* The next texels on a side of the area: left, right, below, above. */
static struct area next_to(const struct area *area, int side) {
    struct area next = *area;
    switch (side) {
    case 0:
        next.x_end = next.x--;
        break;
    case 1:
        next.x = next.x_end++;
        break;
    case 2:
        next.y_end = next.y--;
        break;
    case 3:
        next.y = next.y_end++;
        break;
    }
    return next;
}

static bool is_free(const struct cube *cube, const struct area *area) {
    if (area->x < 0 || area->y < 0 || area->x_end > N || area->y_end > N)
        return false;
    for (int y = area->y; y < area->y_end; y++)
        for (int x = area->x; x < area->x_end; x++)
            if (cube->taken[area->face][y][x])
                return false;
    return true;
}

static void take(struct cube *cube, const struct area *area) {
    for (int y = area->y; y < area->y_end; y++)
        for (int x = area->x; x < area->x_end; x++)
            cube->taken[area->face][y][x] = true;
}

/* By one side, that which adds most; false where none adds its share. */
static bool grow(const struct cube *cube, struct area *area, double share) {
    double own = energy_of(cube, area), most = -1;
    struct area best = *area;
    for (int side = 0; side < 4; side++) {
        struct area next = next_to(area, side);
        if (!is_free(cube, &next))
            continue;
        double added = fmax(energy_of(cube, &next), 0);
        if (added > most && added >= share * (own + added)) {
            most = added;
            best = next;
        }
    }
    if (most < 0)
        return false;
    area->x = best.x < area->x ? best.x : area->x;
    area->y = best.y < area->y ? best.y : area->y;
    area->x_end = best.x_end > area->x_end ? best.x_end : area->x_end;
    area->y_end = best.y_end > area->y_end ? best.y_end : area->y_end;
    return true;
}

struct seed {
    double brightness; /* its logarithm, in steps: what is even but for rounding goes in order */
    int face, x, y;
};

static int brighter_first(const void *a, const void *b) {
    const struct seed *x = a, *y = b;
    if (x->brightness != y->brightness)
        return x->brightness > y->brightness ? -1 : 1;
    int place_x = (x->face * N + x->y) * N + x->x, place_y = (y->face * N + y->y) * N + y->x;
    return place_x < place_y ? -1 : 1;
}

/* All texels, the brightest first. */
static struct seed *find_seeds(const struct cube *cube) {
    struct seed *seeds = mem_alloc(6 * N * N, sizeof *seeds);
    for (int i = 0; i < 6 * N * N; i++) {
        struct seed *seed = &seeds[i];
        seed->face = i / (N * N);
        seed->y = i / N % N;
        seed->x = i % N;
        struct area texel = {seed->face, seed->x, seed->y, seed->x + 1, seed->y + 1};
        double energy = luminance(cube->energy[seed->face][seed->y][seed->x]);
        seed->brightness = round(0x1p20 * log2(energy / solid_angle(&texel)));
    }
    qsort(seeds, 6 * N * N, sizeof *seeds, brighter_first);
    return seeds;
}

/* Returns how many there are, or count + 1 where there are more. What is black is no light. */
static int grow_all(struct cube *cube, const struct seed *seeds, double share, struct area *areas,
                    int count) {
    int found = 0;
    memset(cube->taken, 0, sizeof cube->taken);
    for (int i = 0; i < 6 * N * N; i++) {
        const struct seed *seed = &seeds[i];
        struct area area = {seed->face, seed->x, seed->y, seed->x + 1, seed->y + 1};
        if (cube->taken[seed->face][seed->y][seed->x])
            continue;
        if (isinf(seed->brightness))
            break;
        if (found == count)
            return count + 1;
        while (grow(cube, &area, share))
            ;
        take(cube, &area);
        areas[found++] = area;
    }
    return found;
}

/* In units of 1 / N; more lights the greater it is, but for a few. */
static int fit_rectangles(struct cube *cube, struct area *areas, int count) {
    struct seed *seeds = find_seeds(cube);
    double low = -40, high = log(N); /* logarithms of tau */
    int found = 0;
    for (int step = 0; step < 24; step++) {
        double tau = (low + high) / 2;
        int got = grow_all(cube, seeds, exp(tau) / N, areas, count);
        if (got > count)
            high = tau;
        else
            low = tau;
        if (got == count)
            break;
    }
    found = grow_all(cube, seeds, exp(low) / N, areas, count);
    if (found > count) /* with black between: a light a face */
        found = grow_all(cube, seeds, 0, areas, count);
    free(seeds);
    return found;
}

/* --- cutting ---------------------------------------------------------------------------------- */

/* What it costs to have an area even: energy that is not where it was, at most, times how far it
 * may have moved, squared; and a share of all of it, for what hides a wide light is known at a few
 * points of it. A strip is as wide as it is long. */
static double spread_of(const struct cube *cube, const struct area *area) {
    static const double least_share = .1;
    double wide = area->x_end - area->x, high = area->y_end - area->y;
    double angle = solid_angle(area), energy = energy_of(cube, area);
    double squares = sum_of(cube->squares[area->face], area);
    double moved = sqrt(fmax(squares * angle - energy * energy, 0));
    return (moved + least_share * energy) * angle * (wide / high + high / wide) / 2;
}

/* The best of all cuts across one side; its cost. */
static double cut_across(const struct cube *cube, const struct area *area, bool across,
                         struct area best[2]) {
    int first = across ? area->x : area->y, end = across ? area->x_end : area->y_end;
    double least = INFINITY;
    for (int at = first + 1; at < end; at++) {
        struct area parts[2] = {*area, *area};
        *(across ? &parts[0].x_end : &parts[0].y_end) = at;
        *(across ? &parts[1].x : &parts[1].y) = at;
        double cost = spread_of(cube, &parts[0]) + spread_of(cube, &parts[1]);
        if (cost < least) {
            least = cost;
            memcpy(best, parts, sizeof parts);
        }
    }
    return least;
}

static void cut_in_two(const struct cube *cube, const struct area *area, struct area parts[2]) {
    struct area upright[2];
    double across = cut_across(cube, area, true, parts);
    if (cut_across(cube, area, false, upright) < across)
        memcpy(parts, upright, sizeof upright);
}

/* The area that costs most is cut next. */
static int cut_faces(const struct cube *cube, struct area *areas, int count) {
    int found = 6;
    for (int face = 0; face < 6; face++)
        areas[face] = (struct area){face, 0, 0, N, N};
    for (; found < count; found++) {
        struct area *most = NULL, parts[2];
        for (int i = 0; i < found; i++) {
            bool single = areas[i].x_end - areas[i].x == 1 && areas[i].y_end - areas[i].y == 1;
            if (!single && (!most || spread_of(cube, &areas[i]) > spread_of(cube, most)))
                most = &areas[i];
        }
        if (!most)
            break;
        cut_in_two(cube, most, parts);
        *most = parts[0];
        areas[found] = parts[1];
    }
    return found;
}

/* --- lights ----------------------------------------------------------------------------------- */

static void set_corner(float corner[3], const struct area *area, int x, int y) {
    const float(*axes)[3] = face_axes[area->face];
    double length = sqrt(1 + edge_of(x) * edge_of(x) + edge_of(y) * edge_of(y));
    for (int c = 0; c < 3; c++)
        corner[c] = (float)(((double)axes[0][c] * edge_of(x) + (double)axes[1][c] * edge_of(y) +
                             (double)axes[2][c]) /
                            length);
}

static struct environment_light light_of(const struct cube *cube, const struct area *area) {
    struct environment_light light = {.solid_angle = (float)solid_angle(area)};
    double energy[3] = {0};
    for (int y = area->y; y < area->y_end; y++)
        for (int x = area->x; x < area->x_end; x++)
            for (int c = 0; c < 3; c++)
                energy[c] += cube->energy[area->face][y][x][c];
    for (int c = 0; c < 3; c++)
        light.radiance[c] = (float)(energy[c] / solid_angle(area));
    set_corner(light.corners[0], area, area->x, area->y);
    set_corner(light.corners[1], area, area->x_end, area->y);
    set_corner(light.corners[2], area, area->x_end, area->y_end);
    set_corner(light.corners[3], area, area->x, area->y_end);
    return light;
}

static float brightness(const struct environment_light *light) {
    return .2126F * light->radiance[0] + .7152F * light->radiance[1] + .0722F * light->radiance[2];
}

static int brightest_first(const void *a, const void *b) {
    float x = brightness(a), y = brightness(b);
    return (x < y) - (x > y);
}

int environment_fit(struct environment_light *lights, const struct environment *environment,
                    enum sky_fit fit, int count) {
    struct cube *cube = mem_alloc(1, sizeof *cube);
    struct area areas[ENVIRONMENT_LIGHTS_MAX];
    draw_map(cube, environment);
    sum_up(cube);
    int found = fit == SKY_FIT_RECTANGLES ? fit_rectangles(cube, areas, count)
                                          : cut_faces(cube, areas, count);
    int kept = 0;
    for (int i = 0; i < found; i++) {
        lights[kept] = light_of(cube, &areas[i]);
        kept += brightness(&lights[kept]) > 0;
    }
    qsort(lights, (size_t)kept, sizeof *lights, brightest_first);
    free(cube);
    return kept;
}

struct environment_light environment_light_turned(const struct environment_light *light,
                                                  const struct environment *environment) {
    struct environment_light turned = *light;
    float turn = glm_rad(environment->turn), sine = sinf(turn), cosine = cosf(turn);
    for (int i = 0; i < 4; i++) {
        turned.corners[i][0] = cosine * light->corners[i][0] + sine * light->corners[i][2];
        turned.corners[i][2] = cosine * light->corners[i][2] - sine * light->corners[i][0];
    }
    for (int c = 0; c < 3; c++)
        turned.radiance[c] *= environment->strength;
    return turned;
}

void environment_light_vector(const struct environment_light *light, float vector[3]) {
    double sum[3] = {0};
    for (int i = 0; i < 4; i++) {
        const float *a = light->corners[i], *b = light->corners[(i + 1) % 4];
        double across[3], square = 0, along = 0;
        for (int c = 0; c < 3; c++) {
            int d = (c + 1) % 3, e = (c + 2) % 3;
            across[c] = (double)a[d] * (double)b[e] - (double)a[e] * (double)b[d];
            along += (double)a[c] * (double)b[c];
            square += across[c] * across[c];
        }
        double sine = sqrt(square);
        for (int c = 0; c < 3 && sine > 0; c++)
            sum[c] += .5 * atan2(sine, along) / sine * across[c];
    }
    for (int c = 0; c < 3; c++)
        vector[c] = (float)sum[c];
}

void environment_light_direction(const struct environment_light *light, const float place[2],
                                 float direction[3]) {
    vec3 from, to;
    glm_vec3_lerp((float *)light->corners[0], (float *)light->corners[1], place[0], from);
    glm_vec3_lerp((float *)light->corners[3], (float *)light->corners[2], place[0], to);
    glm_vec3_lerp(from, to, place[1], direction);
}
