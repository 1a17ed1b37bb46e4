/* State that all parts of the viewer share. Parts change the wish and the places of camera and
 * lights; the picture follows. */
#ifndef VIEWER_STATE_H
#define VIEWER_STATE_H

#include "base/file/file.h"
#include "gl/context/context.h"
#include "inspect/inspect.h"
#include "inspect/probe.h"
#include "inspect/screen.h"
#include "quality/time_budget.h"
#include "renderer/renderer.h"
#include "scene/lights/environment.h"
#include "viewer/files/file_dialog.h"
#include "viewer/files/loader.h"
#include "viewer/files/preview.h"
#include "viewer/picture/compare.h"
#include "viewer/picture/compiling.h"
#include "viewer/picture/pace.h"
#include "viewer/reference/method_table.h"
#include "viewer/reference/reference_tracer.h"
#include "viewer/scene/history.h"
#include "viewer/scene/light_tool.h"
#include "viewer/scene/orbit.h"
#include "viewer/scene/session.h"
#include "viewer/window/messages.h"
#include "viewer/window/window.h"

enum { PASSES_AT_REST = 1024, OWN_SCENES_MAX = 40 };

/* Options of the viewer. */
#define SESSION_PATH "manylight.settings"

struct viewer_desc {
    const char *scene; /* NULL: none */
    int width, height; /* of the picture */
    const struct technique *technique;
    const struct direct_method *direct;
    struct settings settings;
    const struct text_list *given; /* settings that the budget does not change; NULL: none */
    float budget;                  /* time per frame, ms; 0: no limit */
    struct scene_choice choice;
    const char *camera, *light; /* texts of scene/placing.h; NULL: the first camera, all lights */
    const char *clip;           /* text of scene/clips.h; NULL: the default */
    struct environment_desc environment;
    float punctual_scale;  /* factor of intensities (scene/lights/punctual.h) */
    float time;            /* of the animation, seconds */
    int layer;             /* shown: LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    const char *reference; /* picture to compare with; NULL: none */
    const char *glsl;      /* folder of shaders; NULL: embedded */
    int screen;            /* enum screen_way (gl/screen.h) */
    bool debug;
    int frames; /* number of frames to render; 0: until closed */
    int passes; /* passes of a picture at rest; 0: PASSES_AT_REST, but 1 on software OpenGL, where a
                   pass may take seconds */
    const char *screenshot; /* written at the end; NULL: none */
    const char *session;    /* file of settings, camera and lights; NULL: none */
    float scale;            /* of text and widgets; 0: the monitor's */
    bool full_screen, no_panel;
    bool auto_exposure; /* set the exposure automatically when a scene is opened */
    const char *places; /* file that gets the places of widgets, for scripts; NULL: none */
};

/* The window, and all that lives as long. */
struct host {
    struct window *window;
    struct context *context;
    const struct input *input; /* of this turn */
    struct messages messages;
    int message_count; /* shown */
    double newest_message;
    double awake_until; /* time until which frames are drawn without events */
    double last_drawn;
    int width, height; /* of the window at last_drawn */
    struct screen screen;
    bool window_shown, coarse_shown, picture_shown; /* at least once */
    int timeline_room; /* height added to the window for the timeline, pixels */
};

/* The wanted picture; the renderer follows. */
struct wish {
    const struct technique *technique;
    const struct direct_method *direct; /* NULL: chosen by the lights' sizes, which may change */
    struct settings settings;
    int passes;   /* as in struct viewer_desc */
    float budget; /* ms; 0: none */
    struct playing {
        bool on, loops;
        float speed; /* seconds of the animation per second */
    } play;
};

/* The shown picture: viewer/picture/picture.c. */
struct shown {
    struct renderer renderer; /* valid if has_scene */
    struct pace pace;
    int layer; /* LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    struct inspect inspect;
    struct inspect_choice choice; /* an output, or none */
    struct compare compare;
    char *reference_view;          /* text of the reference's view; NULL: unknown */
    const float *reference_pixels; /* pixels of the reference with that view */
    struct probe probe;
    struct pick pick;
    bool has_pick;
    double pick_motion;                 /* pace.last_motion of the pick */
    int fixed_width, fixed_height;      /* of the picture, pixels; 0: by the window */
    struct rectangle area;              /* part of the window for pictures */
    struct rectangle room;              /* part of the area for one picture */
    struct rectangle picture;           /* place of the picture; enlarged, larger than its room */
    const struct texture *left, *right; /* composed pictures */
    bool dirty;                         /* the picture differs from the wish */
    bool awaits;    /* the wish waits for shaders, which are compiled in the background */
    bool recompose; /* the frame is right, but its composition is not */
    bool moving;    /* it changes and will change in the next frames */
    bool coarse;    /* the picture is smaller than at rest, and not antialiased */
    struct time_budget budget; /* if wish.budget > 0 */
    bool is_new_level;         /* no frame of this level has been drawn */
    int frame_count;           /* rendered frames */
    const char *busy;          /* announced work that takes a while; NULL: none */
};

/* Zoom and layout of the picture: viewer/picture/look.c. */
struct look {
    double zoom;      /* pixels of the window per pixel; 0: fitted */
    double middle[2]; /* place in the picture at the middle of its room, 0 to 1 */
    enum screen_layout layout;
    bool inspects; /* show viewer/panel/inspector.c */
};

/* State of the mouse: viewer/panel/controls.c, viewer/scene/camera_hand.c. */
struct hand {
    struct light_tool light_tool;
    double last_update, last_escape;
    double last_grab, grab_x, grab_y; /* time and place of the last zoom to a point */
    float fly_speed;                  /* scene radii per second; 0: the default */
    bool drags_picture;               /* the mouse was pressed on the picture */
    bool drags_split;
};

/* Panel and overlay: viewer/panel/panel.c, viewer/panel/overlay.c. */
struct panel {
    bool is_open, help;
    enum overlay_kind { OVERLAY_LINE, OVERLAY_TABLE, OVERLAY_NONE, OVERLAY_KINDS } overlay;
    char scene_path[512], reference_path[512], session_path[512],
        sky_path[512];                 /* typed, or paths of what is open */
    char filter[32];                   /* filter of the settings under Advanced */
    bool was_comparing;                /* when the panel was drawn last */
    bool saves_picture;                /* the button was pressed */
    bool shows_table;                  /* scroll to the table when it is drawn */
    bool edits_right;                  /* edit the settings of the right picture */
    char *places;                      /* as written last; NULL: not yet */
    int places_asked, places_answered; /* counts */
};

/* The traced reference: viewer/reference/tracing.c. */
struct tracing {
    struct reference_tracer tracer;
    struct session view; /* view of the reference; without lights: none */
    bool of_view;        /* it is the present view */
    int samples;         /* samples per pixel of the reference; 0: none yet */
    double noise;        /* standard error of its indirect layer, RMS over mean */
    double full_noise;   /* standard error of the same layer, over the mean of the picture */
    /* Relative RMSE of the left picture's indirect layer, noise subtracted; its frame and
     * samples. */
    bool has_error;
    double error;
    int error_frame, error_samples;

    struct method_table table; /* of this view */
    int table_samples;         /* samples of the reference of its errors */
};

/* A scene or a sky that is being opened: viewer/files/opening.c, viewer/scene/sky.c. */
struct opening {
    struct loader loader;
    double since;                     /* when the scene was requested, seconds */
    struct document arriving;         /* if is_arriving: read, waits for its shaders */
    struct document leaving;          /* abandoned, but its shaders are still being compiled */
    struct environment *arriving_sky; /* waits for its shaders; NULL: none */
    struct environment *leaving_sky;  /* abandoned, but its shaders are still being compiled */
    struct preview preview;           /* of the arriving scene */
    bool is_arriving;
    bool is_announced; /* its renderer is made next */
    struct reloading {
        struct file_stamp asked, shown, seen; /* stamps of the file */
        struct scene_open_desc desc;          /* how it was opened */
        double looked;                        /* time of the last look */
        bool on;                              /* the arriving scene is the same file */
    } reloading;
};

struct viewer {
    struct viewer_desc desc;
    struct host host;
    struct opening opening;
    struct compiling compiling;
    struct document document; /* valid if has_scene */
    bool has_scene;
    struct wish wish;
    struct placed {
        int camera_number; /* index of the scene's camera */
        bool camera_moved; /* moved by hand, no longer by an animation */
        struct orbit orbit;
        char views[SESSION_VIEWS][PLACING_TEXT_SIZE]; /* kept cameras: viewer/scene/placed.c */
        struct emitters emitters;                     /* lights that shine */
        int chosen_light;                             /* index of the chosen light */
        double time, posed_time;                      /* of the animation, seconds */
    } placed;
    struct shown shown;
    struct look look;
    struct hand hand;
    struct panel panel;
    struct history history;
    struct tracing tracing;
    struct own_scenes {
        char *paths[OWN_SCENES_MAX];
        int count;
        bool is_listed;
    } own_scenes; /* scenes of the program, in the empty window */
    struct file_dialog dialog;
    struct exposing {
        float usual;     /* exposure that the scene began with, EV */
        bool waits;      /* the first frame is not drawn yet */
        int after_frame; /* shown.frame_count before the first frame */
    } exposing;
    bool done; /* close the window */
};

/* Returns true if it renders a given number of frames, all at the given size. */
bool viewer_is_scripted(const struct viewer *viewer);

/* Marks the picture as moving: it is rendered at once, at a small size if need be. */
void viewer_touch(struct viewer *viewer);

/* Shows and prints the current error. */
void viewer_tell_error(struct viewer *viewer);

#endif
