/* Writes glTF 2.0 binary files: named nodes with triangles, diffuse materials, lights, a camera.
 *
 * Everything is added to the file in memory; glb_write then writes it. The bytes depend only on
 * what was added.
 */
#ifndef SCENES_GLB_H
#define SCENES_GLB_H

#include "scene/surface.h"

#include <stdbool.h>
#include <stddef.h>

struct glb_text {
    char *data;
    size_t length, capacity;
};

struct glb {
    const char *name;
    /* JSON arrays in the making, without their brackets. */
    struct glb_text nodes, meshes, materials, accessors, views, cameras, lights;
    struct glb_text binary;
    int node_count, mesh_count, material_count, accessor_count, view_count, camera_count,
        light_count;
};

void glb_init(struct glb *glb, const char *name);
void glb_free(struct glb *glb);

enum glb_sides { GLB_SINGLE_SIDED, GLB_DOUBLE_SIDED };

/* A diffuse material of linear albedo; returns its index. */
int glb_add_material(struct glb *glb, const char *name, const float albedo[3],
                     enum glb_sides sides);

/* A node with a mesh of one material. extras is a JSON object for the node, or NULL. An empty
 * surface is left out. */
void glb_add_mesh(struct glb *glb, const char *name, const struct surface *surface, int material,
                  const char *extras);

/* Angles in degrees; directions need not be unit. fov is vertical. */
void glb_add_camera(struct glb *glb, const float eye[3], const float direction[3], double fov,
                    double near, double far);

/* A white spot whose edge is sharp: the inner angle is 0.005 rad below the outer. W/sr. */
void glb_add_spot(struct glb *glb, const float eye[3], const float direction[3], double half_angle,
                  double intensity);
void glb_add_point_light(struct glb *glb, const float position[3], double intensity);

/* Leaves a file that already has these bytes alone, so that its time stays. */
bool glb_write(const struct glb *glb, const char *path);

#endif
