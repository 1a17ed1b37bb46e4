/* Draws values in false colours, with a scale bar and a title below.
 *
 * Colours are paths through CIELAB whose lightness is linear in the value, so the picture is
 * readable in grey and for colour-blind eyes. Unsigned: from black by violet and orange to pale
 * yellow. Signed: from blue (too dark) by white to red (too bright). */
#ifndef METRICS_HEAT_MAP_H
#define METRICS_HEAT_MAP_H

#include "base/image.h"

#include <stdbool.h>

struct heat_map {
    const char *title; /* characters of label_draw */
    int width, height;
    const float *values; /* height x width */
    float top;           /* value at the end of the scale */
    bool is_signed;      /* true: scale from -top; false: from 0 */
};

/* Returns a round number that 99 % of the magnitudes do not exceed; 1 if all are 0. */
float heat_map_fit_top(const float *values, size_t count);

/* Computes the colour of a value. */
void heat_map_color(const struct heat_map *map, float value, unsigned char rgb8[3]);

/* Makes the picture of the values without scale, one pixel per value. */
void heat_map_draw_values(const struct heat_map *map, struct bitmap *picture);

/* Adds scale and title below a picture, which grows to the width that they need. */
void heat_map_add_scale(const struct heat_map *map, struct bitmap *picture);

/* Makes the picture with scale and title. An integer factor enlarges small maps until the scale
 * fits. */
void heat_map_draw(const struct heat_map *map, struct bitmap *picture);

/* Writes the picture with scale and title. Formats of floats (EXR ...) receive the values as one
 * channel. Error: as of the file. */
bool heat_map_write(const struct heat_map *map, const char *path);

#endif
