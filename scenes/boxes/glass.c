/* A golden ring, two glass pawns and a gem in fog, each on a table with a wall behind it, under one
 * spot: what casts caustics [Dong 2011, chapter 8]. */
#include "base/unit.h"
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

static void place_table(struct glb *glb) {
    int grey = glb_add_material(glb, "table", (const float[]){.6F, .58F, .55F}, GLB_SINGLE_SIDED);
    place_quad(glb, "table", grey,
               (const float[4][3]){{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}});
    place_quad(glb, "wall", grey,
               (const float[4][3]){{-4, 0, -4}, {4, 0, -4}, {4, 5, -4}, {-4, 5, -4}});
}

/* A torus about the y axis; its section is an ellipse of those half axes. */
static void add_ring(struct surface *surface, float radius, float across, float up) {
    enum { AROUND = 128, SECTION = 32 };
    uint32_t first = surface->vertex_count;
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j < SECTION; j++) {
            float turn = 2 * GLM_PIf * (float)i / AROUND, angle = 2 * GLM_PIf * (float)j / SECTION;
            float r = radius + across * cosf(angle);
            vec3 normal = {cosf(angle) / across * cosf(turn), sinf(angle) / up,
                           cosf(angle) / across * sinf(turn)};
            vec3_unit(normal);
            surface_add_vertex(
                surface, (float[]){r * cosf(turn), up + up * sinf(angle), r * sinf(turn)}, normal);
        }
    for (uint32_t i = 0; i < AROUND; i++)
        for (uint32_t j = 0; j < SECTION; j++) {
            uint32_t next = (i + 1) % AROUND, above = (j + 1) % SECTION;
            uint32_t a = first + i * SECTION + j, b = first + next * SECTION + j;
            uint32_t c = first + next * SECTION + above, d = first + i * SECTION + above;
            surface_add_triangle(surface, a, d, c);
            surface_add_triangle(surface, a, c, b);
        }
}

void make_ring(struct glb *glb) {
    struct surface ring = {0};
    place_table(glb);
    int gold = glb_add_specular(glb, "gold", (const float[]){1, .77F, .34F}, 1, .05F);
    add_ring(&ring, 1.2F, .1F, .35F);
    place_surface(glb, "ring", gold, &ring);
    glb_add_camera(glb, (const float[]){.6F, 3.4F, 4.6F}, (const float[]){-.1F, -.72F, -1}, 40, .1,
                   50);
    glb_add_spot(glb, (const float[]){-3.2F, 4.2F, 1.6F}, (const float[]){.58F, -.74F, -.3F}, 32,
                 220);
}

static void place_pawn(struct glb *glb, const char *name, int material, const float foot[3]) {
    static const struct lathe_point profile[] = {
        {0, 0, 0},         {.5F, 0, 0},      {.52F, .06F, 0}, {.5F, .14F, 0},   {.36F, .22F, 0},
        {.27F, .36F, 0},   {.21F, .6F, 0},   {.19F, .8F, 0},  {.22F, .9F, 0},   {.34F, .96F, 0},
        {.34F, 1, 0},      {.24F, 1.06F, 0}, {.3F, 1.16F, 0}, {.335F, 1.3F, 0}, {.3F, 1.45F, 0},
        {.21F, 1.565F, 0}, {.1F, 1.615F, 0}, {0, 1.63F, 0}};
    struct surface piece = {0}, pawn = {0};
    add_lathe(&piece, profile, sizeof profile / sizeof *profile, 96, 0);
    add_copy(&pawn, &piece, 0, foot);
    surface_free(&piece);
    place_surface(glb, name, material, &pawn);
}

void make_pawns(struct glb *glb) {
    static const float clear[3] = {1, 1, 1}, green[3] = {.35F, .9F, .5F};
    place_table(glb);
    place_pawn(glb, "clear pawn", glb_add_glass(glb, "glass", 1.5F, .5F, clear),
               (const float[]){-.7F, .002F, -.3F});
    place_pawn(glb, "green pawn", glb_add_glass(glb, "green glass", 1.5F, .5F, green),
               (const float[]){.8F, .002F, .4F});
    glb_add_camera(glb, (const float[]){.3F, 2.6F, 4.8F}, (const float[]){-.03F, -.42F, -1}, 42, .1,
                   50);
    glb_add_spot(glb, (const float[]){-3.2F, 4.4F, 2.6F}, (const float[]){.6F, -.66F, -.45F}, 26,
                 260);
}

/* Corners of a brilliant, ring by ring from the culet up, each turned by half a step more where it
 * says so. */
static const struct gem_ring {
    float radius, y;
    bool half;
} gem_rings[] = {{0, 0, false},      {.95F, .8F, false},   {.95F, .88F, false},
                 {.78F, 1.1F, true}, {.52F, 1.24F, false}, {0, 1.24F, true}};
enum { GEM_RINGS = sizeof gem_rings / sizeof *gem_rings, GEM_SIDES = 8 };

static void gem_corner(int ring, int i, float corner[3]) {
    const struct gem_ring *at = &gem_rings[ring];
    float turn = 2 * GLM_PIf * ((float)(i % GEM_SIDES) + (at->half ? .5F : 0)) / GEM_SIDES;
    glm_vec3_copy((vec3){at->radius * cosf(turn), .1F + at->y, at->radius * sinf(turn)}, corner);
}

static void add_facet(struct surface *surface, float a[3], float b[3], float c[3]) {
    vec3 ab, ac, normal;
    glm_vec3_sub(b, a, ab);
    glm_vec3_sub(c, a, ac);
    glm_vec3_cross(ab, ac, normal);
    if (glm_vec3_norm(normal) < 1e-4F) /* two corners meet on the axis */
        return;
    vec3_unit(normal);
    uint32_t first = surface_add_vertex(surface, a, normal);
    surface_add_vertex(surface, b, normal);
    surface_add_vertex(surface, c, normal);
    surface_add_triangle(surface, first, first + 1, first + 2);
}

void make_gem(struct glb *glb) {
    struct surface gem = {0};
    place_table(glb);
    for (int ring = 0; ring + 1 < GEM_RINGS; ring++)
        for (int i = 0; i < GEM_SIDES; i++) {
            int shift = gem_rings[ring].half && !gem_rings[ring + 1].half;
            vec3 low, next_low, high, next_high;
            gem_corner(ring, i, low);
            gem_corner(ring, i + 1, next_low);
            gem_corner(ring + 1, i + shift, high);
            gem_corner(ring + 1, i + shift + 1, next_high);
            add_facet(&gem, low, high, next_low);
            add_facet(&gem, next_low, high, next_high);
        }
    place_surface(glb, "gem", glb_add_glass(glb, "diamond", 2.4F, 1, (const float[]){.9F, .95F, 1}),
                  &gem);
    glb_add_camera(glb, (const float[]){.4F, 2.3F, 4.6F}, (const float[]){-.06F, -.36F, -1}, 42, .1,
                   50);
    glb_add_spot(glb, (const float[]){-2.6F, 4.8F, 1.2F}, (const float[]){.53F, -.83F, -.24F}, 24,
                 260);
    glb->extras = "\"medium\":{\"sigma_s\":0.06,\"sigma_a\":0.005,\"g\":0.3}";
}
