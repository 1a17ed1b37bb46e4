/* The desktop viewer: a window on a scene, rendered live, and all that its modules share.
 *
 * Each turn of the loop takes what the user did, lets the modules change what is wanted (struct
 * viewer), renders where something changed, and shows it. What fails leaves a message and the last
 * good state. */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include "gl/context/context.h"
#include "inspect/inspect.h"
#include "inspect/probe.h"
#include "inspect/screen.h"
#include "quality/time_budget.h"
#include "renderer/renderer.h"
#include "scene/lights/environment.h"
#include "viewer/compare.h"
#include "viewer/compiling.h"
#include "viewer/file_dialog.h"
#include "viewer/gallery.h"
#include "viewer/history.h"
#include "viewer/light_tool.h"
#include "viewer/loader.h"
#include "viewer/messages.h"
#include "viewer/orbit.h"
#include "viewer/pace.h"
#include "viewer/preview.h"
#include "viewer/recent.h"
#include "viewer/recorder.h"
#include "viewer/session.h"
#include "viewer/tracing.h"
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
    const char *camera, *light;    /* as scene/placing.h has it; NULL = the first, and all */
    const char *clip;              /* as scene/clips.h has it; NULL = the default */
    struct environment_desc environment;
    float time;            /* of the animation, seconds */
    int layer;             /* to show: LAYER_BEAUTY, LAYER_DIRECT, LAYER_INDIRECT */
    const char *reference; /* a picture to compare with; NULL = none */
    const char *glsl;      /* folder of shaders; NULL = embedded */
    int screen;            /* an enum screen_way (gl/screen.h) */
    bool debug;
    int frames; /* render so many and end; 0 = until closed */
    int passes; /* whose mean a picture at rest becomes; 0 = PASSES_AT_REST, but 1, which is none, on software OpenGL, where a
                   pass may take seconds */
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
    struct costs costs;        /* of this machine */
    struct messages messages;
    int message_count; /* that are shown */
    double newest_message;
    double awake_until; /* then nothing is drawn until something happens */
    double last_drawn;
    int width, height; /* of the window then */
    struct screen screen;
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

/* What is shown: viewer/picture.c. */
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

/* How the picture is looked at: viewer/look.c. */
struct look {
    double zoom;      /* pixels of the window a pixel; 0 = as large as fits */
    double middle[2]; /* of its room, where in the picture that is, 0 to 1 */
    enum screen_layout layout;
    bool inspects; /* viewer/inspector.c */
};

/* What the mouse holds: viewer/controls.c, viewer/camera_hand.c. */
struct hand {
    struct light_tool light_tool;
    double last_update, last_escape;
    double last_grab, grab_x, grab_y; /* when and where the wheel sought what is under the mouse */
    float fly_speed;                  /* scene radii a second; 0 = the usual one */
    bool drags_picture;               /* the mouse was pressed on it */
    bool drags_split;
};

/* What lies beside and over the picture: viewer/panel.c, viewer/overlay.c. */
struct panel {
    bool is_open, help;
    enum overlay_kind { OVERLAY_LINE, OVERLAY_TABLE, OVERLAY_NONE, OVERLAY_KINDS } overlay;
    char scene_path[512], reference_path[512], session_path[512],
        sky_path[512];                 /* typed, or where they came from */
    char filter[32];                   /* of the settings under Advanced */
    bool was_comparing;                /* when it was drawn last */
    bool shows_chart;                  /* it was asked for, and comes into view when it is drawn */
    bool edits_right;                  /* the settings shown are the right picture's */
    char *places;                      /* as they were written last; NULL = not yet */
    int places_asked, places_answered; /* how often */
};

/* The empty window, and the way to files: viewer/start.c. */
struct start {
    struct recent recent;
    struct gallery gallery; /* where has_gallery */
    bool has_gallery;
    struct file_dialog dialog;
};

struct viewer {
    struct viewer_desc desc;
    struct host host;
    struct loader loader;
    struct document arriving; /* read, and waits for its shaders, where is_arriving */
    bool is_arriving;
    struct document leaving; /* not wanted any more, but its shaders are still being compiled */
    struct opening {
        double since;      /* when the scene was asked for */
        bool is_announced; /* that its renderer is made next */
        bool is_told;      /* the command line says how it is to look: it means the first scene */
    } opening;
    struct preview preview; /* of what arrives */
    struct compiling compiling;
    struct environment *arriving_sky; /* waits for its shaders; NULL = none */
    struct environment
        *leaving_sky;         /* not wanted any more, but its shaders are still being compiled */
    struct document document; /* where has_scene */
    bool has_scene;
    struct wish wish;
    struct placed {
        int camera_number; /* of the scene */
        bool camera_moved; /* by hand: an animation then leaves it alone */
        struct orbit orbit;
        char views[SESSION_VIEWS][PLACING_TEXT_SIZE]; /* that were kept: viewer/views.c */
        struct emitters emitters;                     /* that shine */
        int chosen_light;                             /* of them, which is moved and turned */
        uint64_t lights_moved;                        /* by hand: a bit of each */
        double time, posed_time;                      /* of the animation, seconds */
    } placed;
    struct shown shown;
    struct look look;
    struct hand hand;
    struct panel panel;
    struct recorder recorder;
    struct record_request record;
    struct history history;
    struct tracing tracing;
    struct start start;
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
    bool window_shown, coarse_shown, picture_shown; /* once */
    int timeline_room;                              /* pixels that the window has grown by for it */
    bool done;                                      /* close the window */
};

/* Runs until the window is closed, or for desc->frames. Error: no window, or where frames are counted a file that fails. */
bool viewer_run(const struct viewer_desc *desc);

/* The same step by step. viewer_begin: error: no window; nothing is left open. */
bool viewer_begin(struct viewer *viewer, const struct viewer_desc *desc);

/* Takes what the user did, renders where something changed, and shows it. Error: as viewer_run. */
bool viewer_turn(struct viewer *viewer);
void viewer_end(struct viewer *viewer);

/* The parts, each of which calls those above it alone; viewer/viewer.c calls them all in turn.
 *
 * --- viewer/state.c: what all parts ask and tell --- */

/* Whether it renders a given number of frames, always at the given size. */
bool viewer_is_scripted(const struct viewer *viewer);

/* Marks the picture as moving: it is rendered at once, and as small as it must be. */
void viewer_touch(struct viewer *viewer);

/* Shows the present error, and prints it. */
void viewer_tell_error(struct viewer *viewer);

/* --- viewer/budget.c --- */

/* What a frame may take, ms: settings then follow from how long frames took; 0: they stay as they are. */
void viewer_set_budget(struct viewer *viewer, float ms);

/* After each frame. */
void viewer_follow_budget(struct viewer *viewer);

/* --- viewer/picture.c --- */

/* The sign that shaders are being compiled. */
extern const char busy_compiling[];

/* The size of the picture at rest. */
void viewer_full_size(const struct viewer *viewer, int *width, int *height);

/* Renders and composes what has changed. Error: the scene cannot be drawn any more. */
bool viewer_update_picture(struct viewer *viewer);

/* Casters are those of time 0, as a picture rendered offscreen has them: poses the scene there before casters are
 * made, and back. viewer_pose_start: whether it was elsewhere, for viewer_pose_back. */
bool viewer_pose_start(struct viewer *viewer);
void viewer_pose_back(struct viewer *viewer, bool away);

/* Shows the picture in the exposure and tone map that are wanted: nothing is rendered for that. */
void viewer_retone(struct viewer *viewer);

/* How many passes a picture at rest is the mean of in the end; whether it is not yet. */
int viewer_passes(const struct viewer *viewer);
bool viewer_is_refining(const struct viewer *viewer);

/* Reads the shaders again, from the folder of --glsl. */
void viewer_reload_shaders(struct viewer *viewer);

/* Shows the next output, or the one before; the picture stands before the first. */
void viewer_step_output(struct viewer *viewer, int step);

/* Reads what lies at a place of the picture, 0 to 1, y down. */
void viewer_pick_surface(struct viewer *viewer, float x, float y);

/* Error: shown, too. */
bool viewer_load_reference(struct viewer *viewer, const char *path);

/* Compares with the reference there is, in its size; or makes the picture as large as the window again: the
 * reference and its chart stay, for viewer_compare_reference. */
void viewer_compare_reference(struct viewer *viewer);
void viewer_fill_window(struct viewer *viewer);

/* Whether the picture has the reference's size; and whether it is of what the reference is of: the view that it was first compared with. */
bool viewer_has_reference_size(const struct viewer *viewer);
bool viewer_reference_fits(const struct viewer *viewer);

/* What is drawn into the window, where has_scene and left. */
struct screen_pictures viewer_pictures(const struct viewer *viewer);

/* --- viewer/animation.c --- */

/* Lets the animation play on, and poses the scene where the time has changed. */
void viewer_animate(struct viewer *viewer, double seconds);

/* To that time of the animation, seconds: around where it loops, else as far as it goes. */
void viewer_go_to(struct viewer *viewer, double time);

/* Where that is in a scene's animation. */
double viewer_time_in(const struct viewer *viewer, const struct scene *scene, double time);

/* Plays or pauses; begins anew where it had come to its end. */
void viewer_toggle_play(struct viewer *viewer);

/* --- viewer/lights.c --- */

/* Whether there is a light: there may be the sky alone. */
bool viewer_has_light(const struct viewer *viewer);

/* The light that is chosen, to be changed: then viewer_touch_light. viewer_reset_light takes the scene's own. */
struct emitter *viewer_light(const struct viewer *viewer);
void viewer_touch_light(struct viewer *viewer);
void viewer_reset_light(struct viewer *viewer);

/* Whether an animation leaves it alone. */
bool viewer_light_is_moved(const struct viewer *viewer, int i);

/* W; of a directional light what crosses the scene's sphere. */
double viewer_light_power(const struct viewer *viewer, const struct emitter *light);
void viewer_set_light_power(struct viewer *viewer, struct emitter *light, double power);

/* Of the chosen light, whose power stays. */
void viewer_retype_light(struct viewer *viewer, enum emitter_type type);

/* The new one is chosen. */
void viewer_add_light(struct viewer *viewer, enum emitter_type type);

/* Removes the chosen light; something must go on shining. */
bool viewer_can_remove_light(const struct viewer *viewer);
void viewer_remove_light(struct viewer *viewer);

/* --- viewer/opening.c, viewer/scenes.c --- */

void viewer_open(struct viewer *viewer, const char *path);

/* Takes a scene that has been loaded, when its shaders are compiled. False: it cannot be shown; the one before stays. */
bool viewer_poll_loader(struct viewer *viewer);

/* Whether one is being read, or has been and is not shown yet, or a sky. */
bool viewer_is_opening(struct viewer *viewer);

/* Lets go what is being opened; what was there before stays. */
void viewer_stop_opening(struct viewer *viewer);

/* What is done of that now, for how long, in words. */
void viewer_tell_opening(struct viewer *viewer, char *text, size_t size);

/* Places the scene's n-th camera, or one by its text. Error: it is not understood. */
void viewer_pick_camera(struct viewer *viewer, int n);
bool viewer_place_camera(struct viewer *viewer, const char *text);

/* Lights by a text. What it moves stays there. Error: it is not understood. */
bool viewer_place_lights(struct viewer *viewer, const char *text);

/* What a renderer of the document begins with, without camera and lights; and one of the scene as it is placed. */
struct renderer_desc viewer_first_desc(const struct viewer *viewer,
                                       const struct document *document);
bool viewer_init_renderer(struct viewer *viewer, struct renderer *renderer);

/* Begins the clips of that text (scene/clips.h). */
void viewer_pick_clips(struct viewer *viewer, const char *text);

/* Lets the scene go, which cannot be drawn any more. */
void viewer_close_scene(struct viewer *viewer);

/* What is looked at and how; the texts are the session's. */
struct session viewer_session(const struct viewer *viewer);
bool viewer_load_session(struct viewer *viewer, const char *path);

/* Shows a session as it was: of the same scene. Error: a camera or a light is not understood. */
bool viewer_show_session(struct viewer *viewer, const struct session *session);

/* --- viewer/sky.c: the environment of the scene that is open --- */

/* Reads a sky, which takes the place of the one before when its shaders have been compiled. Error: shown, too; the
 * one before stays. */
bool viewer_open_sky(struct viewer *viewer, const char *path);

/* Takes the sky whose shaders have come. */
void viewer_follow_sky(struct viewer *viewer);

/* Lets a sky go that waits for its shaders; it is freed when none are being compiled. */
void viewer_forget_sky(struct viewer *viewer);

/* What of a sky the panel's rows tell. */
void viewer_tell_sky(struct viewer *viewer);

/* It was turned, or its strength was changed, in place. */
void viewer_touch_sky(struct viewer *viewer);

/* Whether it shines; and whether anything else does, so that it need not. */
bool viewer_sky_shines(const struct viewer *viewer);
bool viewer_can_do_without_sky(const struct viewer *viewer);
void viewer_let_sky_shine(struct viewer *viewer, bool shines);

/* Whether something is there that shines without it: then it can be removed, and the scene's lights shine where no
 * other does. */
bool viewer_can_remove_sky(const struct viewer *viewer);
void viewer_remove_sky(struct viewer *viewer);

/* The sky of a session, at once, with its lights. Error: of the file, or of the lights. */
bool viewer_show_sky(struct viewer *viewer, const struct session *session);

/* --- viewer/undo.c --- */

/* Notes where the user has come to, once nothing is on its way. */
void viewer_note_step(struct viewer *viewer);

/* One step back (-1) or forth again (1). */
void viewer_undo(struct viewer *viewer, int by);

/* --- viewer/exposure.c --- */

/* For a scene that has been opened: it is exposed by itself where that is wanted, with its first frame. */
void viewer_begin_exposure(struct viewer *viewer);
void viewer_follow_exposure(struct viewer *viewer);

/* It stays as it is, and is the one that the scene began with. */
void viewer_keep_exposure(struct viewer *viewer);

/* Stops up or down; and back to where the scene began. */
void viewer_expose(struct viewer *viewer, float by);
void viewer_reset_exposure(struct viewer *viewer);

/* --- viewer/kept.c --- */

/* Saves settings, camera and lights, and says where; or the error. */
void viewer_save_session(struct viewer *viewer);
void viewer_tell_saved(struct viewer *viewer, bool ok, const char *path);

/* How each scene was left, beside the list of recent files: kept where something was changed, and taken up when
 * the scene is opened again and no option says how it is to look. */
void kept_save(struct viewer *viewer);
void kept_begin(struct viewer *viewer);
void kept_begin_afresh(struct viewer *viewer);
void kept_free(struct viewer *viewer);

/* --- viewer/tracing.c --- */

/* Traces the reference of the view as it is, in place of the one before; viewer_follow_reference takes what
 * has been traced, each turn; viewer_forget_reference ends the comparison with it. */
void viewer_trace(struct viewer *viewer);
void viewer_follow_reference(struct viewer *viewer);
void viewer_forget_reference(struct viewer *viewer);
bool viewer_is_tracing(const struct viewer *viewer);

/* Relative RMSE of an indirect layer against what was traced, without its noise. False: there is none of its size. */
bool viewer_indirect_error(const struct viewer *viewer, const struct image *indirect,
                           double *error);

/* Relative RMSE of the layer that is shown against the right picture, by the same definition: what is known of a
 * traced reference's noise, which is its indirect light's, is taken off. False: it has not been measured. */
bool viewer_compared_error(const struct viewer *viewer, double *error);

/* That noise over the mean of the layer that is shown; 0: none is known. */
double viewer_reference_noise(const struct viewer *viewer);

/* Measures presets and techniques on the view, and traces its reference where there is none;
 * viewer_take_dot makes the picture as one of them. */
void viewer_chart(struct viewer *viewer);
bool viewer_is_charting(const struct viewer *viewer);
void viewer_take_dot(struct viewer *viewer, int i);

/* --- viewer/screenshot.c --- */

/* What is shown, in its own size, with the wipe. */
void viewer_read_shown(const struct viewer *viewer, struct bitmap *shown);

/* What is shown, in its own size, as PNG and the like; the renderer's layers as EXR. */
bool viewer_write_picture(struct viewer *viewer, const char *path);

/* Writes what was traced, with all layers, as EXR under a fresh name in the working folder. */
void viewer_save_reference(struct viewer *viewer);

/* Writes both under a fresh name in the working folder. */
void viewer_take_screenshot(struct viewer *viewer);

/* --- viewer/views.c --- */

/* The first of SESSION_VIEWS that is not taken, or the last. */
int views_free(const struct viewer *viewer);
void views_keep(struct viewer *viewer, int i);
void views_go(struct viewer *viewer, int i);

/* --- viewer/timeline.c --- */

enum { TIMELINE_FPS = 25 }; /* as manylight render --fps has it */

/* Whether the bar is there, below the pictures' area, and how high it is. */
bool viewer_has_timeline(const struct viewer *viewer);
float timeline_height(const struct viewer *viewer);
void timeline_draw(struct viewer *viewer);

/* Pauses, and goes so many frames on. */
void timeline_step(struct viewer *viewer, int frames);

/* --- viewer/look.c, viewer/inspector.c --- */

/* Where the picture lies, where there is one. */
void look_place(struct viewer *viewer);

/* Whether both pictures are there as a whole: the right one lies shown.room.width further right. */
bool look_is_beside(const struct viewer *viewer);

/* The mouse's place in the picture, or in the right one, 0 to 1, y down; whether it is on it. */
bool look_at_mouse(const struct viewer *viewer, float *x, float *y);

enum { LOOK_ZOOM_MOST = 64 };

/* Pixels of the window a pixel; look_enlarge keeps the middle where it is, and fits what would be smaller. */
double look_zoom(const struct viewer *viewer);
void look_enlarge(struct viewer *viewer, double zoom);
void look_scroll(struct viewer *viewer, double steps);
void look_drag(struct viewer *viewer);

/* Between 1:1 and as large as fits. */
void look_toggle(struct viewer *viewer);
void look_step_layout(struct viewer *viewer);
void inspector_draw(struct viewer *viewer);

/* --- viewer/legend.c --- */
/* What it takes below a sheet of VALs; 0 = nothing: on a single one it stands. */
float legend_height(const struct viewer *viewer);
void legend_draw(const struct viewer *viewer);

/* --- viewer/camera_hand.c: the camera follows mouse and keys --- */

enum { CAMERA_FIELD_LEAST = 2, CAMERA_FIELD_MOST = 150 }; /* degrees, vertical */

/* It was moved by hand. */
void camera_hand_touch(struct viewer *viewer);

/* m/s. */
float camera_hand_speed(const struct viewer *viewer);
void camera_hand_fly(struct viewer *viewer, double seconds);
void camera_hand_drag(struct viewer *viewer);
void camera_hand_scroll(struct viewer *viewer);
void camera_hand_frame(struct viewer *viewer);

/* --- viewer/controls.c: keys and mouse --- */
void controls_update(struct viewer *viewer, double seconds);
void controls_draw_help(void);

/* --- viewer/take.c --- */
/* Opens a file that was dropped, typed or chosen: a scene, the sky of the one that is open, a reference, or settings;
 * a picture that may be either is told from how it is made. */
void viewer_take_file(struct viewer *viewer, const char *path);

/* --- viewer/start.c --- */
void start_draw(struct viewer *viewer);
void start_free(struct start *start);

/* Whether a picture has been made, or the desktop's dialog may answer. */
bool start_has_news(struct start *start);

/* Lets the user choose a file. */
void viewer_ask_file(struct viewer *viewer);

/* --- viewer/panel_camera.c, viewer/panel_light.c, viewer/panel_look.c, viewer/panel_scene.c, viewer/panel.c,
 * viewer/overlay.c --- */
void panel_draw_scene(struct viewer *viewer);
void panel_draw_camera(struct viewer *viewer);
void panel_draw_light(struct viewer *viewer);
void panel_draw_look(struct viewer *viewer);
void panel_draw(struct viewer *viewer);
/* Of the window's left edge what the times take, with the edges. */
float overlay_width(const struct viewer *viewer);
void overlay_draw(struct viewer *viewer);

#endif
