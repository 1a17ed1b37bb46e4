/* A map of values in false colours, with a scale bar and a title below.
 *
 * The colours are paths through CIELAB on which lightness changes in proportion to the value, so
 * that the picture also reads in grey and for colour-blind eyes: from black by violet and orange to
 * pale yellow; for signed values from blue (too dark) by white to red (too bright).
 */
#ifndef METRICS_HEAT_MAP_H
#define METRICS_HEAT_MAP_H

#include "base/image.h"

#include <stdbool.h>

struct heat_map {
    const char *title; /* what label_draw knows */
    int width, height;
    const float *values; /* height x width */
    float top;           /* the value at the scale's end */
    bool is_signed;      /* the scale runs from -top, else from 0 */
};

/* A round number that 99 % of the values' magnitudes do not exceed; 1 when all are 0. */
float heat_map_fit_top(const float *values, size_t count);

/* The colour of one value. */
void heat_map_color(const struct heat_map *map, float value, unsigned char rgb8[3]);

/* Makes the picture of the values alone, in their own size. */
void heat_map_draw_values(const struct heat_map *map, struct bitmap *picture);

/* Makes the picture with scale and title. Small maps are enlarged by a whole factor, so that the
 * scale has room. */
void heat_map_draw(const struct heat_map *map, struct bitmap *picture);

/* Writes such a picture; to a format of floats (EXR ...) the bare values, as one channel. Error: of
 * the file. */
bool heat_map_write(const struct heat_map *map, const char *path);

#endif
