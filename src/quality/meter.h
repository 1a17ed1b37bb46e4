/* Measures the light that sensors receive: irradiance of a scene at points, by frames or by the
 * path tracer.
 *
 * A frame measures one sensor: its camera sees a small white plane there in place of all surfaces,
 * so every technique and direct method works. Sensors block no light. */
#ifndef QUALITY_METER_H
#define QUALITY_METER_H

#include "base/progress.h"
#include "quality/measure.h"
#include "reference/path_tracer.h"

/* Irradiance by luminance (ITU-R BT.709), W/m2. */
struct reading {
    double direct, indirect;
    double error; /* standard error of the sum; 0 of frames, which do not tell it */
};

/* Measures by frames of the desc, whose size is ignored. Error: caustics; as of the renderer. */
bool meter_frames(const struct measure_desc *desc, const struct sensor *sensors, int count,
                  struct progress *progress, struct reading *readings);

/* Measures by the path tracer; the desc needs bounces, and samples or noise. reached: as there.
 * Error: that of path_tracer_render. */
bool meter_paths(const struct stage *stage, const struct path_tracer_desc *desc,
                 const struct sensor *sensors, int count, struct reading *readings,
                 struct path_tracer_progress *reached);

#endif
