/* Writes glTF 2.0 binary files: named nodes with triangles, diffuse materials, lights, a camera.
 *
 * Everything is added to the file in memory; glb_write then writes it. The bytes depend only on
 * what was added. */
#ifndef SCENES_GLB_H
#define SCENES_GLB_H

#include "base/text.h"
#include "scene/shapes/surface.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct glb {
    const char *name;
    /* JSON arrays in the making, without their brackets. */
    struct text nodes, meshes, materials, accessors, views, cameras, lights, skins;
    struct text channels, samplers; /* of the one animation */
    struct text images, textures, texture_samplers;
    struct text binary;
    int node_count, mesh_count, material_count, accessor_count, view_count, camera_count,
        light_count, skin_count, channel_count, sampler_count, texture_count;
    bool has_lamps, has_glass;
    const char *extras; /* members of the scene's extras in JSON; NULL = none */
    struct glb_node {
        size_t begin; /* of its JSON in nodes */
        int parent;   /* -1 = a root */
    } * hierarchy;
};

void glb_init(struct glb *glb, const char *name);
void glb_free(struct glb *glb);

enum glb_sides { GLB_SINGLE_SIDED, GLB_DOUBLE_SIDED };

/* A diffuse material of linear albedo; returns its index. */
int glb_add_material(struct glb *glb, const char *name, const float albedo[3],
                     enum glb_sides sides);

/* A single-sided one of that base colour, metal or plastic: metalness 1 or 0. */
int glb_add_specular(struct glb *glb, const char *name, const float color[3], float metalness,
                     float roughness);

/* Glass through so many metres of which white light has that colour. */
int glb_add_glass(struct glb *glb, const char *name, float index_of_refraction, float distance,
                  const float color[3]);

/* A picture of at most PNG_SIDE_MOST texels a side, RGBA from the top row on, with the members of a
 * sampler in JSON, "" = none; returns the texture's index. */
int glb_add_texture(struct glb *glb, int width, int height, const unsigned char *rgba,
                    const char *sampler);

/* A material by all its members in JSON. */
int glb_add_material_json(struct glb *glb, const char *json);

/* glb_add_mesh of a surface that is not empty, with texture coordinates of each vertex. */
int glb_add_textured_mesh(struct glb *glb, const char *name, const struct surface *surface,
                          const float (*uv)[2], int material);

/* A grey material that gives that radiance from its front, W/(sr m2): a flat rectangle of it is a
 * light. */
int glb_add_lamp(struct glb *glb, const char *name, const float radiance[3]);

/* A node with a mesh of one material; returns its index. extras is a JSON object for the node, or
 * NULL. An empty surface is left out, and -1 is returned. */
int glb_add_mesh(struct glb *glb, const char *name, const struct surface *surface, int material,
                 const char *extras);

/* A node without anything, for others to hang on; returns its index. */
int glb_add_joint(struct glb *glb, const char *name, int parent, const float translation[3]);

/* Hangs a node on another. */
void glb_hang(struct glb *glb, int node, int parent);

/* What makes a surface follow joints: of each vertex up to four of them, and how much. */
struct glb_skin {
    const int *joints;      /* nodes */
    const float (*rest)[3]; /* where each stands when the surface has its shape; unturned */
    int joint_count;
    const uint8_t (*vertex_joints)[4]; /* numbers of joints */
    const float (*vertex_weights)[4];
};
void glb_add_skinned_mesh(struct glb *glb, const char *name, const struct surface *surface,
                          int material, const struct glb_skin *skin);

/* Moves a node through the keys, in straight lines. Quaternions are x y z w. */
void glb_animate_translation(struct glb *glb, int node, int keys, const float *times,
                             const float (*values)[3]);
void glb_animate_rotation(struct glb *glb, int node, int keys, const float *times,
                          const float (*values)[4]);

/* Angles in degrees; directions need not be unit. fov is vertical. Returns its node. */
int glb_add_camera(struct glb *glb, const float eye[3], const float direction[3], double fov,
                   double near, double far);

/* The turn of a node that makes it look in a direction. */
void glb_direction(const float direction[3], float quaternion[4]);

/* A spot whose edge is sharp, the inner angle 0.005 rad below the outer, or a point. */
struct glb_light {
    const char *name;
    float eye[3], direction[3];
    float color[3];
    double intensity;  /* W/sr */
    double half_angle; /* of a spot, degrees; 0 = a point, whose direction must be there too */
};

/* Returns its node. */
int glb_add_light(struct glb *glb, const struct glb_light *light);

/* A white spot. */
int glb_add_spot(struct glb *glb, const float eye[3], const float direction[3], double half_angle,
                 double intensity);

/* Leaves a file that already has these bytes alone, so that its time stays. */
bool glb_write(const struct glb *glb, const char *path);

#endif
