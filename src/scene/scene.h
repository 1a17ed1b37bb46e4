/* A scene: the contents of a glTF file on the CPU: node tree, meshes, materials, lights and
 * cameras.
 *
 * A scene only describes. scene/mesh/geometry.h makes world-space triangles at one time;
 * scene/lights/emitter.h and scene/camera.h place lights and cameras. Metres, +Y up, as in glTF.
 * References are indices into arrays of the scene; -1: none. Parents precede their children. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/image.h"
#include "scene/choice.h"

#include <stdbool.h>
#include <stdint.h>

enum { SCENE_NAME_SIZE = 64 };

/* Most mappings of a material, as many as its textures. A mapping is a TEXCOORD with a
 * KHR_texture_transform; textures with equal ones share it. */
enum { MAPPINGS_MAX = 4 };

/* Triangles of one material. Attributes are per vertex; uv and color may be NULL. */
struct primitive {
    int vertex_count, index_count;
    float (*position)[3];
    float (*normal)[3];           /* unit; flat if the file has none */
    float (*uv[MAPPINGS_MAX])[2]; /* transformed, by the material's mapping */
    float (*color)[4];            /* linear RGBA, multiplies the base colour */
    uint32_t *indices;            /* index_count = 3 x triangles; strips and fans are unrolled */
    int material;                 /* never -1: a default material replaces it */
    bool flat;                    /* no vertex is shared; normals are always the triangles' */

    /* Joints of the node's skin and their weights for each vertex; both or none. */
    uint16_t (*joints)[4];
    float (*weights)[4]; /* sum 1 */
    int joint_bound;     /* greatest joint + 1 */

    struct morph_target *targets; /* one for each target of the mesh; NULL: none */
};

/* Displacements of all vertices of a primitive at weight 1; NULL: none. */
struct morph_target {
    float (*position)[3], (*normal)[3];
};

struct mesh {
    char name[SCENE_NAME_SIZE];
    struct primitive *primitives;
    int primitive_count;
    int target_count;
    float *weights; /* default morph weights; NULL: none */
};

/* Skin of a mesh. A vertex is at the weighted mean of world(joint) x inverse_bind x position; the
 * node's own world matrix has no effect. */
struct skin {
    char name[SCENE_NAME_SIZE];
    int joint_count;
    int *joints; /* nodes; -1: not in the scene, and no node of the scene has this skin */
    float (*inverse_bind)[16];
};

/* glTF's metallic-roughness model. Each value is multiplied by its texture, if any.
 * scene/material.h interprets it. */
struct material {
    char name[SCENE_NAME_SIZE];
    float base_color[4];        /* linear; also times the vertex colour */
    float metalness, roughness; /* in [0, 1] */
    /* Dielectric reflectance at normal and grazing incidence: .04 and 1, or by
     * KHR_materials_{ior,specular}. */
    float specular_f0[3], specular_f90;
    float transmission;        /* fraction of entering light that is not scattered: glass */
    float index_of_refraction; /* default 1.5 */
    float absorption[3];       /* inside, 1/m */
    bool thin_walled;          /* light passes straight through: only KHR_materials_transmission */
    float emission[3];         /* linear, W/(sr m2) */
    int base_color_texture;    /* -1: none, as for the other textures */
    int metal_roughness_texture; /* roughness in G, metalness in B */
    int emission_texture;
    int normal_texture; /* tangent space: X along u, Y against v */
    float normal_scale; /* factor of X and Y */
    bool unlit;         /* KHR_materials_unlit: the base colour is emitted radiance */
    bool alpha_mask;    /* alpha below the cutoff is a hole */
    float alpha_cutoff;
    bool double_sided; /* else backs are invisible to the camera and do not reflect */
    /* The metal-roughness texture has the specular colour in RGB and glossiness in A, as in
     * KHR_materials_pbrSpecularGlossiness. */
    bool specular_glossiness;
    /* The base colour has mapping 0. */
    int metal_roughness_mapping, emission_mapping, normal_mapping;
    bool blends;     /* alpha blending; with a mask too, for example leaves */
    float thickness; /* of a transmitting solid, metres */
    /* A clip changes the material; a clip changes its reflection (scene/animated.h). */
    bool is_animated, may_shine;
    float emissive_factor[3], emissive_strength; /* factors of emission */
};

enum texture_wrap { TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_MIRROR };

struct scene_texture {
    struct bitmap bitmap;
    bool linear; /* else RGB is sRGB-encoded; A is always linear */
    enum texture_wrap wrap_u, wrap_v;
    bool nearest; /* nearest texel; else bilinear with mip maps */
};

enum emitter_type {
    EMITTER_SPOT,
    EMITTER_POINT,
    EMITTER_DIRECTIONAL,
    EMITTER_AREA,
    EMITTER_MANY, /* all sampled lights as one (passes/sampled_lights.h); none of a scene */
};

/* Effect of a node's scale on a light's size. */
enum light_scaling {
    LIGHT_NOT_SCALED,
    LIGHT_SCALED_ALIKE,    /* by the greatest scale, on both sides [EXT_lights_area] */
    LIGHT_SCALED_EACH_WAY, /* each side by its own scale */
};

/* Greatest intensity, in the light's unit: its square a millimetre from a surface is finite. */
#define SCENE_LIGHT_MOST 1e12F

/* A light of KHR_lights_punctual, EXT_lights_area or an emissive surface, in radiometric units. It
 * shines along the node's -Z. */
struct scene_light {
    char name[SCENE_NAME_SIZE];
    enum emitter_type type;
    /* Colour x intensity: W/sr; W/m2 for a directional light, W/(sr m2) for an area light. */
    float intensity[3];
    float inner, outer; /* half angles of a spot's cone, radians */
    float range;        /* greatest distance of its light, metres; infinite: unbounded */
    float size[2];      /* as in struct emitter */
    enum light_scaling scaling;
    int slide;                       /* number of its slide + 1; 0: none */
    float color[3], strength, scale; /* factors of intensity */
    int material;   /* number of the material whose emission scales it, + 1; 0: none */
    int lamp;       /* number of its lamp of emissive surfaces; 0: none */
    bool stands_in; /* approximates emissive surfaces from afar, with other lights */
};

/* Triangles of a node's mesh that emit as part of a lamp (scene/lights/emissive.h). */
struct emissive_surface {
    int node, primitive;
    int first, end; /* range of the primitive's indices */
    int lamp;
};

/* A camera, along the node's -Z with +Y up. */
struct scene_camera {
    char name[SCENE_NAME_SIZE];
    bool orthographic;
    float fov_y;     /* perspective: radians */
    float y_extent;  /* orthographic: half the height, metres */
    float near, far; /* znear and zfar, metres; far 0: infinite */
    float aspect;    /* width over height, from 1/16 to 16; 0: not given */
};

struct node {
    char name[SCENE_NAME_SIZE];
    int parent;  /* below its own index; -1: root */
    bool hidden; /* it or an ancestor is hidden: no mesh, no light */
    bool dark;   /* hidden with its descendants until a clip shows it */
    int mesh, light, camera, skin;
    int metaballs;  /* replaces the mesh's surface, with the material of its first primitive */
    float *weights; /* morph weights of its mesh; NULL: the mesh's */
    /* Local transform: a column-major matrix, or TRS if has_matrix is false. */
    bool has_matrix;
    float matrix[16];
    float translation[3], rotation[4] /* x y z w */, scale[3];
};

enum channel_path {
    CHANNEL_TRANSLATION, /* targets a node, as the next four */
    CHANNEL_ROTATION,
    CHANNEL_SCALE,
    CHANNEL_WEIGHTS,
    CHANNEL_VISIBLE,
    CHANNEL_LIGHT, /* numbers of a light, a camera or a material */
    CHANNEL_CAMERA,
    CHANNEL_MATERIAL,
};
enum interpolation { INTERPOLATION_LINEAR, INTERPOLATION_STEP, INTERPOLATION_CUBIC };

/* Values of one property over time. */
struct channel {
    int target; /* a node without a matrix, a light, a camera or a material */
    enum channel_path path;
    /* Position of the numbers: bytes in the target's struct; for weights, the number of weights
     * before. */
    size_t offset;
    float least, most; /* bounds of numbers of a light, camera or material */
    enum interpolation interpolation;
    int key_count, width; /* width: 1 to 4 or the number of morph targets */
    float *times;         /* seconds, increasing */
    float *values;        /* width numbers a key; cubic: in-tangent, value, out-tangent */
};

/* An animation. */
struct clip {
    char name[SCENE_NAME_SIZE];
    struct channel *channels;
    int channel_count;
    float duration; /* last time of all channels, seconds */
};

/* A homogeneous participating medium, fog or smoke, RGB; all zero: none. It fills the scene's
 * bounding sphere (geometry.h). Scattering has a Henyey-Greenstein phase function with mean cosine
 * g in (-1, 1). */
struct medium {
    float scattering[3], absorption[3]; /* 1/m */
    float g;                            /* above 0: forward scattering */
};

struct scene {
    char *path;
    double origin[3]; /* origin of all positions, metres (scene/recentre.h) */
    struct node *nodes;
    struct mesh *meshes;
    struct material *materials;
    struct material *still_materials; /* the file's materials, if clips change some; else NULL */
    struct scene_texture *textures;
    struct scene_light *lights;
    struct slide *slides; /* scene/lights/slide.h */
    struct emissive_surface *surfaces;
    struct scene_camera *cameras;
    struct skin *skins;
    struct metaballs *metaballs;
    struct clip *clips;
    int node_count, mesh_count, material_count, texture_count, light_count, camera_count;
    int slide_count;
    int surface_count;
    struct choice_list scenes, variants; /* of the file */
    char **files;                        /* named buffers and pictures, besides `path` */
    int skin_count, metaballs_count, clip_count, file_count;
    /* Primitives of the file that are not drawn. */
    int point_primitives, line_primitives;
    bool of_blender_3;    /* Blender 3 cannot export lamps in watts (scene/lights/punctual.h) */
    float punctual_scale; /* factor of punctual lights in the file; 0: none */
    float punctual_given; /* factor of punctual lights by the user */
    struct environment *environment; /* scene/lights/environment.h; NULL: none */
    struct medium medium;            /* the file's; scene/medium.h chooses the one in use */
    int *playing; /* playing clips, in the order in which they act (scene/clips.h) */
    int playing_count;
    bool plays_default; /* no clip was chosen */
    int clip_choice;    /* changes with each choice */
};

/* Reads the contents of a .gltf or .glb file; scene/open.h makes it ready to render. Error: names
 * file, object and reason; the scene is then zeroed. */
bool scene_load(struct scene *scene, const char *path);

/* Reads one of a file's scenes and variants. Error: also an unknown choice. */
bool scene_load_choice(struct scene *scene, const char *path, const struct scene_choice *choice);

/* Moves a scene that a caller has filled, and adds its emissive surfaces' lights. Error: a node too
 * far away; the scene is then zeroed. */
bool scene_take(struct scene *scene, struct scene *filled);

/* Accepts zeroed and half-built scenes. */
void scene_free(struct scene *scene);

/* Error: writing to the path would destroy a file of the scene. */
bool scene_check_output(const struct scene *scene, const char *path);

/* Writes the visibility of all nodes at a time, seconds, by clips of KHR_node_visibility. */
void scene_nodes_shown(const struct scene *scene, double time, bool *shown);

/* Writes world matrices of all nodes at a time, seconds: node_count x 16 floats, column-major. */
void scene_node_worlds(const struct scene *scene, double time, float (*worlds)[16]);

#endif
