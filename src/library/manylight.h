/* libmanylight: the renderer of the program manylight as a C library.
 *
 *     struct manylight_device *device = NULL;
 *     struct manylight_scene *scene = NULL;
 *     struct manylight_renderer *renderer = NULL;
 *     struct manylight_image *image = NULL;
 *     struct manylight_device_desc where = {.size = sizeof where};
 *     struct manylight_scene_desc what = {.size = sizeof what, .path = "a.glb"};
 *     if (manylight_device_create(&where, &device) || manylight_scene_open(&what, &scene) ||
 *         manylight_renderer_create(device, scene, NULL, &renderer) ||
 *         manylight_render(renderer, NULL) || manylight_read(renderer, NULL, &image))
 *         fprintf(stderr, "%s\n", manylight_error());
 *
 * Descriptors. Set the first member of each struct, `size`, to the sizeof of the struct. A zero
 * member selects its default. NULL selects all defaults where a function allows it. MANYLIGHT_ZERO
 * is the number 0 where 0 selects another default. Functions copy the strings and arrays of a
 * descriptor, or use them only during the call.
 *
 * Results. A function that can fail returns a status; 0 is success. On failure it makes no handle,
 * sets *handle to NULL, and manylight_error returns the reason. Bad input never ends the process.
 * Only a failed allocation of the system does; sizes from files and callers are checked first.
 *
 * Ownership. Each ..._free accepts NULL. Free handles in any order: a renderer keeps its device and
 * its scene alive.
 *
 * Threads. Each thread has its own error and its own log.
 *   - Own device: call from any thread. The device has its own thread, where its context is
 *     current; the caller's current context stays. Calls to a device and its renderers run one at a
 *     time. Devices run in parallel.
 *   - Adopted device: call from one thread at a time, on which make_current works.
 *   - Several threads may use a scene or an image at the same time. A scene does not change while
 *     a call uses it: manylight_scene_set_... then fails.
 *   - Callbacks may run on other threads than the caller's, one at a time. They return before the
 *     call does. They may call functions of images and scenes. Calls of the device at work are
 *     MANYLIGHT_BAD_ARGUMENT.
 *   - After a fork: calls of devices and renderers fail with MANYLIGHT_NO_DEVICE in a child whose
 *     parent has used a device. Their ..._free do nothing. Scenes, images and manylight_reference
 *     work.
 *
 * Units. Metres, seconds, radians, +Y up. Radiance is in W/(sr m2), intensity in W/sr. The
 * intensity of an area light is its radiance times its area, in W/sr on its axis. That of a
 * directional light is in W/m2. Text that describes lights uses the same units. Row 0 of a picture
 * is its top.
 *
 * Process. Locale, rounding mode, signal handlers, standard streams and the working folder stay
 * unchanged. */
#ifndef MANYLIGHT_H
#define MANYLIGHT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MANYLIGHT_API __attribute__((visibility("default")))

/* Version of the binary interface, part of the names of the functions that make the first handles.
 * A program compiled with a header of another version does not link. */
#define MANYLIGHT_ABI 0
#define manylight_device_create manylight_device_create_0
#define manylight_scene_open manylight_scene_open_0
#define manylight_image_create manylight_image_create_0
#define manylight_image_read manylight_image_read_0

#define MANYLIGHT_ZERO (-1)

enum manylight_status {
    MANYLIGHT_OK,
    MANYLIGHT_BAD_ARGUMENT, /* invalid descriptor, size or name; a call that is not allowed */
    MANYLIGHT_BAD_SCENE,    /* file, bytes or arrays */
    MANYLIGHT_BAD_SETTING,  /* technique, direct method, quality, setting or its value */
    MANYLIGHT_NO_DEVICE,    /* no such device, software not allowed, no OpenGL 4.5 */
    MANYLIGHT_NO_MEMORY,    /* out of memory, of the CPU or the GPU */
    MANYLIGHT_CANCELLED,    /* a progress callback returned nonzero */
    MANYLIGHT_FAILED,       /* all else: driver, shader, file that cannot be written */
};

struct manylight_device;   /* an OpenGL context, own or adopted */
struct manylight_scene;    /* geometry, materials, lights, cameras; needs no device */
struct manylight_renderer; /* draws a scene on a device */
struct manylight_image;    /* layers of floats */

/* --- errors, log, names ----------------------------------------------------------------------- */

/* Returns the message or status of this thread's last failed call; "" and MANYLIGHT_OK if none
 * failed. The message is valid until the thread's next call. */
MANYLIGHT_API const char *manylight_error(void);
MANYLIGHT_API enum manylight_status manylight_error_status(void);

enum manylight_log_level { MANYLIGHT_DETAIL, MANYLIGHT_NOTE, MANYLIGHT_WARNING };

/* Receives log messages of calls on this thread, without a newline. */
typedef void manylight_log(void *user, enum manylight_log_level level, const char *message);
/* Sets the log of the calling thread. NULL, the default: messages are dropped. */
MANYLIGHT_API void manylight_log_to(manylight_log *log, void *user);

/* Returns "0.1 (commit)", a static string. */
MANYLIGHT_API const char *manylight_version(void);

/* Returns the name with index n, counted from 0, as a static string; NULL after the last. */
MANYLIGHT_API const char *manylight_technique_name(int n);
MANYLIGHT_API const char *manylight_direct_name(int n);
MANYLIGHT_API const char *manylight_quality_name(int n);
MANYLIGHT_API const char *manylight_metric_name(int n);

struct manylight_setting {
    size_t size;
    char name[64], value[64]; /* "gather.interleave" and its default as text */
    const char *help;         /* static string */
};

/* Fills *setting with the setting of index n, counted from 0. The caller sets setting->size. Error:
 * MANYLIGHT_BAD_ARGUMENT after the last. */
MANYLIGHT_API enum manylight_status manylight_setting_at(int n, struct manylight_setting *setting);

/* Receives the progress: done in [0, 1], and a note such as "pass 3 of 64", valid during the call.
 * Returns 0 to go on, other values to cancel. */
typedef int manylight_progress(void *user, double done, const char *note);

/* --- devices ---------------------------------------------------------------------------------- */

/* An OpenGL 4.5 core context for the library alone. Calls of an adopted device change its state and
 * do not restore it; the caller must not change it. Create it so that it shares objects with the
 * context you draw with, for example by the last argument of glfwCreateWindow. Then
 * manylight_display_texture is valid in both. Let release_current make your context current again.
 *
 * Keep the context alive until the device and its renderers are freed; freeing them makes it
 * current. */
struct manylight_host {
    size_t size;
    void *(*get_proc)(void *user, const char *name); /* required; address of a function */
    /* Returns nonzero on failure. NULL: the context is current on the thread at each call. */
    int (*make_current)(void *user);
    void (*release_current)(void *user); /* called after each call; NULL: context stays current */
    void *user;                          /* passed to the functions above */
};

struct manylight_device_desc {
    size_t size;
    /* EGL device by its number "2", by CUDA's number "cuda:2", or "hardware". NULL: the first that
     * works; without allow_software the first hardware device. */
    const char *device;
    /* Nonzero: also accepts OpenGL on the CPU. Adopted contexts may always be software. */
    int allow_software;
    int debug; /* nonzero: debug context; its messages are warnings of the log */
    const struct manylight_host *host; /* NULL: an own context without a window */
};

/* Opens a device. Error: names each attempt and why it failed. */
MANYLIGHT_API enum manylight_status
manylight_device_create(const struct manylight_device_desc *desc, struct manylight_device **device);
MANYLIGHT_API void manylight_device_free(struct manylight_device *device);

struct manylight_device_info {
    size_t size;
    char name[128];                                /* "EGL device 0 (/dev/dri/card0)" */
    char vendor[128], renderer[128], version[128]; /* strings of OpenGL */
    int software;                                  /* nonzero: OpenGL runs on the CPU */
    uint64_t memory; /* GPU memory in bytes; 0: the driver does not report it */
};

/* Fills *info. The caller sets info->size. */
MANYLIGHT_API enum manylight_status manylight_device_info(struct manylight_device *device,
                                                          struct manylight_device_info *info);

/* Writes one line per available device, then the reasons for those that are not available. Text is
 * cut to fit and zero-terminated. */
MANYLIGHT_API void manylight_list_devices(char *text, size_t text_size);

/* --- scenes ----------------------------------------------------------------------------------- */

struct manylight_material {
    size_t size;
    float base_color[4]; /* linear RGBA, 0 to 1; all 0: white; black is 0, 0, 0, 1 */
    float metalness;     /* 0 to 1 */
    float roughness;     /* 0 to 1; 0 selects 1, MANYLIGHT_ZERO selects 0 */
    float emission[3];   /* W/(sr m2) */
    int double_sided;
    /* PNG or JPEG bytes that multiply the base colour, sRGB, repeated; NULL: none. Meshes need
     * uvs. */
    const void *picture;
    size_t picture_bytes;
};

/* Triangles of one material, in world space. A front face has counter-clockwise corners. Back faces
 * are visible only if the material is double-sided. */
struct manylight_mesh {
    size_t size;
    const float *positions; /* vertex_count x 3 */
    const float *normals;   /* vertex_count x 3, unit length; NULL: flat */
    const float *uvs;       /* vertex_count x 2, v down; NULL: none */
    const float *colors;    /* vertex_count x 4, linear RGBA, 0 to 1; NULL: white */
    size_t vertex_count;
    const uint32_t *indices; /* index_count, 3 per triangle; NULL: vertices in order */
    size_t index_count;
    int material; /* index into the scene's materials */
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
    float position[3], direction[3]; /* position in m; direction 0: -Y */
    float up[3];                     /* orients width and height; 0: chosen */
    float intensity[3];              /* W/sr; directional W/m2; area W/sr on its axis */
    /* Size. Area and spot: width and height, m, or diameter of a disk and 0. Point: diameter of its
     * sphere, m, and 0. Directional: angular diameter, radians, and 0. */
    float extent[2];
    /* Half angles of a spot's cone, radians: full intensity inside inner, 0 at outer. Both 0 select
     * 0 and pi/4, so intensity falls from the axis outwards. */
    float inner_angle, outer_angle;
};

/* Equirectangular: longitude along x, latitude along y, forward in the middle. Cube: a picture six
 * times as wide as high, of squares that look right, left, up (its top is back), down (its top is
 * forward), forward and back. Fisheyes: the angle from forward, or the sine of its half, grows as
 * the distance from the picture's middle. */
enum manylight_lens {
    MANYLIGHT_LENS_PINHOLE,
    MANYLIGHT_LENS_EQUIRECTANGULAR,
    MANYLIGHT_LENS_CUBE,
    MANYLIGHT_LENS_EQUIDISTANT,
    MANYLIGHT_LENS_EQUISOLID
};

struct manylight_camera {
    size_t size;
    float eye[3], forward[3], up[3]; /* eye in m; forward 0: -Z; up 0: +Y */
    /* 0: computed from forward and up. Otherwise the three axes are used unchanged. They are
     * orthogonal, forward unit, right and up at least unit; longer ones widen the picture. Cameras
     * of a scene have unit axes. */
    float right[3];
    float fov_y;                 /* vertical, radians, below pi; 0: orthographic by y_extent */
    float y_extent;              /* half height of an orthographic picture, m; both 0: fov_y .8 */
    float near_plane, far_plane; /* m; clip distances; far 0: none */
    /* Shifted lens: place of the picture's middle, from the axis to the right and up, in halves of
     * width and height. Cameras of a scene have none. */
    float shift[2];
    /* For manylight_reference; manylight_render takes plain pinholes. Wide lenses have fov_y for
     * fisheyes alone, along the height, up to 2 pi, and Z and clip distances along the ray. skew is
     * K[0][1] / K[0][0]. distortion is OpenCV's of a pinhole: k1 k2 p1 p2 k3 k4 k5 k6. */
    enum manylight_lens lens;
    float skew, distortion[8];
};

/* Camera's own axes of a pose: x right, y up, z back; or x right, y down, z forward. */
enum manylight_axes { MANYLIGHT_OPENGL, MANYLIGHT_OPENCV };

/* A pinhole by its intrinsics matrix, its pose and its distortion. */
struct manylight_pinhole {
    size_t size;
    int width, height; /* pixels, of the picture that the intrinsics are for */
    double fx, fy;     /* focal lengths, pixels */
    double cx, cy;     /* principal point, pixels from the top left corner; first centre .5, .5 */
    double pose[16];   /* rigid, camera to world, row by row; all 0: identity */
    enum manylight_axes axes;
    double skew;          /* K[0][1], pixels */
    double distortion[8]; /* as in struct manylight_camera */
};

/* Fills *camera for the pinhole. The caller sets camera->size. Pictures of other sizes keep the
 * vertical angle of view. */
MANYLIGHT_API enum manylight_status
manylight_camera_pinhole(const struct manylight_pinhole *pinhole, struct manylight_camera *camera);

/* Writes the unit directions in which a camera sees the centres of a picture's pixels: height x
 * width x 3 floats. */
MANYLIGHT_API enum manylight_status manylight_camera_rays(const struct manylight_camera *camera,
                                                          int width, int height, float *directions);

/* Set exactly one of path, memory and meshes; memory may have a path, too. All elements of an array
 * have the same size member. */
struct manylight_scene_desc {
    size_t size;
    /* A .glb or .gltf file. With memory: file names in the bytes are relative to its folder.
     * Without a path the bytes cannot name files. */
    const char *path;
    const void *memory;
    size_t memory_bytes;
    const struct manylight_mesh *meshes;
    size_t mesh_count;
    const struct manylight_material *materials; /* with meshes; none: white material */
    size_t material_count;
    const struct manylight_light *lights; /* with meshes; none: as for a file without lights */
    size_t light_count;
    const struct manylight_camera *cameras; /* with meshes */
    size_t camera_count;
    /* Options of `manylight render`: --light, --clip, --environment, --environment-turn
     * (degrees), --environment-strength (0 selects 1), --strict and --root. */
    const char *light, *clip;
    const char *environment;
    float environment_turn, environment_strength;
    int strict;
    const char *root;
    const char *scene, *variant; /* as --scene and --variant */
    float punctual_scale;        /* as --punctual-scale; 0 selects 1 */
};

/* Opens a scene from a file, bytes or arrays. Error: names file, object and reason. */
MANYLIGHT_API enum manylight_status manylight_scene_open(const struct manylight_scene_desc *desc,
                                                         struct manylight_scene **scene);
MANYLIGHT_API void manylight_scene_free(struct manylight_scene *scene);

struct manylight_scene_info {
    size_t size;
    /* Counts include a light or camera added by the descriptor. */
    int triangle_count, material_count, light_count, camera_count;
    float center[3], radius; /* bounding sphere of all triangles at time 0, m */
    double duration;         /* length of the animation, s */
    double origin[3]; /* positions are relative to it, m; not 0 for scenes far from the origin */
};

/* Fills *info. The caller sets info->size. */
MANYLIGHT_API enum manylight_status manylight_scene_info(const struct manylight_scene *scene,
                                                         struct manylight_scene_info *info);

enum manylight_part { MANYLIGHT_NODE, MANYLIGHT_MESH, MANYLIGHT_MATERIAL };

/* Returns the name of a part by its id in the layers id.node, id.mesh and id.material, from 1 on.
 * "" where the file has none. NULL: no such part. The text lives until the scene changes. */
MANYLIGHT_API const char *manylight_scene_name(const struct manylight_scene *scene,
                                               enum manylight_part part, uint32_t id);

/* Returns the bits of a name's id in Cryptomatte; NULL: 0. */
MANYLIGHT_API uint32_t manylight_matte_id(const char *name);

/* Change a part of a scene without clips, by its id; manylight_view.light changes lights. Renderers
 * and references show the change from the next frame on, with the bits of a scene opened with it.
 * Renderers follow lights, other triangles, base colours, and the turn and strength of the sky.
 * They start anew after other changes. They also start anew if triangles differ in a scene with
 * panes, caustics, metaballs or more than 2^20 triangles. Files' alpha modes, extensions and
 * pictures stay. Error: MANYLIGHT_BAD_ARGUMENT while another call uses the scene; no such part; a
 * part that these structs cannot describe. The scene then stays unchanged. */

/* matrix: affine, from the node to its parent, row by row. */
MANYLIGHT_API enum manylight_status manylight_scene_set_node(struct manylight_scene *scene,
                                                             uint32_t id, const double matrix[16]);
/* Replaces vertices and triangles, of any number. Keeps the material: mesh->material is it or 0. */
MANYLIGHT_API enum manylight_status manylight_scene_set_mesh(struct manylight_scene *scene,
                                                             uint32_t id,
                                                             const struct manylight_mesh *mesh);
/* Keeps the pictures: material->picture is NULL. */
MANYLIGHT_API enum manylight_status
manylight_scene_set_material(struct manylight_scene *scene, uint32_t id,
                             const struct manylight_material *material);
/* path: a file or a text of --environment; NULL: the same sky. turn (degrees) and strength (0
 * selects 1) are relative to it. */
MANYLIGHT_API enum manylight_status manylight_scene_set_sky(struct manylight_scene *scene,
                                                            const char *path, float turn,
                                                            float strength);

/* Fills *camera with a camera of the scene at a time in seconds; text as in struct manylight_view.
 * The caller sets camera->size. */
MANYLIGHT_API enum manylight_status manylight_scene_camera(const struct manylight_scene *scene,
                                                           const char *text, double time,
                                                           struct manylight_camera *camera);

/* --- rendering -------------------------------------------------------------------------------- */

struct manylight_renderer_desc {
    size_t size;
    int width, height;     /* pixels, up to 16384; both 0: the camera's, longer side 800 */
    const char *technique; /* NULL: clustered */
    const char *direct;    /* NULL: hard; pcss if a light has a size */
    const char *quality;   /* "draft", "normal", "high", "final"; NULL: normal */
    /* Settings separated by spaces or commas, "gather.interleave=8 vpls=1024"; NULL: none. */
    const char *settings;
    int passes; /* passes averaged into a picture; 0: by quality (final 64, else 1) */
    int first_pass;
    int hide_environment; /* nonzero: environment lights surfaces but is not visible */
    /* Nonzero: faster if only the camera changes between frames. The picture is the same. */
    int keep_lights;
    int timed; /* nonzero: manylight_milliseconds works */
    /* Camera that gives the default size, as text like that of struct manylight_view. */
    const char *camera;
};

/* Makes a renderer of the scene on the device. desc may be NULL. Error: names setting or shader. */
MANYLIGHT_API enum manylight_status
manylight_renderer_create(struct manylight_device *device, struct manylight_scene *scene,
                          const struct manylight_renderer_desc *desc,
                          struct manylight_renderer **renderer);
MANYLIGHT_API void manylight_renderer_free(struct manylight_renderer *renderer);

/* Replaces the renderer's descriptor, zero members included, and drops the last frame. On failure
 * the renderer is unchanged. */
MANYLIGHT_API enum manylight_status
manylight_renderer_change(struct manylight_renderer *renderer,
                          const struct manylight_renderer_desc *desc);

/* Writes the value of the named setting as text, cut to fit, zero-terminated. */
MANYLIGHT_API enum manylight_status manylight_renderer_setting(struct manylight_renderer *renderer,
                                                               const char *name, char *text,
                                                               size_t text_size);

struct manylight_view {
    size_t size;
    /* As --camera of `manylight render`: "Camera.001", "1", "0 eye=0,1,3 forward=0,0,-1". NULL: the
     * first. */
    const char *camera;
    const struct manylight_camera *placed; /* replaces camera */
    const char *light;                     /* as --light of render; NULL: the scene's */
    double time;                           /* of the animation, s */
    /* Called after each pass if there are several. Own devices also call it a few times a second
     * within a pass, so a long pass can be cancelled. NULL: none. */
    manylight_progress *progress;
    void *user;
    /* For layers of motion: time from frame to frame, s, 0 selects 1/25; and where a placed camera
     * is in the next and the previous frame, NULL: the same. */
    double step;
    const struct manylight_camera *placed_next, *placed_previous;
};

/* Draws a frame, or the mean of its passes. view may be NULL. Equal views give equal bits, whatever
 * was drawn before. A failure leaves no frame. */
MANYLIGHT_API enum manylight_status manylight_render(struct manylight_renderer *renderer,
                                                     const struct manylight_view *view);

/* Copies all layers of the last frame: R G B A, Z, direct, indirect, albedo, normal, and those of
 * specular surfaces, media and caustics. outputs adds layers as --aov does, "id.node,uv"; NULL:
 * none. If it names layers of every frame, "beauty,id.node", the image has these, Z and no others
 * of every frame, which takes less time. Outputs of the technique, "val,visibility", are for single
 * passes, not means.
 *
 * Layers of surfaces show pixel centres, without mixing; crypto.node, crypto.mesh, crypto.material
 * are Cryptomatte of the samples of antialiasing, in channels crypto_node00.r and so on. They are 0
 * where nothing is seen:
 *   id.node, id.mesh, id.material   from 1 on, for manylight_scene_name
 *   position                        metres, as of the camera
 *   depth                           along the ray, metres
 *   uv                              texture coordinates
 *   motion.next, motion.previous    pixels to the surface's place a step later or earlier, y down
 */
MANYLIGHT_API enum manylight_status manylight_read(struct manylight_renderer *renderer,
                                                   const char *outputs,
                                                   struct manylight_image **image);

/* Copies the picture in display sRGB: height x width x 4 bytes, row 0 at the top. layer: "beauty",
 * "direct" or "indirect"; NULL: beauty. bytes: size of rgba. */
MANYLIGHT_API enum manylight_status manylight_read_display(struct manylight_renderer *renderer,
                                                           const char *layer, uint8_t *rgba,
                                                           size_t bytes);

/* Returns the OpenGL name of an RGBA8 2D texture with the same picture, sRGB-encoded, row 0 at the
 * bottom. Waits until the GPU has drawn it. Contexts that share objects may use it after they bind
 * it again. Adopted devices only. The renderer owns it, and its name may change with each call. */
MANYLIGHT_API enum manylight_status manylight_display_texture(struct manylight_renderer *renderer,
                                                              const char *layer, uint32_t *texture,
                                                              int *width, int *height);

/* Returns the time of a timer in the last frame, such as "frame/gather"; "frame" is the whole
 * frame. 0: no such timer. Needs `timed`. */
MANYLIGHT_API enum manylight_status manylight_milliseconds(struct manylight_renderer *renderer,
                                                           const char *path, double *milliseconds);

/* --- reference -------------------------------------------------------------------------------- */

/* Options of `manylight reference`. Set samples or noise, not both. */
struct manylight_reference_desc {
    size_t size;
    int width, height; /* as in struct manylight_renderer_desc */
    const struct manylight_view *view;
    int bounces; /* indirect bounces; 0 selects 1, MANYLIGHT_ZERO direct light only */
    int samples; /* per pixel; 0: until noise is reached */
    float noise; /* limit of the relative standard error; 0 selects .01 */
    int paths;   /* indirect paths per sample; 0: 1 below 16 samples per pixel, else 4 */
    uint32_t seed;
    int light_paths; /* light paths that trace caustics; 0: none; more set smooth */
    int smooth;      /* nonzero: glass and mirrors show the scene */
    int centers;     /* nonzero: samples only at pixel centres, without antialiasing */
    int seen;        /* nonzero: adds the layers unshadowed and visibility of the lights */
    int denoise;     /* nonzero: filters the noise of indirect light */
    int hide_environment;
    float ao_distance;     /* m; adds the layer ao, ambient occlusion; 0: none */
    const char *materials; /* "full" or "diffuse"; NULL: full */
    const char *settings;  /* settings of the medium only */
    int threads;           /* 0: all cores; the picture does not depend on it */
    const char *outputs;   /* layers of surfaces, as of manylight_read; NULL: none */
};

/* Path-traces on the CPU and calls the view's progress. desc may be NULL. */
MANYLIGHT_API enum manylight_status manylight_reference(const struct manylight_scene *scene,
                                                        const struct manylight_reference_desc *desc,
                                                        struct manylight_image **image);

/* --- images and metrics ----------------------------------------------------------------------- */

/* Makes an image. channels: names separated by one space, "R G B". pixels: height x width x
 * channels floats, copied. */
MANYLIGHT_API enum manylight_status manylight_image_create(int width, int height,
                                                           const char *channels,
                                                           const float *pixels,
                                                           struct manylight_image **image);

/* Reads EXR, PFM, PNG and other formats. sRGB-encoded values stay encoded; only metrics decode
 * them. */
MANYLIGHT_API enum manylight_status manylight_image_read(const char *path,
                                                         struct manylight_image **image);

/* Writes all layers as EXR, or R G B as PFM or HDR. An EXR of a renderer or a reference has the
 * program's attributes. */
MANYLIGHT_API enum manylight_status manylight_image_write(const struct manylight_image *image,
                                                          const char *path);
MANYLIGHT_API void manylight_image_free(struct manylight_image *image);

MANYLIGHT_API int manylight_image_width(const struct manylight_image *image);
MANYLIGHT_API int manylight_image_height(const struct manylight_image *image);
MANYLIGHT_API int manylight_image_channel_count(const struct manylight_image *image);

/* Returns the name of channel n, "indirect.R", valid while the image lives; NULL: no such
 * channel. */
MANYLIGHT_API const char *manylight_image_channel(const struct manylight_image *image, int n);

/* Returns height x width x channels floats, row 0 at the top, valid while the image lives. */
MANYLIGHT_API const float *manylight_image_pixels(const struct manylight_image *image);

/* Copies a layer as height x width x channels floats. "beauty" or NULL is R G B A or R G B,
 * "indirect" is indirect.R .G .B, "Z" has one channel. *channels receives the number of channels.
 * pixels NULL: only this number. count: size of pixels in floats. */
MANYLIGHT_API enum manylight_status manylight_image_layer(const struct manylight_image *image,
                                                          const char *layer, float *pixels,
                                                          size_t count, int *channels);

struct manylight_compare_desc {
    size_t size;
    const char *layer, *reference_layer; /* NULL: beauty; reference_layer NULL: layer */
    const char *metric;                  /* NULL: relative-rmse */
    float pixels_per_degree;             /* for FLIP; 0 selects 67.0206 */
    int threads;                         /* 0: all cores; the result does not depend on it */
};

/* Computes the error of test against reference as `manylight compare` does. Both have one size.
 * desc may be NULL. map, unless NULL, receives the error of each pixel, height x width. */
MANYLIGHT_API enum manylight_status manylight_compare(const struct manylight_image *test,
                                                      const struct manylight_image *reference,
                                                      const struct manylight_compare_desc *desc,
                                                      double *value, float *map);

#ifdef __cplusplus
}
#endif

#endif
