/* Records a clip, frame by frame, however long each takes: numbered pictures, or a video through
 * ffmpeg. */
#ifndef VIEWER_RECORDER_H
#define VIEWER_RECORDER_H

#include <stdbool.h>
#include <stdio.h>

struct viewer;

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

/* Whether ffmpeg is there. */
bool recorder_has_video(void);

/* Asks for range and folder: the whole clip, and the working folder, at first. viewer/panel_record.c. */
void recorder_ask(struct viewer *viewer, enum record_kind kind);
void recorder_draw_request(struct viewer *viewer);

/* Records what was asked for, from its first frame. */
void recorder_start(struct viewer *viewer);

/* "12 of 250, 8 minutes left". */
void recorder_tell(const struct viewer *viewer, char *text, size_t size);

/* Ends what there is; nothing where none is recorded. */
void recorder_stop(struct viewer *viewer);

/* Before a frame is rendered, and after. */
void recorder_pose(struct viewer *viewer);
void recorder_write(struct viewer *viewer);

#endif
