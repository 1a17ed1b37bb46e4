/* Times frames: warm-up first, then rounds in which every subject renders once with timers and once
 * without, so that A B A B see the same noise of the machine. */
#ifndef LAB_MEASURE_TIMING_H
#define LAB_MEASURE_TIMING_H

#include "lab/measure/results.h"
#include "lab/measure/reference.h"
#include "lab/measure/variants.h"

struct timing_desc {
    int warm_up, frames; /* of each subject; 0 = by the context: few on the CPU, many on a GPU */
    bool whole_frames;   /* no frames with timers: no medians of passes */
    const char *picture; /* file for the first frame of each subject; NULL = none */
    struct reference_desc reference; /* for errors of the last frame, too; zeroed = none */
};

/* Measures subjects of one stage, up to TIMING_GROUP with a renderer each at the same time, fewer
 * where frames are slow. Commits each when its group is done. Adds the medians of all passes
 * ("frame", "frame/gather" ...), "clock" and "cpu" (a frame without timers; of all cores together),
 * "gpu-memory", errors (against REFERENCE_SEEN shares_add's, against REFERENCE_AO errors_add_ao's),
 * and baseline_add_ratios's. Error: of a renderer or of the reference. */
enum { TIMING_GROUP = 8, TIMING_GROUP_LEAST = 2 };
bool timing_measure(struct results *results, const struct measure_list *subjects,
                    const struct timing_desc *timing);

#endif
