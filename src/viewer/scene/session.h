/* Describes what is shown and how: as a command line that renders the same picture offscreen,
 * and as a file of settings. */
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
    char shown_scene[CHOICE_TEXT_SIZE], variant[CHOICE_TEXT_SIZE]; /* texts of scene/choice.h */
    char *sky;                    /* path of the environment; NULL: none */
    float sky_turn, sky_strength; /* of struct environment; 0 and 1 without one */
    int width, height;
    const struct technique *technique;
    const struct direct_method *direct; /* NULL: by the lights' sizes */
    int passes;                         /* at rest; 0: the default */
    struct settings settings;
    int layer;                  /* LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    float time;                 /* of the animation, seconds */
    char clip[CLIPS_TEXT_SIZE]; /* text of scene/clips.h; "": the default */
    char camera[PLACING_TEXT_SIZE];
    char views[SESSION_VIEWS][PLACING_TEXT_SIZE]; /* texts of kept cameras; "": none */
    char *lights;
};

/* Sets the sky of a session that has none. */
void session_set_sky(struct session *session, const struct environment *sky);

/* Returns a copy that does not point into the scene, which may be freed before it. */
struct session session_copy(const struct session *session);
void session_free(struct session *session);

/* Returns the number of bounces. */
int session_bounces(const struct session *session);

bool session_same_sky(const struct session *a, const struct session *b);

/* Returns true if both have the same reference but for its size: place, lights, time, bounces,
 * sky, medium, materials and glass are equal. */
bool session_same_view(const struct session *a, const struct session *b);

/* Returns "manylight render SCENE --size ... -o picture.png", quoted for a shell, without
 * settings at their defaults. The caller frees it. */
char *session_command(const struct session *session);

/* Writes one "key = value" per line: technique, direct method, passes, layer, clip, time,
 * camera, views, lights, sky, and settings that differ from their defaults. */
bool session_save(const struct session *session, const char *path);

/* Reads a file; other settings get their defaults. Error: names the file, and the line that cannot
 * be read; nothing changes. */
bool session_load(struct session *session, const char *path);

#endif
