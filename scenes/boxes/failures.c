/* Small scenes, each a known way in which many-light methods break: what `manylight bench
 * --failures` measures. All but a few are one room of 4 x 3 x 4 m, open to the camera, whose spot
 * lights the left wall, so that the rest is lit indirectly. */
#include "scenes.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>
#include <math.h>

enum { WHITE, RED, PAPER };

/* What is built, how large, and what it hangs on. */
struct set {
    struct glb *glb;
    float scale;  /* of all lengths; light follows, so that the picture stays */
    double light; /* of the spot, W/sr */
    int root;     /* node; -1 = none */
};

static void hang(const struct set *set, int node) {
    if (set->root >= 0)
        glb_hang(set->glb, node, set->root);
}

static void add_piece(const struct set *set, const char *name, int material,
                      struct surface *surface) {
    for (uint32_t i = 0; i < surface->vertex_count; i++)
        glm_vec3_scale(surface->position[i], set->scale, surface->position[i]);
    hang(set, glb_add_mesh(set->glb, name, surface, material, NULL));
    surface_free(surface);
}

static void place_box(const struct set *set, const char *name, const float low[3],
                      const float high[3]) {
    struct surface surface = {0};
    add_box(&surface, low, high);
    add_piece(set, name, WHITE, &surface);
}

static void place_quad(const struct set *set, const char *name, int material,
                       const float corners[4][3]) {
    struct surface surface = {0};
    add_quad(&surface, corners[0], corners[1], corners[2], corners[3]);
    add_piece(set, name, material, &surface);
}

static void place_spot(const struct set *set, const float eye[3], const float direction[3],
                       double half_angle) {
    vec3 place;
    glm_vec3_scale((float *)eye, set->scale, place);
    hang(set, glb_add_spot(set->glb, place, direction, half_angle,
                           set->light * (double)(set->scale * set->scale)));
}

/* Onto the middle of the left wall. */
static void place_usual_spot(const struct set *set) {
    place_spot(set, (const float[]){0.2f, 1.2f, 1.0f}, (const float[]){-1.0f, 0.2f, -0.35f}, 22.0);
}

static void place_camera(const struct set *set) {
    vec3 eye = {0.0f, 1.5f, 6.6f};
    glm_vec3_scale(eye, set->scale, eye);
    hang(set, glb_add_camera(set->glb, eye, (const float[]){0.0f, 0.0f, -1.0f}, 40.0,
                             0.1 * (double)set->scale, 50.0 * (double)set->scale));
}

static void place_walls(const struct set *set) {
    static const struct {
        const char *name;
        int material;
        float corners[4][3];
    } walls[] = {
        {"floor", WHITE, {{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}}},
        {"ceiling", WHITE, {{-2, 3, -2}, {2, 3, -2}, {2, 3, 2}, {-2, 3, 2}}},
        {"back wall", WHITE, {{-2, 0, -2}, {2, 0, -2}, {2, 3, -2}, {-2, 3, -2}}},
        {"left wall", RED, {{-2, 0, 2}, {-2, 0, -2}, {-2, 3, -2}, {-2, 3, 2}}},
        {"right wall", WHITE, {{2, 0, -2}, {2, 0, 2}, {2, 3, 2}, {2, 3, -2}}},
    };
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++)
        place_quad(set, walls[i].name, walls[i].material, walls[i].corners);
}

static void add_materials(struct glb *glb, const float white[3], const float red[3]) {
    glb_add_material(glb, "white", white, GLB_SINGLE_SIDED);
    glb_add_material(glb, "red", red, GLB_SINGLE_SIDED);
    glb_add_material(glb, "paper", white, GLB_DOUBLE_SIDED);
}

static struct set open_set(struct glb *glb, float scale) {
    add_materials(glb, (const float[]){0.75f, 0.74f, 0.72f}, (const float[]){0.65f, 0.2f, 0.15f});
    return (struct set){.glb = glb, .scale = scale, .light = 100.0, .root = -1};
}

/* Walls and camera. */
static struct set open_room(struct glb *glb) {
    struct set set = open_set(glb, 1.0f);
    place_walls(&set);
    place_camera(&set);
    return set;
}

/* --- blockers --------------------------------------------------------------------------------- */

/* Legs 4 cm wide: less than a texel of a map of 256 across the room. */
void make_table_legs(struct glb *glb) {
    struct set set = open_room(glb);
    place_usual_spot(&set);
    place_box(&set, "top", (const float[]){-0.9f, 0.9f, -0.8f}, (const float[]){0.9f, 0.94f, 0.4f});
    for (int leg = 0; leg < 4; leg++) {
        float x = leg % 2 ? 0.8f : -0.84f, z = leg / 2 ? 0.3f : -0.74f;
        place_box(&set, "leg", (const float[]){x, 0.0f, z},
                  (const float[]){x + 0.04f, 0.9f, z + 0.04f});
    }
}

/* One box stands on the floor, one hangs 2 cm above it. */
void make_contact(struct glb *glb) {
    struct set set = open_room(glb);
    place_usual_spot(&set);
    place_box(&set, "standing", (const float[]){-1.2f, 0.0f, -0.7f},
              (const float[]){-0.3f, 0.7f, 0.3f});
    place_box(&set, "hanging", (const float[]){0.3f, 0.02f, -0.7f},
              (const float[]){1.2f, 0.72f, 0.3f});
}

/* The whole ceiling is lit from below, and a plate and a block hide parts of it. */
void make_wide_light(struct glb *glb) {
    struct set set = open_room(glb);
    place_spot(&set, (const float[]){0.0f, 1.4f, 1.6f}, (const float[]){0.0f, 1.0f, -0.7f}, 50.0);
    place_box(&set, "plate", (const float[]){-1.5f, 1.0f, -1.6f},
              (const float[]){-0.3f, 1.05f, -0.4f});
    place_box(&set, "block", (const float[]){0.5f, 0.0f, -1.2f},
              (const float[]){1.1f, 1.0f, -0.6f});
}

/* The light comes from low on the left wall: floor and ceiling see it edge-on, behind poles. */
void make_grazing_receivers(struct glb *glb) {
    struct set set = open_room(glb);
    place_spot(&set, (const float[]){-0.4f, 0.9f, 0.9f}, (const float[]){-1.0f, -0.35f, -0.5f},
               15.0);
    for (int pole = 0; pole < 3; pole++) {
        float x = -1.0f + 0.8f * (float)pole;
        place_box(&set, "pole", (const float[]){x, 0.0f, -0.5f},
                  (const float[]){x + 0.12f, 1.4f, -0.38f});
    }
}

/* A fin stands out of the lit wall: it crosses the planes of VALs, and has VPLs itself
 * [Dong 2009 Fig. 7]. */
void make_val_plane(struct glb *glb) {
    struct set set = open_room(glb);
    place_spot(&set, (const float[]){0.6f, 1.5f, 1.0f}, (const float[]){-1.0f, 0.0f, -0.45f}, 24.0);
    place_box(&set, "fin", (const float[]){-2.0f, 0.6f, -0.35f},
              (const float[]){-1.2f, 2.4f, -0.25f});
    place_box(&set, "block", (const float[]){0.2f, 0.0f, -1.0f},
              (const float[]){0.9f, 0.9f, -0.3f});
}

/* On the room's axis. */
static void place_ball(const struct set *set, int material, float radius, float height, int rings) {
    struct surface ball = {0};
    add_ball(&ball, (const float[]){0.0f, height, 0.0f}, radius, rings);
    add_piece(set, "ball", material, &ball);
}

/* A lit ball: the centres of its VALs lie within it. */
void make_center_inside(struct glb *glb) {
    struct set set = open_room(glb);
    place_ball(&set, WHITE, 0.6f, 1.2f, 12);
    place_spot(&set, (const float[]){-1.6f, 2.4f, 1.6f}, (const float[]){1.6f, -1.2f, -1.6f}, 11.0);
}

/* A sheet of paper divides the room; only its left half is lit. */
void make_thin_wall(struct glb *glb) {
    struct set set = open_room(glb);
    place_usual_spot(&set);
    place_quad(&set, "sheet", PAPER,
               (const float[4][3]){{0.6f, 0, 2}, {0.6f, 0, -2}, {0.6f, 3, -2}, {0.6f, 3, 2}});
}

/* A wall 20 cm thick divides the room, with a door of 5 cm that is shut. */
void make_closed_door(struct glb *glb) {
    struct set set = open_room(glb);
    place_usual_spot(&set);
    place_box(&set, "wall behind the door", (const float[]){0.4f, 0.0f, -2.0f},
              (const float[]){0.6f, 3.0f, -0.8f});
    place_box(&set, "wall before the door", (const float[]){0.4f, 0.0f, 0.2f},
              (const float[]){0.6f, 3.0f, 2.0f});
    place_box(&set, "wall above the door", (const float[]){0.4f, 2.1f, -0.8f},
              (const float[]){0.6f, 3.0f, 0.2f});
    place_box(&set, "door", (const float[]){0.35f, 0.0f, -0.85f},
              (const float[]){0.4f, 2.15f, 0.25f});
}

/* --- lights ----------------------------------------------------------------------------------- */

static void place_block(const struct set *set) {
    place_box(set, "block", (const float[]){-0.2f, 0.0f, -0.8f}, (const float[]){0.6f, 1.0f, 0.0f});
}

/* The spot shines along the left wall. */
void make_grazing_light(struct glb *glb) {
    struct set set = open_room(glb);
    place_block(&set);
    place_spot(&set, (const float[]){-1.85f, 1.5f, 1.8f}, (const float[]){-0.06f, 0.0f, -1.0f},
               12.0);
}

/* The spot shines out of the room: its map is empty. */
void make_empty_map(struct glb *glb) {
    struct set set = open_room(glb);
    place_block(&set);
    place_spot(&set, (const float[]){0.0f, 1.5f, 1.0f}, (const float[]){0.0f, 0.0f, 1.0f}, 24.0);
}

/* All VPLs lie within three centimetres. A spot's edge is a thousandth wide in the cosine [glTF],
 * so that this one has none of its light but that on its slope. */
void make_needle(struct glb *glb) {
    struct set set = open_room(glb);
    set.light = 1e8;
    place_block(&set);
    place_spot(&set, (const float[]){0.6f, 1.2f, 1.0f}, (const float[]){-1.0f, 0.35f, -0.35f}, 0.3);
}

/* Where three walls meet: VPLs close to what they light. */
void make_corner(struct glb *glb) {
    struct set set = open_room(glb);
    place_block(&set);
    place_spot(&set, (const float[]){-0.9f, 1.1f, -0.9f}, (const float[]){-1.0f, -1.0f, -1.0f},
               20.0);
}

/* No light but a ball of a thousand triangles that shine. */
void make_ball_lamp(struct glb *glb) {
    struct set set = open_room(glb);
    int lamp = glb_add_lamp(glb, "ball", (const float[]){60.0f, 50.0f, 40.0f});
    place_ball(&set, lamp, 0.3f, 2.1f, 24);
    place_box(&set, "block", (const float[]){-1.4f, 0.0f, -1.0f},
              (const float[]){-0.6f, 1.0f, -0.2f});
}

/* --- surfaces --------------------------------------------------------------------------------- */

static void make_room_of(struct glb *glb, float albedo) {
    vec3 color = {albedo, albedo, albedo};
    add_materials(glb, color, color);
    struct set set = {.glb = glb, .scale = 1.0f, .light = 100.0, .root = -1};
    place_walls(&set);
    place_camera(&set);
    place_block(&set);
    place_usual_spot(&set);
}

void make_black(struct glb *glb) {
    make_room_of(glb, 0.0f);
}

void make_white(struct glb *glb) {
    make_room_of(glb, 1.0f);
}

/* The floor is one triangle of a kilometre; on it a lit screen, and a block behind. */
void make_giant_triangle(struct glb *glb) {
    struct set set = open_set(glb, 1.0f);
    struct surface floor = {0};
    const float up[3] = {0.0f, 1.0f, 0.0f};
    uint32_t first = surface_add_vertex(&floor, (const float[]){-600.0f, 0.0f, 400.0f}, up);
    surface_add_vertex(&floor, (const float[]){600.0f, 0.0f, 400.0f}, up);
    surface_add_vertex(&floor, (const float[]){0.0f, 0.0f, -800.0f}, up);
    surface_add_triangle(&floor, first, first + 1, first + 2);
    add_piece(&set, "floor", WHITE, &floor);
    place_quad(&set, "screen", PAPER,
               (const float[4][3]){{-2, 0, 2}, {-2, 0, -2}, {-2, 3, -2}, {-2, 3, 2}});
    place_block(&set);
    place_camera(&set);
    place_usual_spot(&set);
}

/* A table and shelves on a floor that is lit from above, in a room that stands on a plain of
 * 222 m. */
void make_plain(struct glb *glb) {
    struct set set = open_room(glb);
    place_quad(&set, "plain", WHITE,
               (const float[4][3]){
                   {-111, -0.1f, 111}, {111, -0.1f, 111}, {111, -0.1f, -111}, {-111, -0.1f, -111}});
    place_spot(&set, (const float[]){0.0f, 2.7f, 0.2f}, (const float[]){0.0f, -1.0f, -0.15f}, 30.0);
    place_box(&set, "table", (const float[]){-0.9f, 0.35f, -0.6f},
              (const float[]){0.5f, 0.4f, 0.3f});
    for (int shelf = 0; shelf < 4; shelf++) {
        float y = 0.3f * (float)shelf;
        place_box(&set, "shelf", (const float[]){-1.9f, y + 0.1f, -1.5f},
                  (const float[]){-1.3f, y + 0.14f, 1.0f});
    }
    place_box(&set, "cupboard", (const float[]){0.8f, 0.0f, -1.3f},
              (const float[]){1.2f, 0.6f, 0.6f});
}

static void hilly(const void *context, float u, float v, float point[3]) {
    (void)context;
    point[0] = -1.2f + 2.4f * u;
    point[1] = 0.35f + 0.12f * sinf(40.0f * u) * cosf(31.0f * v);
    point[2] = -1.4f + 2.4f * v;
}

/* A bumpy cloth of ten thousand triangles, each about 3 cm long, above the floor. */
void make_tiny_triangles(struct glb *glb) {
    struct set set = open_room(glb);
    struct surface cloth = {0};
    add_sheet(&cloth, &(struct sheet){.place = hilly, .nu = 100, .nv = 50});
    add_piece(&set, "cloth", PAPER, &cloth);
    place_usual_spot(&set);
}

/* --- scale ------------------------------------------------------------------------------------ */

static void fill_set(const struct set *set) {
    place_walls(set);
    place_camera(set);
    place_block(set);
    place_usual_spot(set);
}

/* The room as a millimetre, as a kilometre, and ten kilometres away. */
void make_millimetre(struct glb *glb) {
    struct set set = open_set(glb, 0.25e-3f);
    fill_set(&set);
}

void make_kilometre(struct glb *glb) {
    struct set set = open_set(glb, 250.0f);
    fill_set(&set);
}

void make_far_away(struct glb *glb) {
    struct set set = open_set(glb, 1.0f);
    set.root = glb_add_joint(glb, "far away", -1, (const float[]){1e4f, -1e4f, 1e4f});
    fill_set(&set);
}

/* The room as it is: for what breaks by settings and cameras. */
void make_room(struct glb *glb) {
    struct set set = open_set(glb, 1.0f);
    fill_set(&set);
}
