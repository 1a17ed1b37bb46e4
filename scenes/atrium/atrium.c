/* An atrium in the manner of the Sponza palace: a court between two storeys of arcades.
 *
 * The court lies along x, columns stand every PITCH metres round it, and an aisle with groin vaults
 * runs behind them; above it a gallery with a timber ceiling. Each kind of piece is built once and
 * copied. All masonry is closed solids, so that a single side of each face is enough; cloth and
 * leaves are sheets.
 *
 * The spot stands above the open roof and lights a patch of the floor and of the north arcade
 * (z < 0); everything else in the picture is indirect light. */
#include "atrium/furnishing.h"
#include "atrium/pieces.h"
#include "scenes.h"
#include "shapes/shapes.h"

#include <stdbool.h>
#include <stddef.h>

/* --- the plan --------------------------------------------------------------------------------- */

enum { LONG_BAYS = 8, SHORT_BAYS = 3, RELIEF_SIDE = 3 };

/* The court's sides in quarter turns from the north one (z < 0), which faces +z. In a side's frame
 * x runs to the right as seen from the court, z towards the court, and the columns stand at z
 * = 0. */
static int bay_count(int side) {
    return side % 2 ? SHORT_BAYS : LONG_BAYS;
}

static float side_length(int side) {
    return (float)bay_count(side) * PITCH;
}

static void add_to_side(struct surface *surface, const struct surface *piece, int side, float x,
                        float y, float z) {
    static const float right[4][2] = {{1.0f, 0.0f}, {0.0f, -1.0f}, {-1.0f, 0.0f}, {0.0f, 1.0f}};
    const float *r = right[side];
    z -= 0.5f * side_length(side + 1);
    add_copy(surface, piece, side, (const float[]){r[0] * x - r[1] * z, y, r[1] * x + r[0] * z});
}

/* The middle of a bay; half numbers are columns. */
static float bay_x(int side, float bay) {
    return (bay + 0.5f) * PITCH - 0.5f * side_length(side);
}

/* --- what it is made of ----------------------------------------------------------------------- */

enum kind {
    FLOOR_LIGHT,
    FLOOR_DARK,
    PAVING,
    ARCHES,
    TRIM,
    COLUMNS,
    CAPITALS,
    UPPER_COLUMNS,
    VAULTS,
    RIBS,
    WALLS,
    BALUSTRADE,
    TIMBER,
    ROOF,
    RELIEF,
    POTS,
    RODS,
    RED,
    GREEN,
    BLUE,
    LEAVES,
    KIND_COUNT,
};

static const struct {
    const char *name;
    float albedo[3];
    enum glb_sides sides;
} kinds[KIND_COUNT] = {
    [FLOOR_LIGHT] = {"floor, light tiles", {0.58f, 0.53f, 0.45f}, GLB_SINGLE_SIDED},
    [FLOOR_DARK] = {"floor, dark tiles", {0.30f, 0.22f, 0.17f}, GLB_SINGLE_SIDED},
    [PAVING] = {"paving", {0.46f, 0.42f, 0.36f}, GLB_SINGLE_SIDED},
    [ARCHES] = {"arches", {0.60f, 0.53f, 0.42f}, GLB_SINGLE_SIDED},
    [TRIM] = {"mouldings", {0.66f, 0.61f, 0.52f}, GLB_SINGLE_SIDED},
    [COLUMNS] = {"columns", {0.63f, 0.56f, 0.46f}, GLB_SINGLE_SIDED},
    [CAPITALS] = {"capitals", {0.67f, 0.62f, 0.53f}, GLB_SINGLE_SIDED},
    [UPPER_COLUMNS] = {"upper columns", {0.64f, 0.58f, 0.49f}, GLB_SINGLE_SIDED},
    [VAULTS] = {"vaults", {0.66f, 0.60f, 0.50f}, GLB_SINGLE_SIDED},
    [RIBS] = {"ribs and pilasters", {0.56f, 0.48f, 0.38f}, GLB_SINGLE_SIDED},
    [WALLS] = {"walls", {0.57f, 0.46f, 0.34f}, GLB_SINGLE_SIDED},
    [BALUSTRADE] = {"balustrade", {0.68f, 0.64f, 0.57f}, GLB_SINGLE_SIDED},
    [TIMBER] = {"timber", {0.27f, 0.17f, 0.10f}, GLB_SINGLE_SIDED},
    [ROOF] = {"roof", {0.45f, 0.20f, 0.12f}, GLB_SINGLE_SIDED},
    [RELIEF] = {"relief", {0.70f, 0.66f, 0.58f}, GLB_SINGLE_SIDED},
    [POTS] = {"pots", {0.50f, 0.24f, 0.14f}, GLB_SINGLE_SIDED},
    [RODS] = {"rods", {0.28f, 0.24f, 0.16f}, GLB_SINGLE_SIDED},
    [RED] = {"red cloth", {0.62f, 0.06f, 0.05f}, GLB_DOUBLE_SIDED},
    [GREEN] = {"green cloth", {0.08f, 0.40f, 0.10f}, GLB_DOUBLE_SIDED},
    [BLUE] = {"blue cloth", {0.06f, 0.12f, 0.55f}, GLB_DOUBLE_SIDED},
    [LEAVES] = {"leaves", {0.12f, 0.30f, 0.06f}, GLB_DOUBLE_SIDED},
};

struct atrium {
    struct surface surfaces[KIND_COUNT];
};

typedef void (*piece_function)(struct surface *surface);

/* Where copies of a piece go, along all sides. */
enum places { EVERY_BAY, OPEN_BAYS, EVERY_COLUMN, OPEN_COLUMNS, EVERY_RIB, CORNERS };

/* In bays: first and last, counted from the left; columns lie half a bay further left. */
static void places_range(enum places places, int side, float *first, float *last) {
    float bays = (float)bay_count(side);
    *first = places == EVERY_BAY || places == OPEN_BAYS         ? 0.0f
             : places == EVERY_COLUMN || places == OPEN_COLUMNS ? 0.5f
                                                                : -0.5f;
    *last = places == CORNERS ? -0.5f : places == EVERY_RIB ? bays - 0.5f : bays - 1.0f;
}

static void add_everywhere(struct atrium *atrium, enum kind kind, enum places places,
                           piece_function add, float y, float z) {
    struct surface piece = {0};
    add(&piece);
    for (int side = 0; side < 4; side++) {
        bool open = places == OPEN_BAYS || places == OPEN_COLUMNS;
        if (open && side == RELIEF_SIDE)
            continue;
        float first, last;
        places_range(places, side, &first, &last);
        for (float bay = first; bay <= last; bay += 1.0f)
            add_to_side(&atrium->surfaces[kind], &piece, side, bay_x(side, bay), y, z);
    }
    surface_free(&piece);
}

/* A box in the frame of a side. */
static void add_side_box(struct atrium *atrium, enum kind kind, int side, const float low[3],
                         const float high[3]) {
    struct surface box = {0};
    add_box(&box, low, high);
    add_to_side(&atrium->surfaces[kind], &box, side, 0.0f, 0.0f, 0.0f);
    surface_free(&box);
}

/* A moulding as long as its side and `longer`. */
static void add_along_sides(struct atrium *atrium, enum kind kind,
                            void (*add)(struct surface *surface, float length), float longer,
                            float y, float z) {
    for (int side = 0; side < 4; side++) {
        struct surface piece = {0};
        add(&piece, side_length(side) + longer);
        add_to_side(&atrium->surfaces[kind], &piece, side, 0.0f, y, z);
        surface_free(&piece);
    }
}

/* --- lower storey ----------------------------------------------------------------------------- */

static void add_bay_vault(struct surface *surface) {
    add_aisle_vault(surface, 0.5f * PITCH, 0.5f * AISLE);
}

static void add_corner_vault(struct surface *surface) {
    add_aisle_vault(surface, 0.5f * AISLE, 0.5f * AISLE);
}

static void add_vaults(struct atrium *atrium) {
    add_everywhere(atrium, VAULTS, EVERY_BAY, add_bay_vault, SPRING, -0.5f * AISLE);
    add_everywhere(atrium, RIBS, EVERY_RIB, add_aisle_rib, 0.0f, -0.5f * AISLE);
    struct surface corner = {0};
    add_corner_vault(&corner);
    for (int side = 0; side < 4; side++)
        add_to_side(&atrium->surfaces[VAULTS], &corner, side, -0.5f * (side_length(side) + AISLE),
                    SPRING, -0.5f * AISLE);
    surface_free(&corner);
}

static void add_lower_storey(struct atrium *atrium) {
    add_everywhere(atrium, COLUMNS, OPEN_COLUMNS, add_column_shaft, 0.0f, 0.0f);
    add_everywhere(atrium, CAPITALS, OPEN_COLUMNS, add_column_ends, 0.0f, 0.0f);
    add_everywhere(atrium, RIBS, CORNERS, add_pier, 0.0f, 0.0f);
    add_everywhere(atrium, ARCHES, OPEN_BAYS, add_lower_arch, 0.0f, 0.0f);
    add_everywhere(atrium, TRIM, OPEN_BAYS, add_lower_archivolt, 0.0f, 0.0f);
    add_everywhere(atrium, WALLS, EVERY_BAY, add_door_wall, 0.0f, -AISLE - 0.175f);
    add_everywhere(atrium, TIMBER, EVERY_BAY, add_door, 0.0f, -AISLE - 0.24f);
    add_everywhere(atrium, ARCHES, CORNERS, add_lower_corner, 0.0f, 0.0f);
    add_vaults(atrium);
    add_along_sides(atrium, TRIM, add_string_course, -0.5f, GALLERY - 0.22f, 0.5f * ARCADE_DEPTH);
}

/* --- upper storey ----------------------------------------------------------------------------- */

static void add_joists(struct surface *surface) {
    for (int i = 0; i < 4; i++) {
        float x = ((float)i - 1.5f) * 0.25f * PITCH;
        add_box(surface, (const float[]){x - 0.07f, -0.2f, -AISLE - 0.4f},
                (const float[]){x + 0.07f, 0.02f, -0.1f});
    }
}

static void add_upper_storey(struct atrium *atrium) {
    add_everywhere(atrium, BALUSTRADE, EVERY_COLUMN, add_pedestal, GALLERY, 0.0f);
    add_everywhere(atrium, BALUSTRADE, CORNERS, add_pedestal, GALLERY, 0.0f);
    add_everywhere(atrium, BALUSTRADE, EVERY_BAY, add_balusters, GALLERY, 0.0f);
    add_everywhere(atrium, TRIM, EVERY_BAY, add_rail, GALLERY, 0.0f);
    add_everywhere(atrium, UPPER_COLUMNS, EVERY_COLUMN, add_upper_column, GALLERY, 0.0f);
    add_everywhere(atrium, CAPITALS, EVERY_COLUMN, add_upper_capital, GALLERY, 0.0f);
    add_everywhere(atrium, RIBS, CORNERS, add_upper_pier, GALLERY, 0.0f);
    add_everywhere(atrium, ARCHES, EVERY_BAY, add_upper_arch, GALLERY, 0.0f);
    add_everywhere(atrium, TRIM, EVERY_BAY, add_upper_archivolt, GALLERY, 0.0f);
    add_everywhere(atrium, TIMBER, EVERY_BAY, add_joists, EAVES, 0.0f);
    add_along_sides(atrium, TRIM, add_cornice, -0.3f, EAVES - 0.05f, 0.5f * UPPER_DEPTH);
    add_along_sides(atrium, ROOF, add_roof, 2.0f * AISLE, EAVES + 0.3f, 0.0f);
}

/* --- floors, ceilings, walls ------------------------------------------------------------------ */

/* Slabs from the court's edge to behind the outer wall; the long sides take the corners. */
static void add_slabs(struct atrium *atrium) {
    const float back = -AISLE - 0.45f, outside = -AISLE - 0.8f;
    for (int side = 0; side < 4; side++) {
        float half = 0.5f * side_length(side), corner = side % 2 ? -0.3f : AISLE + 0.45f;
        add_side_box(atrium, PAVING, side, (const float[]){-half - corner, GALLERY - 0.09f, back},
                     (const float[]){half + corner, GALLERY, 0.3f});
        add_side_box(atrium, TIMBER, side, (const float[]){-half - corner, EAVES, back},
                     (const float[]){half + corner, EAVES + 0.08f, 0.1f});
        add_side_box(atrium, WALLS, side, (const float[]){-half - AISLE - 0.8f, -0.3f, outside},
                     (const float[]){half + AISLE + 0.8f, EAVES + 1.4f, -AISLE - 0.35f});
        for (int end = -1; end <= 1; end += 2)
            add_side_box(atrium, WALLS, side,
                         (const float[]){end < 0 ? -half - AISLE - 0.4f : half, -0.1f, back},
                         (const float[]){end < 0 ? -half : half + AISLE + 0.4f, 4.4f, -AISLE});
        /* The step on which the columns stand. */
        add_side_box(atrium, TRIM, side, (const float[]){-half - 0.45f, -0.2f, -0.45f},
                     (const float[]){half + 0.45f, 0.0f, 0.45f});
    }
}

static void add_floor(struct atrium *atrium) {
    const float tile = 0.8f;
    const float half_x = 0.5f * side_length(0), half_z = 0.5f * side_length(1);
    add_box(&atrium->surfaces[PAVING],
            (const float[]){-half_x - AISLE - 0.5f, -0.3f, -half_z - AISLE - 0.5f},
            (const float[]){half_x + AISLE + 0.5f, -0.012f, half_z + AISLE + 0.5f});
    for (int j = -4; j < 4; j++)
        for (int i = -12; i < 12; i++) {
            float x = (float)i * tile, z = (float)j * tile;
            bool border = i == -12 || i == 11 || j == -4 || j == 3;
            enum kind kind = border || (i + j) % 2 ? FLOOR_LIGHT : FLOOR_DARK;
            add_box(&atrium->surfaces[kind], (const float[]){x, -0.1f, z},
                    (const float[]){x + tile, 0.0f, z + tile});
        }
}

static void add_relief_wall(struct atrium *atrium) {
    const float half = 0.5f * side_length(RELIEF_SIDE), front = 0.5f * ARCADE_DEPTH;
    const float middle = 2.25f;
    add_side_box(atrium, ARCHES, RELIEF_SIDE, (const float[]){-half, -0.1f, -front},
                 (const float[]){half, GALLERY - 0.05f, front});
    struct surface rosette = {0}, frame = {0};
    add_rosette(&rosette);
    add_rosette_frame(&frame);
    add_to_side(&atrium->surfaces[RELIEF], &rosette, RELIEF_SIDE, 0.0f, middle, front);
    add_to_side(&atrium->surfaces[TRIM], &frame, RELIEF_SIDE, 0.0f, middle, front);
    surface_free(&rosette);
    surface_free(&frame);
    for (int end = -1; end <= 1; end += 2) {
        float x = 2.3f * (float)end;
        add_side_box(atrium, RIBS, RELIEF_SIDE, (const float[]){x - 0.3f, -0.05f, 0.0f},
                     (const float[]){x + 0.3f, 0.3f, front + 0.2f});
        add_side_box(atrium, RIBS, RELIEF_SIDE, (const float[]){x - 0.24f, 0.29f, 0.0f},
                     (const float[]){x + 0.24f, 3.95f, front + 0.14f});
        add_side_box(atrium, RIBS, RELIEF_SIDE, (const float[]){x - 0.3f, 3.94f, 0.0f},
                     (const float[]){x + 0.3f, GALLERY - 0.2f, front + 0.2f});
    }
}

/* --- furnishing ------------------------------------------------------------------------------- */

/* Red, green and blue in turn. */
static enum kind cloth_kind(int number) {
    return RED + (enum kind)(number % 3);
}

/* Under the arches of both long sides, hung from rods in front of the wall. */
static void add_curtains(struct atrium *atrium) {
    for (int number = 0; number < 7; number++) {
        int side = number % 2 ? 2 : 0;
        float x = bay_x(side, side ? 7.0f - (float)number : 1.0f + (float)number);
        struct surface cloth = {0};
        struct curtain curtain = {.width = 2.1f,
                                  .height = 3.1f,
                                  .folds = 7.0f,
                                  .depth = 0.085f,
                                  .waist = 0.62f,
                                  .gather = 0.55f,
                                  .phase = 0.37f * (float)number,
                                  .columns = 32,
                                  .rows = 14};
        add_curtain(&cloth, &curtain);
        add_to_side(&atrium->surfaces[cloth_kind(number)], &cloth, side, x, 4.2f, 0.5f);
        surface_free(&cloth);
        add_side_box(atrium, RODS, side, (const float[]){x - 1.15f, 4.2f, 0.485f},
                     (const float[]){x + 1.15f, 4.23f, 0.515f});
        for (int end = -1; end <= 1; end += 2)
            add_side_box(atrium, RODS, side,
                         (const float[]){x + (float)end * 1.1f - 0.015f, 4.19f, 0.2f},
                         (const float[]){x + (float)end * 1.1f + 0.015f, 4.24f, 0.54f});
    }
}

static void add_rail_cloths(struct atrium *atrium) {
    for (int number = 0; number < 6; number++) {
        int side = number % 2 ? 0 : 2;
        struct surface cloth = {0};
        struct rail_cloth hung = {.width = 1.5f,
                                  .drop = 0.7f,
                                  .rail_radius = 0.15f,
                                  .folds = 4.0f,
                                  .depth = 0.03f,
                                  .phase = 0.21f * (float)number,
                                  .columns = 20,
                                  .rows = 14};
        add_rail_cloth(&cloth, &hung);
        add_to_side(&atrium->surfaces[cloth_kind(number + 1)], &cloth, side,
                    bay_x(side, 1.0f + (float)number), GALLERY + RAIL - 0.13f, 0.0f);
        surface_free(&cloth);
    }
}

static void add_plants(struct atrium *atrium) {
    for (int number = 0; number < 8; number++) {
        int side = number % 2 ? 2 : 0;
        float x = bay_x(side, 0.5f + 2.0f * (float)(number / 2)), z = 0.95f;
        struct surface pot = {0}, leaves = {0};
        struct plant plant = {.leaves = 33,
                              .segments = 5,
                              .height = 1.15f,
                              .spread = 0.75f,
                              .leaf_width = 0.10f,
                              .seed = 100 * number};
        add_pot(&pot);
        add_plant(&leaves, &plant);
        add_to_side(&atrium->surfaces[POTS], &pot, side, x, 0.0f, z);
        add_to_side(&atrium->surfaces[LEAVES], &leaves, side, x, 0.55f, z);
        surface_free(&pot);
        surface_free(&leaves);
    }
}

static void add_furnishing(struct atrium *atrium) {
    add_curtains(atrium);
    add_rail_cloths(atrium);
    add_plants(atrium);
    struct surface fountain = {0};
    add_fountain(&fountain);
    add_copy(&atrium->surfaces[RELIEF], &fountain, 0, (const float[]){1.25f, 0.0f, 0.0f});
    surface_free(&fountain);
}

/* --- the whole -------------------------------------------------------------------------------- */

void make_atrium(struct glb *glb) {
    struct atrium atrium = {0};
    add_floor(&atrium);
    add_slabs(&atrium);
    add_lower_storey(&atrium);
    add_relief_wall(&atrium);
    add_upper_storey(&atrium);
    add_furnishing(&atrium);
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        glb_add_material(glb, kinds[kind].name, kinds[kind].albedo, kinds[kind].sides);
        glb_add_mesh(glb, kinds[kind].name, &atrium.surfaces[kind], kind, NULL);
        surface_free(&atrium.surfaces[kind]);
    }
    glb_add_camera(glb, (const float[]){-9.2f, 2.1f, 0.5f}, (const float[]){0.99f, 0.09f, -0.075f},
                   62.0, 0.1, 100.0);
    glb_add_spot(glb, (const float[]){-2.5f, 12.5f, 1.2f},
                 (const float[]){0.195f, -0.916f, -0.351f}, 24.0, 7000.0);
}
