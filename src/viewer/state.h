/* The viewer's state, which all its parts share. Parts change the wish and the places of camera and
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
#include "viewer/files/gallery.h"
#include "viewer/files/loader.h"
#include "viewer/files/preview.h"
#include "viewer/picture/compare.h"
#include "viewer/picture/compiling.h"
#include "viewer/picture/pace.h"
#include "viewer/reference/chart.h"
#include "viewer/reference/reference_tracer.h"
#include "viewer/scene/history.h"
#include "viewer/scene/light_tool.h"
#include "viewer/scene/orbit.h"
#include "viewer/scene/session.h"
#include "viewer/window/messages.h"
#include "viewer/window/window.h"

enum { PASSES_AT_REST = 1024 };

/* In the working folder: where settings are saved until another file is named. */
#define SESSION_PATH "manylight.settings"

struct viewer_desc {
    const char *scene; /* NULL: none yet */
    int width, height; /* of the picture */
    const struct technique *technique;
    const struct direct_method *direct;
    struct settings settings;
    const struct text_list *given; /* those of them that the budget leaves alone; NULL = none */
    float budget;                  /* that a frame may take, ms; 0 = whatever it takes */
    struct scene_choice choice;
    const char *camera, *light; /* as scene/placing.h has it; NULL = the first, and all */
    const char *clip;           /* as scene/clips.h has it; NULL = the default */
    struct environment_desc environment;
    float punctual_scale;  /* of intensities: scene/lights/punctual.h */
    float time;            /* of the animation, seconds */
    int layer;             /* to show: LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    const char *reference; /* a picture to compare with; NULL = none */
    const char *glsl;      /* folder of shaders; NULL = embedded */
    int screen;            /* an enum screen_way (gl/screen.h) */
    bool debug;
    int frames; /* render so many and end; 0 = until closed */
    int passes; /* whose mean a picture at rest becomes; 0 = PASSES_AT_REST, but 1, which is none,
                   on software OpenGL, where a pass may take seconds */
    const char *screenshot; /* written at the end; NULL = none */
    const char *session;    /* a file of settings, camera and lights; NULL = none */
    float scale;            /* of text and widgets; 0 = the monitor's */
    bool full_screen, no_panel;
    bool auto_exposure; /* each scene is exposed by itself when it is opened */
    const char *places; /* file that tells where the widgets are, for scripts; NULL = none */
};

/* The window, and what there is for all of its life. */
struct host {
    struct window *window;
    struct context *context;
    const struct input *input; /* of this turn */
    struct messages messages;
    int message_count; /* that are shown */
    double newest_message;
    double awake_until; /* then nothing is drawn until something happens */
    double last_drawn;
    int width, height; /* of the window then */
    struct screen screen;
    bool window_shown, coarse_shown, picture_shown; /* once */
    int timeline_room; /* pixels that the window has grown by for the timeline */
};

/* What is wanted of a picture; the renderer follows. */
struct wish {
    const struct technique *technique;
    const struct direct_method *direct; /* NULL: by the lights' sizes, which may change */
    struct settings settings;
    int passes;   /* as struct viewer_desc has it */
    float budget; /* ms; 0: none */
    struct playing {
        bool on, loops;
        float speed; /* seconds of the animation a second */
    } play;
};

/* What is shown: viewer/picture/picture.c. */
struct shown {
    struct renderer renderer; /* where has_scene */
    struct pace pace;
    int layer; /* LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    struct inspect inspect;
    struct inspect_choice choice; /* an output, or none */
    struct compare compare;
    char *reference_view;          /* of the reference, as text; NULL = not known yet */
    const float *reference_pixels; /* whose view that is */
    struct probe probe;
    struct pick pick;
    bool has_pick;
    double pick_motion;                 /* pace.last_motion when it was read */
    int fixed_width, fixed_height;      /* of the picture; 0 = as large as the window lets it */
    struct rectangle area;              /* of the window that pictures may take */
    struct rectangle room;              /* of that, one of them */
    struct rectangle picture;           /* where it lies; enlarged, beyond its room */
    const struct texture *left, *right; /* what was composed */
    bool dirty;                         /* the picture is not what is wanted */
    bool awaits;    /* what is wanted waits for shaders, which are compiled in the background */
    bool recompose; /* the frame is, but not what is shown of it */
    bool moving;    /* and this will go on for some frames */
    bool coarse;    /* the picture is smaller than it will be at rest, and its edges are rough */
    struct time_budget budget; /* where wish.budget */
    bool is_new_level;         /* of which no frame has been drawn */
    int frame_count;           /* rendered */
    const char *busy;          /* what takes a while and has been announced; NULL = nothing */
};

/* How the picture is looked at: viewer/picture/look.c. */
struct look {
    double zoom;      /* pixels of the window a pixel; 0 = as large as fits */
    double middle[2]; /* of its room, where in the picture that is, 0 to 1 */
    enum screen_layout layout;
    bool inspects; /* viewer/panel/inspector.c */
};

/* What the mouse holds: viewer/panel/controls.c, viewer/scene/camera_hand.c. */
struct hand {
    struct light_tool light_tool;
    double last_update, last_escape;
    double last_grab, grab_x, grab_y; /* when and where the wheel sought what is under the mouse */
    float fly_speed;                  /* scene radii a second; 0 = the usual one */
    bool drags_picture;               /* the mouse was pressed on it */
    bool drags_split;
};

/* What lies beside and over the picture: viewer/panel/panel.c, viewer/panel/overlay.c. */
struct panel {
    bool is_open, help;
    enum overlay_kind { OVERLAY_LINE, OVERLAY_TABLE, OVERLAY_NONE, OVERLAY_KINDS } overlay;
    char scene_path[512], reference_path[512], session_path[512],
        sky_path[512];                 /* typed, or where they came from */
    char filter[32];                   /* of the settings under Advanced */
    bool was_comparing;                /* when it was drawn last */
    bool saves_picture;                /* its button was pressed */
    bool shows_chart;                  /* it was asked for, and comes into view when it is drawn */
    bool edits_right;                  /* the settings shown are the right picture's */
    char *places;                      /* as they were written last; NULL = not yet */
    int places_asked, places_answered; /* how often */
};

/* The reference that is traced: viewer/reference/tracing.c. */
struct tracing {
    struct reference_tracer tracer;
    struct session view; /* that the reference was traced of; without lights: none was */
    bool of_view;        /* and it is the present one */
    int samples;         /* of the reference, a pixel; 0: none yet */
    double noise;        /* of its indirect layer: standard error, RMS over mean */
    double full_noise;   /* the same light's, over the mean of the whole picture */
    /* Of the left picture's indirect layer, the noise taken off: relative RMSE; and of which frame
     * and how many samples it tells. */
    bool has_error;
    double error;
    int error_frame, error_samples;

    struct chart chart; /* of the same view */
    int chart_samples;  /* of the reference that its errors are against */
};

/* A scene or a sky that is opened: viewer/files/opening.c, viewer/scene/sky.c. */
struct opening {
    struct loader loader;
    double since;                     /* when the scene was asked for */
    struct document arriving;         /* read, and waits for its shaders, where is_arriving */
    struct document leaving;          /* abandoned, but its shaders are still being compiled */
    struct environment *arriving_sky; /* waits for its shaders; NULL = none */
    struct environment *leaving_sky;  /* abandoned, but its shaders are still being compiled */
    struct preview preview;           /* of the scene that arrives */
    bool is_arriving;
    bool is_announced; /* that its renderer is made next */
    bool is_given;     /* the command line says how the first scene is to look */
    struct reloading {
        struct file_stamp asked, shown, seen; /* of the file: viewer/files/opening.c */
        struct scene_open_desc desc;          /* that it was opened by */
        double looked;                        /* when it was last looked at */
        bool on;                              /* what arrives is the same file */
    } reloading;
};

struct viewer {
    struct viewer_desc desc;
    struct host host;
    struct opening opening;
    struct compiling compiling;
    struct document document; /* where has_scene */
    bool has_scene;
    struct wish wish;
    struct placed {
        int camera_number; /* of the scene */
        bool camera_moved; /* by hand: an animation then leaves it alone */
        struct orbit orbit;
        char views[SESSION_VIEWS][PLACING_TEXT_SIZE]; /* that were kept: viewer/scene/placed.c */
        struct emitters emitters;                     /* that shine */
        int chosen_light;                             /* of them, which is moved and turned */
        double time, posed_time;                      /* of the animation, seconds */
    } placed;
    struct shown shown;
    struct look look;
    struct hand hand;
    struct panel panel;
    struct history history;
    struct tracing tracing;
    struct gallery gallery; /* of the empty window, where has_gallery */
    bool has_gallery;
    struct file_dialog dialog;
    struct kept {
        bool on;              /* nobody has said how the scene is to look */
        bool was_restored;    /* it is as it was left */
        bool is_incomplete;   /* but not all of it could be shown */
        struct session fresh; /* as its file has it, where on */
        struct session shown; /* how it began, where it was restored */
    } kept;
    struct exposing {
        float usual;     /* EV: where the scene began */
        bool waits;      /* for its first frame */
        int after_frame; /* shown.frame_count before that */
    } exposing;
    bool done; /* close the window */
};

/* Whether it renders a given number of frames, always at the given size. */
bool viewer_is_scripted(const struct viewer *viewer);

/* Marks the picture as moving: it is rendered at once, and as small as it must be. */
void viewer_touch(struct viewer *viewer);

/* Shows the present error, and prints it. */
void viewer_tell_error(struct viewer *viewer);

#endif
