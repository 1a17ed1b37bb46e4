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
    int frame, count;  /* the one to come */
    int width, height; /* of the frames; 0 before the first */
    char name[64];     /* of the folder, or of the video */
    char part[72];     /* of the video until it is whole */
    FILE *pipe;        /* to ffmpeg */
};

#endif
