#include "scene/mesh/solids.h"

#include "base/halton.h"
#include "base/memory.h"
#include "scene/camera.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the surfaces that the rays of a point meet, so many are fronts, or it is hidden. */
static const float least_fronts = .25F;
enum {
    RAYS = 8,
    FRONTS = 3, /* so many and no back, or backs and no front, are enough */
    BACKS = 4,
};

/* --- what hides ------------------------------------------------------------------------------- */

/* A node has a greater number than its parent. */
static bool *find_moving(const struct scene *scene) {
    bool *moves = mem_alloc((size_t)scene->node_count, sizeof *moves);
    for (int c = 0; c < scene->clip_count; c++)
        for (int i = 0; i < scene->clips[c].channel_count; i++)
            moves[scene->clips[c].channels[i].node] = true;
    for (int n = 0; n < scene->node_count; n++)
        moves[n] |= scene->nodes[n].parent >= 0 && moves[scene->nodes[n].parent];
    return moves;
}

static bool stays(const struct solids *solids, const struct geometry_part *part) {
    return part->rigid && !solids->moves[part->node];
}

static vec3s corner(const struct geometry *geometry, uint32_t index) {
    const float *p = geometry->position[index];
    return (vec3s){{p[0], p[1], p[2]}};
}

static struct tree_triangle triangle_of(const struct geometry *geometry, const uint32_t index[3],
                                        bool double_sided) {
    vec3s at = corner(geometry, index[0]);
    return (struct tree_triangle){at,
                                  {glms_vec3_sub(corner(geometry, index[1]), at),
                                   glms_vec3_sub(corner(geometry, index[2]), at)},
                                  double_sided,
                                  {0}};
}

static void plant_tree(struct solids *solids, const struct scene *scene,
                       const struct geometry *geometry) {
    struct tree_triangle *triangles =
        mem_alloc((size_t)geometry->opaque_index_count / 3 + 1, sizeof *triangles);
    uint32_t count = 0;
    for (int p = 0; p < geometry->part_count; p++) {
        const struct geometry_part *part = &geometry->parts[p];
        if (part->first_index >= geometry->opaque_index_count || !stays(solids, part))
            continue;
        const struct mesh *mesh = &scene->meshes[scene->nodes[part->node].mesh];
        bool double_sided =
            scene->materials[mesh->primitives[part->primitive].material].double_sided;
        for (uint32_t i = 0; i < part->index_count; i += 3)
            triangles[count++] =
                triangle_of(geometry, &geometry->indices[part->first_index + i], double_sided);
    }
    triangle_tree_init(&solids->tree, triangles, count);
}

/* --- what is hidden --------------------------------------------------------------------------- */

struct sight {
    int fronts, backs;
};

/* The i-th point of the unit square: multiples of powers of the plastic number, evenly spread from a shift. */
static vec2s square_point(vec2s shift, int i) {
    float x = shift.x + (float)i * .7548776662F, y = shift.y + (float)i * .5698402910F;
    return (vec2s){{x - floorf(x), y - floorf(y)}};
}

static vec2s shift_of(uint32_t number) {
    return (vec2s){{(float)radical_inverse(2, number), (float)radical_inverse(3, number)}};
}

/* Around an axis, at a height over the plane across it. */
static vec3s direction_at(vec3s axis, float height, float turn) {
    vec3s other = fabsf(axis.x) < .5F ? (vec3s){{1, 0, 0}} : (vec3s){{0, 1, 0}};
    vec3s right = glms_vec3_normalize(glms_vec3_cross(axis, other));
    float radius = sqrtf(fmaxf(0, 1 - height * height)), angle = 2 * GLM_PIf * turn;
    vec3s direction = glms_vec3_scale(axis, height);
    direction = glms_vec3_muladds(right, radius * cosf(angle), direction);
    return glms_vec3_muladds(glms_vec3_cross(axis, right), radius * sinf(angle), direction);
}

static vec3s cosine_direction(vec3s normal, vec2s at) {
    return direction_at(normal, sqrtf(at.x), at.y);
}

/* A front is one if the next surface from there is no back: the floor that closes a solid from below belongs to its
 * inside. */
static void look(const struct solids *solids, vec3s from, vec3s direction, vec2s next,
                 struct sight *sight) {
    struct tree_hit hit, other = {0};
    if (!triangle_tree_hit(&solids->tree, from, direction, &hit))
        return;
    if (!hit.back) {
        vec3s normal =
            glms_vec3_normalize(glms_vec3_cross(hit.triangle->edges[0], hit.triangle->edges[1]));
        vec3s at = glms_vec3_muladds(direction, hit.distance, from);
        triangle_tree_hit(&solids->tree, glms_vec3_muladds(normal, solids->clearance, at),
                          cosine_direction(normal, next), &other);
    }
    bool back = hit.back || other.back;
    bool black = back && !(hit.back ? hit.triangle : other.triangle)->double_sided;
    sight->fronts += !back;
    sight->backs += back && !black;
}

/* Around each of them. */
static bool cameras_see_fronts(const struct solids *solids, const struct scene *scene) {
    enum { AROUND = 64 };
    struct sight sight = {0};
    for (int n = 0; n < camera_node_count(scene); n++) {
        struct camera camera;
        camera_place(&camera, scene, n, 0);
        vec3s eye = {{camera.eye[0], camera.eye[1], camera.eye[2]}};
        for (int i = 0; i < AROUND; i++) {
            vec2s at = square_point(shift_of(0), i);
            look(solids, eye, direction_at((vec3s){{0, 1, 0}}, 2 * at.x - 1, at.y),
                 square_point(shift_of(1), i), &sight);
        }
    }
    return sight.fronts >= sight.backs;
}

bool solids_hide(const struct solids *solids, const struct geometry_part *part, vec3s position,
                 vec3s normal, uint32_t number) {
    struct sight sight = {0};
    if (solids->tree.count == 0 || !stays(solids, part))
        return false;
    vec3s above = glms_vec3_muladds(normal, solids->clearance, position);
    vec2s shift = shift_of(number), other = shift_of(~number);
    for (int i = 0; i < RAYS && (sight.backs || sight.fronts < FRONTS) &&
                    (sight.fronts || sight.backs < BACKS);
         i++)
        look(solids, above, cosine_direction(normal, square_point(shift, i)),
             square_point(other, i), &sight);
    return sight.fronts == 0 ||
           (float)sight.fronts < least_fronts * (float)(sight.fronts + sight.backs);
}

/* --- life ------------------------------------------------------------------------------------- */

static float clearance_of(const struct geometry *geometry) {
    float largest = geometry->radius;
    for (int c = 0; c < 3; c++)
        largest =
            fmaxf(largest, fmaxf(fabsf(geometry->bounds_min[c]), fabsf(geometry->bounds_max[c])));
    return 1e-5F * largest;
}

void solids_init(struct solids *solids, const struct scene *scene,
                 const struct geometry *geometry) {
    *solids = (struct solids){.moves = find_moving(scene), .clearance = clearance_of(geometry)};
    plant_tree(solids, scene, geometry);
    if (!cameras_see_fronts(solids, scene))
        solids->tree.count = 0;
}

void solids_free(struct solids *solids) {
    triangle_tree_free(&solids->tree);
    free(solids->moves);
    *solids = (struct solids){0};
}
