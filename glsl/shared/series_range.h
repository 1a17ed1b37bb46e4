/* The depths that a map's casters take, to which its Fourier series is fitted (visibility/series.glsl). A
 * compute shader writes them (visibility/series_range.comp). */
#ifndef SHARED_SERIES_RANGE_H
#define SHARED_SERIES_RANGE_H

#include "shared/map_view.h"
#include "shared/types.h"

struct series_range { /* map depths */
    float nearest, farthest;
    float knee;  /* beyond the nearest: there a step takes four times as many metres */
    float scale; /* of the argument: no depth */
};
STD140_SIZE(series_range, 16)

/* 16 KiB, what GL promises to a uniform block. */
#define SERIES_RANGES_MAX MAP_VIEWS_MAX

#endif
