/* What is looked at and how, as text: a command line that renders the very same picture offscreen,
 * and a file of settings. */
#ifndef VIEWER_SESSION_H
#define VIEWER_SESSION_H

#include "renderer/settings.h"
#include "scene/clips.h"
#include "scene/lights/environment.h"
#include "scene/placing.h"

#include <stdbool.h>

enum { SESSION_VIEWS = 9 };

struct session {
    const char *scene;                                             /* path */
    char shown_scene[CHOICE_TEXT_SIZE], variant[CHOICE_TEXT_SIZE]; /* as scene/choice.h has it */
    char *sky;                    /* path of the environment; NULL = none */
    float sky_turn, sky_strength; /* as struct environment has them; 0 and 1 without one */
    int width, height;
    const struct technique *technique;
    const struct direct_method *direct; /* NULL: by the lights' sizes */
    int passes;                         /* at rest; 0: as many as is usual */
    struct settings settings;
    int layer;                  /* that is shown: LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    float time;                 /* of the animation, seconds */
    char clip[CLIPS_TEXT_SIZE]; /* those that play, as scene/clips.h has it; "" = the default */
    char camera[PLACING_TEXT_SIZE];
    char views[SESSION_VIEWS][PLACING_TEXT_SIZE]; /* cameras that were kept; "" = none */
    char *lights;
};

/* Without a sky before. */
void session_set_sky(struct session *session, const struct environment *sky);

/* A copy without what belongs to the scene, which may be gone when it is looked at. */
struct session session_copy(const struct session *session);
void session_free(struct session *session);

/* How often light is reflected. */
int session_bounces(const struct session *session);

bool session_same_sky(const struct session *a, const struct session *b);

/* Whether both have one reference but for its size: place, light, time, bounces, sky, medium,
 * materials and glass. */
bool session_same_view(const struct session *a, const struct session *b);

/* "manylight render SCENE --size ... -o picture.png", quoted for a shell; to be freed. Settings at
 * their defaults are left out. */
char *session_command(const struct session *session);

/* One "key = value" a line: technique, direct light's method, passes, layer, clip, time, camera,
 * views, lights, sky and the settings that are not at their defaults. */
bool session_save(const struct session *session, const char *path);

/* Sets what the file has; settings it does not name get their defaults. A line that cannot be read,
 * as one of a setting of another version, is left out and counted, and the error names file and
 * line of the last. left_out NULL: nothing is changed then, and that is an error. Error, too: the
 * file cannot be read. */
bool session_load(struct session *session, const char *path, int *left_out);

#endif
