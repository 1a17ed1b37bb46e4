/* Options of `manylight render`. */
#ifndef APPS_RENDER_OPTIONS_H
#define APPS_RENDER_OPTIONS_H

#include "apps/arguments.h"
#include "apps/frames.h"
#include "apps/in_time.h"
#include "apps/options.h"
#include "apps/videos.h"
#include "apps/view_list.h"

/* Values of the command line, and state that frames share. */
struct render_values {
    struct common_values common;
    struct context_desc context;
    struct technique_values technique;
    struct stage_desc stage;
    struct text_list outputs; /* pictures */
    struct videos videos;
    int size[2];
    int layer;
    const char *format, *background, *frames, *glsl, *aov, *cameras;
    struct view_list views; /* of --cameras */
    int quality, passes, first_pass;
    bool passes_given; /* --passes is given */
    float max_error, budget;
    const char *fps;
    struct frame_rate rate; /* parsed from fps */
    bool skip_existing, stats;
    struct in_time in_time;    /* if budget > 0 */
    int traced;                /* samples per pixel of path tracing in place of frames; 0: frames */
    struct image picture;      /* if traced > 0 */
    struct progress *progress; /* of the frames */
    struct surface_motion motion; /* of the frame, if a layer shows motion */
    char *choice;                 /* text: the chosen quality and the reason */
};

extern const struct arguments render_arguments;

#endif
