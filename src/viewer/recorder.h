/* Records a clip, frame by frame, however long each takes: numbered pictures, or a video through
 * ffmpeg. */
#ifndef VIEWER_RECORDER_H
#define VIEWER_RECORDER_H

#include <stdbool.h>
#include <stdio.h>

enum record_kind { RECORD_PICTURES, RECORD_VIDEO };

struct recorder {
    bool on;
    enum record_kind kind;
    int first, frame,
        count;         /* of the clip where it begins; the one to come, from there; how many */
    double started;    /* when, window_time */
    char folder[512];  /* where it goes */
    int width, height; /* of the frames; 0 before the first */
    char name[600];    /* of its own folder, or of the video */
    char part[600];    /* of the video until it is whole */
    FILE *pipe;        /* to ffmpeg */
};

/* What is to be recorded, while it is asked for. */
struct record_request {
    bool is_open;
    enum record_kind kind;
    float from, to; /* seconds of the clip */
    char folder[512];
};

#endif
