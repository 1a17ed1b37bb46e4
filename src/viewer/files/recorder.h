/* Records a clip, frame by frame, however long each takes: numbered pictures, or a video through
 * ffmpeg. */
#ifndef VIEWER_RECORDER_H
#define VIEWER_RECORDER_H

#include "viewer/state.h"

enum { TIMELINE_FPS = 25 }; /* as manylight render --fps has it */

/* Whether ffmpeg is there. */
bool recorder_has_video(void);

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
