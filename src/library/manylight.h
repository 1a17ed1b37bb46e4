/* libmanylight: the renderer of the program manylight as a C library.
 *
 *     struct manylight_device *device = NULL;
 *     struct manylight_scene *scene = NULL;
 *     struct manylight_renderer *renderer = NULL;
 *     struct manylight_image *image = NULL;
 *     if (manylight_device_create(&(struct manylight_device_desc){sizeof(struct manylight_device_desc)}, &device) ||
 *         manylight_scene_open(&(struct manylight_scene_desc){sizeof(struct manylight_scene_desc), .path = "a.glb"},
 *                              &scene) ||
 *         manylight_renderer_create(device, scene, NULL, &renderer) ||
 *         manylight_render(renderer, NULL) || manylight_read(renderer, NULL, &image))
 *         fprintf(stderr, "%s\n", manylight_error());
 *
 * Descriptors. A struct ..._desc begins with its size in bytes, and all-zero members select defaults. A descriptor
 * that may be NULL stands for all defaults. MANYLIGHT_ZERO is the number 0 where 0 selects a default that is not 0.
 * Texts and arrays of a descriptor are copied, or used during the call alone.
 *
 * Results. Each function that can fail returns a status; 0 is success. On failure no handle is made, *handle is NULL,
 * and manylight_error tells the reason in the words of the program. No call ends the process on bad input. It ends
 * the process only if an allocation of the system fails; sizes that files and callers ask for are checked before.
 *
 * Ownership. Each ..._free accepts NULL. Handles may be freed in any order: a renderer keeps its device and its scene.
 *
 * Threads. Errors and the log are of the calling thread.
 *   - Own device: any thread may call. It works on a thread of its own, where its context is current, so the caller's
 *     current context stays. Calls to one device and its renderers wait for each other; devices work side by side.
 *   - Adopted device: one thread at a time, one on which make_current works.
 *   - Scenes and images do not change: any threads may use one at the same time.
 *   - Callbacks may come on other threads than the caller's, one at a time. They return before the call does. They
 *     may call functions of images and scenes, but none of the device that is at work (MANYLIGHT_BAD_ARGUMENT).
 *   - In a child process that was forked after its parent had used a device, each call of devices and renderers is
 *     MANYLIGHT_NO_DEVICE, and their ..._free do nothing. Scenes, images and manylight_reference work in it.
 *
 * Units. Metres, +Y up, seconds; radiance W/(sr m2), angles in radians. Intensity is W/sr, of area lights W/sr on the
 * axis: radiance times area. That of directional lights is W/m2. Texts of lights have the same units. Row 0 of a
 * picture is its top.
 *
 * The process. Locale, rounding mode, signal handlers, standard streams and the current folder stay as they are.
 */
#ifndef MANYLIGHT_H
#define MANYLIGHT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MANYLIGHT_API __attribute__((visibility("default")))

/* The version of the binary interface. A program that was compiled with the header of another one does not link: the
 * functions that make the first handles have the number in their names. */
#define MANYLIGHT_ABI 0
#define manylight_device_create manylight_device_create_0
#define manylight_scene_open manylight_scene_open_0
#define manylight_image_create manylight_image_create_0
#define manylight_image_read manylight_image_read_0

#define MANYLIGHT_ZERO (-1)

enum manylight_status {
    MANYLIGHT_OK,
    MANYLIGHT_BAD_ARGUMENT, /* a descriptor, a size, a name, or a call that is not allowed here */
    MANYLIGHT_BAD_SCENE,    /* a file, bytes or arrays */
    MANYLIGHT_BAD_SETTING,  /* technique, direct method, quality, setting or its value */
    MANYLIGHT_NO_DEVICE, /* no such device, software that was not asked for, a driver without OpenGL 4.5 */
    MANYLIGHT_NO_MEMORY, /* more memory than there is */
    MANYLIGHT_CANCELLED, /* by a progress callback */
    MANYLIGHT_FAILED,    /* all else: driver, shader, file that cannot be written */
};

struct manylight_device;   /* where OpenGL runs */
struct manylight_scene;    /* what there is to see; needs no device */
struct manylight_renderer; /* draws a scene on a device */
struct manylight_image;    /* layers of floats */

/* --- errors, log, names ----------------------------------------------------------------------- */

/* Of the calling thread's last call that failed; "" before. Valid until its next call. */
MANYLIGHT_API const char *manylight_error(void);
MANYLIGHT_API enum manylight_status manylight_error_status(void);

enum manylight_log_level { MANYLIGHT_DETAIL, MANYLIGHT_NOTE, MANYLIGHT_WARNING };

/* Gets what the calling thread's calls tell, without a line feed. NULL, as at first: nothing is told. */
typedef void manylight_log(void *user, enum manylight_log_level level, const char *message);
MANYLIGHT_API void manylight_log_to(manylight_log *log, void *user);

/* "0.1 (commit)", static. */
MANYLIGHT_API const char *manylight_version(void);

/* The n-th name, static; NULL after the last. */
MANYLIGHT_API const char *manylight_technique_name(int n);
MANYLIGHT_API const char *manylight_direct_name(int n);
MANYLIGHT_API const char *manylight_quality_name(int n);
MANYLIGHT_API const char *manylight_metric_name(int n);

struct manylight_setting {
    size_t size;
    char name[64], value[64]; /* "gather.interleave" and its default, as text */
    const char *help;         /* static */
};

/* The n-th setting of all; MANYLIGHT_BAD_ARGUMENT after the last. */
MANYLIGHT_API enum manylight_status manylight_setting_at(int n, struct manylight_setting *setting);

/* How far work is, done in [0, 1] and a note such as "pass 3 of 64", valid during the call. Not 0: cancel. */
typedef int manylight_progress(void *user, double done, const char *note);

/* --- devices ---------------------------------------------------------------------------------- */

/* The caller's own OpenGL context, which all calls of the device use, 4.5 core. user is of the struct.
 *
 * State on return. Framebuffer, program, vertex array, buffer, texture, sampler and image bindings, viewports, tests,
 * blending, masks, rasterisation, pixel storage and clip control are those of before the call. Errors of glGetError are
 * gone. During a call no query, conditional rendering or transform feedback of the caller may be active.
 *
 * The context must live until the device and its renderers are freed; freeing them makes it current. */
struct manylight_host {
    size_t size;
    void *(*get_proc)(void *user, const char *name); /* required */
    int (*make_current)(
        void *user); /* not 0: failed. NULL: it is current on the thread at each call */
    void (*release_current)(void *user); /* after each call; NULL: it stays current */
    void *user;
};

struct manylight_device_desc {
    size_t size;
    /* EGL device by number "2", by CUDA's number "cuda:2", or "hardware". NULL: the first that works. */
    const char *device;
    int allow_software; /* not 0: takes OpenGL on the CPU too. An adopted context may always be software */
    int debug;          /* not 0: a debug context, whose messages are warnings of the log */
    const struct manylight_host *host; /* NULL: a context of its own, without a window */
};

/* Error: what was tried and why each attempt failed. */
MANYLIGHT_API enum manylight_status
manylight_device_create(const struct manylight_device_desc *desc, struct manylight_device **device);
MANYLIGHT_API void manylight_device_free(struct manylight_device *device);

struct manylight_device_info {
    size_t size;
    char name[128];                                /* "EGL device 0 (/dev/dri/card0)" */
    char vendor[128], renderer[128], version[128]; /* of OpenGL */
    int software;
    uint64_t memory; /* bytes of the GPU; 0: the driver does not tell */
};

/* info->size is set by the caller. */
MANYLIGHT_API enum manylight_status manylight_device_info(struct manylight_device *device,
                                                          struct manylight_device_info *info);

/* All ways to a context, a line each, then why others are not there. Cut to fit, zero-terminated. */
MANYLIGHT_API void manylight_list_devices(char *text, size_t text_size);

/* --- scenes ----------------------------------------------------------------------------------- */

struct manylight_material {
    size_t size;
    float base_color[4]; /* linear RGBA, 0 to 1; all 0: white. Black is 0, 0, 0, 1 */
    float metalness;     /* 0 to 1 */
    float roughness;     /* 0 to 1; 0 selects 1, MANYLIGHT_ZERO is 0 */
    float emission[3];   /* W/(sr m2) */
    int double_sided;
    /* An encoded PNG or JPEG picture of the base colour, sRGB, repeated; NULL: none. Meshes need uvs for it. */
    const void *picture;
    size_t picture_bytes;
};

/* Triangles of one material, in the world. A face is seen from where its corners go counter-clockwise, unless its
 * material is double-sided. */
struct manylight_mesh {
    size_t size;
    const float *positions; /* vertex_count x 3 */
    const float *normals;   /* vertex_count x 3, unit, none of length 0; NULL: flat */
    const float *uvs;       /* vertex_count x 2, v down; NULL: none */
    const float *colors;    /* vertex_count x 4, linear RGBA, 0 to 1; NULL: white */
    size_t vertex_count;
    const uint32_t *indices; /* index_count, 3 a triangle; NULL: vertices in their order */
    size_t index_count;
    int material; /* index of scene's materials */
};

enum manylight_light_type {
    MANYLIGHT_SPOT,
    MANYLIGHT_POINT,
    MANYLIGHT_DIRECTIONAL,
    MANYLIGHT_AREA
};

struct manylight_light {
    size_t size;
    enum manylight_light_type type;
    float position[3], direction[3]; /* direction 0: down */
    float up[3];                     /* of lights with a width and a height; 0: chosen */
    float intensity[3]; /* W/sr; of a directional light W/m2, of an area light W/sr on its axis */
    /* Of an area light and a spot width and height, m, or the diameter of a disk and 0; of a point the diameter of its
     * sphere, m; of a directional light its angle. */
    float extent[2];
    /* Of a spot: half angles of the cone. Inside inner the light is full, at outer it is 0. Both 0: inner 0, so that it
     * fades from the middle on, and outer pi/4. */
    float inner_angle, outer_angle;
};

struct manylight_camera {
    size_t size;
    float eye[3], forward[3], up[3]; /* forward 0: -Z; up 0: +Y */
    /* 0: made of forward and up. Else all three are taken as they are: at right angles, forward unit, right and up unit
     * or longer, which widens the picture. A scene's cameras have unit axes. */
    float right[3];
    float fov_y;    /* vertical, below pi; 0: orthographic by y_extent */
    float y_extent; /* half the height of an orthographic picture; both 0: a fov_y of .8 */
    float near_plane, far_plane; /* m; what is nearer or farther is not seen; far 0: no end */
};

/* Exactly one of path, memory and meshes; memory may have a path besides. Elements of an array begin with their size,
 * all the same. */
struct manylight_scene_desc {
    size_t size;
    const char *
        path; /* .glb or .gltf. With memory: whose folder its names are of; NULL: it can name no files */
    const void *memory;
    size_t memory_bytes;
    const struct manylight_mesh *meshes;
    size_t mesh_count;
    const struct manylight_material *materials; /* with meshes; none: white */
    size_t material_count;
    const struct manylight_light *lights; /* with meshes; none: as of a file without lights */
    size_t light_count;
    const struct manylight_camera *cameras;
    size_t camera_count;
    /* As render's --light, --clip, --environment, --environment-turn (degrees), --environment-strength, --strict, --root. */
    const char *light, *clip;
    const char *environment;
    float environment_turn, environment_strength;
    int strict;
    const char *root;
    const char *scene, *variant; /* as render's --scene and --variant */
    float punctual_scale;        /* as render's --punctual-scale; 0 = 1 */
};

/* Error: names file, object and reason. */
MANYLIGHT_API enum manylight_status manylight_scene_open(const struct manylight_scene_desc *desc,
                                                         struct manylight_scene **scene);
MANYLIGHT_API void manylight_scene_free(struct manylight_scene *scene);

struct manylight_scene_info {
    size_t size;
    int triangle_count, material_count, light_count,
        camera_count;        /* with a light or camera that it was given */
    float center[3], radius; /* of all triangles at time 0, m */
    double duration;         /* of its animation, s */
    double origin[3];        /* of a scene far out: what positions are relative to, m */
};

/* info->size is set by the caller. */
MANYLIGHT_API enum manylight_status manylight_scene_info(const struct manylight_scene *scene,
                                                         struct manylight_scene_info *info);

/* Places a camera: text as of struct manylight_view. camera->size is set by the caller. */
MANYLIGHT_API enum manylight_status manylight_scene_camera(const struct manylight_scene *scene,
                                                           const char *text, double time,
                                                           struct manylight_camera *camera);

/* --- rendering -------------------------------------------------------------------------------- */

struct manylight_renderer_desc {
    size_t size;
    int width, height; /* pixels, up to 16384; 0: those of the camera, 800 along the longer side */
    const char *technique; /* NULL: clustered */
    const char *direct;    /* NULL: hard, or pcss if a light has a size */
    const char *quality;   /* "draft", "normal", "high", "final"; NULL: normal */
    const char
        *settings; /* "gather.interleave=8 vpls=1024", spaces or commas between; NULL: none */
    int passes;    /* of which a picture is the mean; 0: by quality, 64 for final, else 1 */
    int first_pass;
    int hide_environment; /* not 0: it lights surfaces, but is not seen behind them */
    int keep_lights; /* not 0: faster if the camera alone changes from frame to frame; same picture */
    int timed;       /* not 0: for manylight_milliseconds */
    const char *camera; /* whose size is the default size, as of struct manylight_view */
};

/* desc may be NULL. */
MANYLIGHT_API enum manylight_status
manylight_renderer_create(struct manylight_device *device, struct manylight_scene *scene,
                          const struct manylight_renderer_desc *desc,
                          struct manylight_renderer **renderer);
MANYLIGHT_API void manylight_renderer_free(struct manylight_renderer *renderer);

/* Changes all that desc tells; on failure the renderer is what it was. */
MANYLIGHT_API enum manylight_status
manylight_renderer_change(struct manylight_renderer *renderer,
                          const struct manylight_renderer_desc *desc);

/* The value of a setting as text, cut to fit, zero-terminated. */
MANYLIGHT_API enum manylight_status manylight_renderer_setting(struct manylight_renderer *renderer,
                                                               const char *name, char *text,
                                                               size_t text_size);

struct manylight_view {
    size_t size;
    /* As render's --camera, "Camera.001", "1", "0 eye=0,1,3 forward=0,0,-1"; NULL: the first. */
    const char *camera;
    const struct manylight_camera *placed; /* in place of camera */
    const char *light;                     /* as render's --light; NULL: as of the scene */
    double time;                           /* of the animation, s */
    /* After each of several passes. With a device of its own also a few times a second within a pass, so that a long one
     * can be cancelled. NULL: none. */
    manylight_progress *progress;
    void *user;
};

/* Draws a frame, or the mean of its passes. view may be NULL. The same view gives the same bits, whatever came before.
 * After a failure there is no frame. */
MANYLIGHT_API enum manylight_status manylight_render(struct manylight_renderer *renderer,
                                                     const struct manylight_view *view);

/* All layers of the last frame: R G B A, Z, direct, indirect, albedo, normal, further ones of specular surfaces,
 * media and caustics. outputs: more of them, of the technique, as render's --aov, "val,visibility"; NULL: none. */
MANYLIGHT_API enum manylight_status manylight_read(struct manylight_renderer *renderer,
                                                   const char *outputs,
                                                   struct manylight_image **image);

/* The picture as a display shows it, sRGB: height x width x 4 bytes, row 0 at the top. layer: "beauty", "direct",
 * "indirect"; NULL: beauty. */
MANYLIGHT_API enum manylight_status manylight_read_display(struct manylight_renderer *renderer,
                                                           const char *layer, uint8_t *rgba,
                                                           size_t bytes);

/* The OpenGL name of a 2D texture, RGBA8 in sRGB code, that shows the same with row 0 at the bottom, for the host of an
 * adopted context. It is the renderer's; its name may change with each call. */
MANYLIGHT_API enum manylight_status manylight_display_texture(struct manylight_renderer *renderer,
                                                              const char *layer, uint32_t *texture,
                                                              int *width, int *height);

/* Of the last frame, by a path such as "frame/gather"; "frame" is all. 0: there is no such timer. */
MANYLIGHT_API enum manylight_status manylight_milliseconds(struct manylight_renderer *renderer,
                                                           const char *path, double *milliseconds);

/* --- reference -------------------------------------------------------------------------------- */

/* As the options of manylight reference. */
struct manylight_reference_desc {
    size_t size;
    int width, height; /* as of a renderer */
    const struct manylight_view *view;
    int bounces; /* of indirect light; 0 selects 1, MANYLIGHT_ZERO is 0: direct light alone */
    int samples; /* per pixel; 0: by noise */
    float noise; /* limit of the relative standard error; 0: .01 */
    int paths;   /* of indirect light per sample; 0: 1 below 16 samples per pixel, else 4 */
    uint32_t seed;
    int light_paths; /* which trace caustics; 0: none. Sets smooth */
    int smooth;      /* not 0: glass and mirrors show the scene */
    int centers;     /* not 0: samples at the centres of pixels alone, without antialiasing */
    int seen;        /* not 0: layers unshadowed and visibility, of the lights */
    int denoise;     /* not 0: filters the noise of indirect light */
    int hide_environment;
    float ao_distance;     /* m, layer ao; 0: none */
    const char *materials; /* "full" or "diffuse"; NULL: full */
    const char *settings;  /* of the medium */
    int threads;           /* 0: all cores; does not change the picture */
};

/* Path-traces on the CPU, with the view's progress. desc may be NULL. */
MANYLIGHT_API enum manylight_status manylight_reference(const struct manylight_scene *scene,
                                                        const struct manylight_reference_desc *desc,
                                                        struct manylight_image **image);

/* --- images and metrics ----------------------------------------------------------------------- */

/* channels: names with spaces between, "R G B"; pixels: height x width x channels, copied. */
MANYLIGHT_API enum manylight_status manylight_image_create(int width, int height,
                                                           const char *channels,
                                                           const float *pixels,
                                                           struct manylight_image **image);

/* Reads EXR, PFM, PNG ...; values that the file stores as sRGB are decoded for metrics alone. */
MANYLIGHT_API enum manylight_status manylight_image_read(const char *path,
                                                         struct manylight_image **image);

/* Writes all layers (EXR), or R G B (PFM, HDR). An EXR of a renderer or a reference has the attributes of the program. */
MANYLIGHT_API enum manylight_status manylight_image_write(const struct manylight_image *image,
                                                          const char *path);
MANYLIGHT_API void manylight_image_free(struct manylight_image *image);

MANYLIGHT_API int manylight_image_width(const struct manylight_image *image);
MANYLIGHT_API int manylight_image_height(const struct manylight_image *image);
MANYLIGHT_API int manylight_image_channel_count(const struct manylight_image *image);

/* The n-th channel's name, "indirect.R", as long as the image; NULL: none such. */
MANYLIGHT_API const char *manylight_image_channel(const struct manylight_image *image, int n);

/* height x width x channels, as long as the image. */
MANYLIGHT_API const float *manylight_image_pixels(const struct manylight_image *image);

/* Copies the channels of a layer, side by side, as height x width x channels floats: "beauty" or NULL is R G B A or
 * R G B, "indirect" is indirect.R .G .B, "Z" one channel. *channels gets their number. pixels NULL: only that. count:
 * the room of pixels, floats. */
MANYLIGHT_API enum manylight_status manylight_image_layer(const struct manylight_image *image,
                                                          const char *layer, float *pixels,
                                                          size_t count, int *channels);

struct manylight_compare_desc {
    size_t size;
    const char *layer, *reference_layer; /* NULL: beauty, and the same */
    const char *metric;                  /* NULL: relative-rmse */
    float pixels_per_degree;             /* of FLIP; 0: 67.0206 */
    int threads;                         /* 0: all cores; does not change the result */
};

/* The error of test against reference, as manylight compare has it. desc may be NULL. map, unless NULL, gets the error
 * of each pixel, height x width. */
MANYLIGHT_API enum manylight_status manylight_compare(const struct manylight_image *test,
                                                      const struct manylight_image *reference,
                                                      const struct manylight_compare_desc *desc,
                                                      double *value, float *map);

#ifdef __cplusplus
}
#endif

#endif
