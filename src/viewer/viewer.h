/* The desktop viewer: a window on a scene, rendered live, and all that its modules share.
 *
 * Each turn of the loop takes what the user did, lets the modules change what is wanted (struct
 * viewer), renders where something changed, and shows it. What fails leaves a message and the last
 * good state. */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include "gl/context.h"
#include "renderer/renderer.h"
#include "viewer/inspect.h"
#include "viewer/loader.h"
#include "viewer/messages.h"
#include "viewer/orbit.h"
#include "viewer/pace.h"
#include "viewer/screen.h"
#include "viewer/window.h"

struct viewer_desc {
    const char *scene; /* NULL: none yet */
    int width, height; /* of the picture */
    int technique;
    struct settings settings;
    const char *camera, *light; /* names or numbers; NULL = the first */
    const char *glsl;           /* folder of shaders; NULL = embedded */
    bool debug;
    int frames;             /* render so many and end; 0 = until closed */
    const char *screenshot; /* written at the end; NULL = none */
};

struct viewer {
    struct viewer_desc desc;
    struct window *window;
    struct context *context;
    const struct input *input;
    struct messages messages;
    struct pace pace;
    struct screen screen;

    /* The scene, and the renderer that draws it where has_scene. */
    struct loader loader;
    struct document document;
    struct renderer renderer;
    bool has_scene;

    /* What is wanted; the renderer follows. */
    int technique;
    struct settings settings;
    int camera, light; /* of the scene */
    struct orbit orbit;
    struct light placed_light;

    /* What is shown. */
    int layer; /* LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    struct inspect inspect;
    struct inspect_choice choice; /* SHOW_PICTURE, or a buffer */
    bool show_panel, show_overlay, show_help;
    struct rectangle area;    /* of the window that the picture may take */
    struct rectangle picture; /* where it lies */

    bool dirty;      /* the picture is not what is wanted */
    bool recompose;  /* the frame is, but not what is shown of it */
    bool moving;     /* and this will go on for some frames */
    bool done;       /* close the window */
    int frame_count; /* rendered */

    /* viewer/controls.c */
    double last_update;
    bool drags_picture; /* the mouse was pressed on it */
    double press_x, press_y;
};

/* Runs until the window is closed, or until desc->frames. Error: no window, or, where frames are
 * counted, a scene or file that fails. */
bool viewer_run(const struct viewer_desc *desc);

/* --- what its modules do with it --- */

/* Marks the picture as moving: it is rendered at once, and as small as it must be. */
void viewer_touch(struct viewer *viewer);

void viewer_open(struct viewer *viewer, const char *path);

/* Places the scene's n-th camera or light. */
void viewer_pick_camera(struct viewer *viewer, int n);
void viewer_pick_light(struct viewer *viewer, int n);

/* Shows the next buffer that the technique has, or the one before. */
void viewer_step_buffer(struct viewer *viewer, int step);

/* Writes the picture as PNG and EXR under a fresh name in the working folder. */
void viewer_take_screenshot(struct viewer *viewer);

/* viewer/controls.c: keys and mouse. */
void controls_update(struct viewer *viewer);
void controls_draw_help(void);

/* viewer/panel.c and viewer/overlay.c */
void panel_draw(struct viewer *viewer);
void overlay_draw(struct viewer *viewer);

#endif
