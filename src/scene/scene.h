/* What a glTF file holds, on the CPU: a node tree, meshes, materials, lights and cameras.
 *
 * A scene is only a description. scene/mesh/geometry.h turns it into world-space triangles at one
 * time; scene/lights/emitter.h and scene/camera.h place a light and a camera. Metres, +Y up, as glTF has
 * it. Everything is an index into an array of the scene; -1 is none. Nodes come parents first.
 */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/image.h"
#include "scene/choice.h"

#include <stdbool.h>
#include <stdint.h>

enum { SCENE_NAME_SIZE = 64 };

/* A material's mappings: each is a TEXCOORD of its primitives with a KHR_texture_transform. Textures that
 * lie alike share one, and a material has four textures. */
enum { MAPPINGS_MAX = 4 };

/* Triangles of one material. Attributes are per vertex; uv and color may be NULL. */
struct primitive {
    int vertex_count, index_count;
    float (*position)[3];
    float (*normal)[3];           /* unit; computed flat where the file has none */
    float (*uv[MAPPINGS_MAX])[2]; /* of each mapping of the material, transformed */
    float (*color)[4];            /* linear RGBA, multiplies the base colour */
    uint32_t *indices;            /* index_count = 3 x triangles; strips and fans are unrolled */
    int material;                 /* never -1: the default material stands in */
    bool flat; /* no vertex is shared; normals are the triangles', however they move */

    /* Of which joints of the node's skin each vertex follows how much; both or none. */
    uint16_t (*joints)[4];
    float (*weights)[4]; /* sum 1 */
    int joint_bound;     /* greatest joint + 1 */

    struct morph_target *targets; /* as many as the mesh has; NULL = none */
};

/* Displacements of all vertices of a primitive at weight 1; NULL = none. */
struct morph_target {
    float (*position)[3], (*normal)[3];
};

struct mesh {
    char name[SCENE_NAME_SIZE];
    struct primitive *primitives;
    int primitive_count;
    int target_count;
    float *weights; /* of the morph targets, for nodes without weights of their own; NULL = none */
};

/* A vertex stands at the weighted mean of joint's world x inverse_bind x position; the world of the
 * node that shows the mesh has no part in it. */
struct skin {
    char name[SCENE_NAME_SIZE];
    int joint_count;
    int *joints; /* nodes; -1 = none of the scene's, and no node of the scene has this skin */
    float (*inverse_bind)[16];
};

/* glTF's metallic-roughness model: each value times what its texture says, where it has one. What
 * light makes of it: scene/material.h. */
struct material {
    char name[SCENE_NAME_SIZE];
    float base_color[4];                /* linear; times the vertex colour too */
    float metalness, roughness;         /* in [0, 1] */
    float specular_f0[3], specular_f90; /* reflectance of what is no metal, from straight on and
                                            grazing: .04 and 1, or of KHR_materials_{ior,specular} */
    float transmission;                 /* share of light that enters and is not scattered: glass */
    float index_of_refraction;          /* 1.5 where the file gives none */
    float absorption[3];                /* within, 1/m */
    bool thin_walled;            /* light goes straight on: KHR_materials_transmission alone */
    float emission[3];           /* linear, W/(sr m2) */
    int base_color_texture;      /* -1 = none, as of the others */
    int metal_roughness_texture; /* roughness in G, metalness in B */
    int emission_texture;
    int normal_texture; /* tangent space, X along the u of its uv, Y against the v */
    float normal_scale; /* of its X and Y */
    bool unlit;         /* KHR_materials_unlit: the eye sees the base colour as radiance */
    bool alpha_mask;    /* alpha below the cutoff is a hole */
    float alpha_cutoff;
    bool double_sided; /* else: not drawn for the camera and not reflecting from behind */
    bool
        specular_glossiness; /* the metal-roughness texture has, as KHR_materials_pbrSpecularGlossiness
                                 has them, the specular colour in RGB and the glossiness in A */
    int metal_roughness_mapping, emission_mapping, normal_mapping; /* the base colour's is 0 */
    bool blends;                 /* covers what is behind by its alpha; masked, too: leaves */
    float thickness;             /* of a solid that transmits, m */
    bool is_animated, may_shine; /* a clip changes it, or how it reflects: scene/animated.h */
    float emissive_factor[3], emissive_strength; /* emission is their product */
};

enum texture_wrap { TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_MIRROR };

struct scene_texture {
    struct bitmap bitmap;
    bool linear; /* else RGB is sRGB-encoded; A is linear */
    enum texture_wrap wrap_u, wrap_v;
    bool nearest; /* no filtering; else linear with MIP maps */
};

enum emitter_type { EMITTER_SPOT, EMITTER_POINT, EMITTER_DIRECTIONAL, EMITTER_AREA };

/* How a light's size follows the scale of its node. */
enum light_scaling {
    LIGHT_NOT_SCALED,
    LIGHT_SCALED_ALIKE,    /* both ways, by the greatest scale of all [EXT_lights_area] */
    LIGHT_SCALED_EACH_WAY, /* as the surface is */
};

/* No light has more, in its unit: a millimetre from a surface its square is finite still. */
#define SCENE_LIGHT_MOST 1e12F

/* KHR_lights_punctual, EXT_lights_area or an emissive surface, in radiometric units. Shines along
 * the node's -Z. */
struct scene_light {
    char name[SCENE_NAME_SIZE];
    enum emitter_type type;
    float intensity[3]; /* colour x intensity: W/sr; W/m2 for a directional light, W/(sr m2) for an
                           area light */
    float inner, outer; /* spot: half angles of the cone, radians */
    float range;        /* where its light ends, m; infinite: nowhere */
    float size[2];      /* as struct emitter has it */
    enum light_scaling scaling;
    int slide;                       /* of the scene's, one more than its number; 0 = none */
    float color[3], strength, scale; /* intensity is their product */
    int material; /* whose emission is a factor of the intensity, one more than its number; 0 = none */
    int lamp;     /* of emissive surfaces that it is; 0 = none */
    bool stands_in; /* it is what they are like from afar, with others */
};

/* Triangles of a node's mesh that emit light, as part of a lamp: scene/lights/emissive.h. */
struct emissive_surface {
    int node, primitive;
    int first, end; /* of the primitive's indices */
    int lamp;
};

/* Looks along the node's -Z, +Y up. */
struct scene_camera {
    char name[SCENE_NAME_SIZE];
    bool orthographic;
    float fov_y;     /* perspective: radians */
    float y_extent;  /* orthographic: half the height, metres */
    float near, far; /* znear and zfar, metres; far 0 = no end */
    float aspect;    /* width over height, from a sixteenth to 16; 0 = it tells none */
};

struct node {
    char name[SCENE_NAME_SIZE];
    int parent;  /* < own index; -1 = a root */
    bool hidden; /* it or one above: its mesh is not drawn, and it has no light */
    bool dark;   /* the same until a clip shows it, for all below too */
    int mesh, light, camera, skin;
    int metaballs;  /* their surface replaces the mesh's, in the material of its first primitive */
    float *weights; /* of the mesh's morph targets; NULL = the mesh's */
    /* The local transform: a matrix (column-major), or TRS when has_matrix is false. */
    bool has_matrix;
    float matrix[16];
    float translation[3], rotation[4] /* x y z w */, scale[3];
};

enum channel_path {
    CHANNEL_TRANSLATION, /* of a node, as the next four */
    CHANNEL_ROTATION,
    CHANNEL_SCALE,
    CHANNEL_WEIGHTS,
    CHANNEL_VISIBLE,
    CHANNEL_LIGHT, /* numbers of a light, of a camera, of a material */
    CHANNEL_CAMERA,
    CHANNEL_MATERIAL,
};
enum interpolation { INTERPOLATION_LINEAR, INTERPOLATION_STEP, INTERPOLATION_CUBIC };

/* How one property goes through time. */
struct channel {
    int target; /* a node without a matrix, a light, a camera or a material */
    enum channel_path path;
    size_t
        offset; /* of the numbers: in the target's struct, bytes; of weights, how many are before */
    float least, most; /* bounds of numbers of a light, a camera or a material */
    enum interpolation interpolation;
    int key_count, width; /* width: 1 to 4 or the number of morph targets */
    float *times;         /* seconds, increasing */
    float *values;        /* a width for each key; cubic: in-tangent, value and out-tangent */
};

/* An animation. */
struct clip {
    char name[SCENE_NAME_SIZE];
    struct channel *channels;
    int channel_count;
    float duration; /* the last time of all channels, seconds */
};

/* A homogeneous participating medium, fog or smoke, RGB; all zero: none. It fills the bounding sphere of the scene:
 * geometry.h's. Scattering is by the Henyey-Greenstein phase function, with the mean cosine g in (-1, 1). */
struct medium {
    float scattering[3], absorption[3]; /* 1/m */
    float g;                            /* above 0: forward */
};

struct scene {
    char *path;
    double origin[3]; /* all positions are relative to it, metres; scene/recentre.h */
    struct node *nodes;
    struct mesh *meshes;
    struct material *materials;
    struct material *still_materials; /* those of the file, where clips change some; NULL = none */
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
    char **files;                        /* beside path: the buffers and pictures that it names */
    int skin_count, metaballs_count, clip_count, file_count;
    /* Of the file, which are not drawn. */
    int point_primitives, line_primitives;
    bool of_blender_3;    /* which cannot write lamps in watts: scene/lights/punctual.h */
    float punctual_scale; /* the file's own factor of its punctual lights; 0 = it has none */
    float punctual_given; /* the user's */
    struct environment *environment; /* scene/lights/environment.h; NULL = none */
    struct medium medium;            /* the file's; scene/medium.h tells which one is shown */
    int *playing; /* the clips that play, in the order in which they act: scene/clips.h */
    int playing_count;
    bool plays_default; /* they were not chosen */
    int clip_choice;    /* another number after each choice */
};

/* Reads what a .gltf or .glb file holds; scene/open.h makes it ready to be shown. Error: names file, object and reason; the scene is then zeroed. */
bool scene_load(struct scene *scene, const char *path);

/* The same of bytes in memory, unless that is NULL: path only tells the folder of files that they name; a name without a
 * folder has none. Error, too: the file has nothing that is chosen. */
struct file_bytes;
bool scene_load_bytes(struct scene *scene, const char *path, const struct file_bytes *bytes,
                      const struct scene_choice *choice);

/* Accepts zeroed and half-built scenes. */
void scene_free(struct scene *scene);

/* An error where writing to the path would destroy one of the scene's own files. */
bool scene_check_output(const struct scene *scene, const char *path);

/* Of all nodes whether they are shown at a time, as clips of KHR_node_visibility have it. */
void scene_nodes_shown(const struct scene *scene, double time, bool *shown);

/* World matrices of all nodes at a time in seconds: node_count x 16 floats, column-major. */
void scene_node_worlds(const struct scene *scene, double time, float (*worlds)[16]);

#endif
