/* The reference of the view, as the viewer has it: traced in the background, compared as it comes. */
#ifndef VIEWER_TRACING_H
#define VIEWER_TRACING_H

#include "viewer/chart.h"
#include "viewer/reference_tracer.h"

struct tracing {
    struct reference_tracer tracer;
    struct session view; /* that the reference was traced of; without lights: none was */
    bool of_view;        /* and it is the present one */
    int samples;         /* of the reference, a pixel; 0: none yet */
    double noise;        /* of its indirect layer: standard error, RMS over mean */
    double full_noise;   /* the same light's, over the mean of the whole picture */
    /* Of the left picture's indirect layer, the noise taken off: relative RMSE; and of which frame and
     * how many samples it tells. */
    bool has_error;
    double error;
    int error_frame, error_samples;

    struct chart chart; /* of the same view */
    int chart_samples;  /* of the reference that its errors are against */
};

#endif
