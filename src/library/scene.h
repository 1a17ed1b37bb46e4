/* Shares a scene among users. World-space triangles move with time, so each user has its own. A
 * change of a part (library/changes.c) marks the scene. Its next user makes it ready again as its
 * opening did, so its pictures are those of a scene opened with the change. */
#ifndef LIBRARY_SCENE_H
#define LIBRARY_SCENE_H

#include "library/manylight.h"
#include "renderer/stage.h"

#include <pthread.h>
#include <stdatomic.h>

/* Lists of a scene before its opening adds lights and cameras; the scene's own nodes have the
 * morph weights. */
struct original {
    struct scene lists;   /* only nodes, lights and cameras */
    float turn, strength; /* of the sky */
};

struct manylight_scene {
    atomic_int users;
    pthread_mutex_t mutex; /* of all below */
    int calls;             /* that use the scene, and keep changes out */
    struct stage stage;    /* at time 0 */
    bool is_lent;          /* its triangles are */
    bool is_marked;        /* a part has changed since the last use */
    bool is_reshaped;      /* by a change that renderers do not follow; they follow lights,
                            * triangles, base colours, turn and strength of the sky */
    bool is_broken;        /* the change could not be followed */
    unsigned edition;      /* counts changes that were followed */
    unsigned reshaped;     /* edition of the last change that renderers do not follow */
    struct original original;
    char *light; /* as it was opened; NULL: all */
    struct manylight_scene_info info;
};

/* Keeps changes out until scene_leave, after following those made. Error: a change made vertices
 * that cannot be shown, or none. */
bool scene_use(const struct manylight_scene *scene);
void scene_leave(const struct manylight_scene *scene);

/* Keep copies of the lists, and free them. */
void original_keep(struct original *original, const struct scene *scene);
void original_free(struct original *original);

/* Writes the scene's info. */
void scene_describe(struct manylight_scene *scene);

/* A stage that shares the scene's data. The first user gets the scene's triangles, others
 * copies. */
struct loan {
    struct manylight_scene *from;
    struct stage stage;
    bool has_original;
    unsigned edition; /* of the scene that it is of */
};

/* Lends the scene, in use, at time 0 and keeps it alive until loan_return. Error: out of memory. */
bool loan_take(struct loan *loan, const struct manylight_scene *scene);

/* Lends the scene, in use, again after a change, by geometry_follow. Error: that of loan_take; it
 * must be returned. */
bool loan_renew(struct loan *loan);
bool loan_is_current(const struct loan *loan);

/* Returns true if renderers of the loan may follow its renewal. */
bool loan_is_followed(const struct loan *loan);

/* Returns the triangles and releases the scene. Accepts a zeroed loan. */
void loan_return(struct loan *loan);

/* Poses the stage at the view's time and places its camera and lights. Zeroed views select the
 * defaults. */
bool loan_pose(struct loan *loan, const struct manylight_view *view);

/* Writes where the view's placed camera is in the next and the previous frame. */
bool loan_place_others(const struct manylight_view *view, struct camera others[2]);

/* Finds the motion of the posed stage between frames. camera: text of the view's camera. placed:
 * of loan_place_others, NULL: by the text. */
bool loan_find_motion(struct loan *loan, const char *camera, const struct camera *placed,
                      double time, double step, struct surface_motion *motion);

/* Checks the numbers of a camera. Error: names the member that is not finite or out of range. */
bool check_camera(const struct manylight_camera *camera);

/* Finds the picture size in pixels: width x height, or the named camera's size if both are 0.
 * Error: an invalid size or camera. */
bool loan_size(const struct loan *loan, const char *camera, int width, int height, int size[2]);

#endif
