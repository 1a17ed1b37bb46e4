#include "atrium/masonry.h"
#include "atrium/pieces.h"
#include "shapes/shapes.h"

#define COUNT(table) ((int)(sizeof(table) / sizeof(table)[0]))

/* A box of half widths x and z between two heights. */
static void add_slab(struct surface *surface, float half_x, float half_z, float low, float high) {
    add_box(surface, (const float[]){-half_x, low, -half_z}, (const float[]){half_x, high, half_z});
}

/* --- columns ---------------------------------------------------------------------------------- */

static const struct lathe_point shaft[] = {
    {0.000f, 0.14f, 0}, {0.285f, 0.14f, 0}, {0.303f, 0.165f, 0}, {0.303f, 0.195f, 0},
    {0.285f, 0.22f, 0}, {0.250f, 0.23f, 0}, {0.243f, 0.260f, 0}, {0.258f, 0.280f, 0},
    {0.268f, 0.30f, 0}, {0.258f, 0.32f, 0}, {0.232f, 0.330f, 0}, {0.236f, 1.000f, 0},
    {0.230f, 1.70f, 0}, {0.212f, 2.44f, 0}, {0.234f, 2.450f, 0}, {0.240f, 2.475f, 0},
    {0.212f, 2.50f, 0}, {0.000f, 2.50f, 0},
};

/* Two rows of leaves, made by lobes of the bell. */
static const struct lathe_point capital[] = {
    {0.000f, 2.49f, 0.00f}, {0.210f, 2.49f, 0.00f}, {0.232f, 2.56f, 0.05f}, {0.262f, 2.63f, 0.09f},
    {0.292f, 2.67f, 0.13f}, {0.262f, 2.68f, 0.05f}, {0.258f, 2.74f, 0.05f}, {0.290f, 2.80f, 0.10f},
    {0.332f, 2.84f, 0.10f}, {0.310f, 2.87f, 0.03f}, {0.000f, 2.87f, 0.00f},
};

void add_column_shaft(struct surface *surface) {
    add_lathe(surface, shaft, COUNT(shaft), 16, 0);
}

void add_column_ends(struct surface *surface) {
    add_slab(surface, 0.32f, 0.32f, 0.0f, 0.14f);
    add_lathe(surface, capital, COUNT(capital), 28, 7);
    add_slab(surface, 0.33f, 0.33f, 2.865f, 2.93f);
    add_slab(surface, 0.36f, 0.36f, 2.93f, SPRING);
}

/* Square, at the corners of the court. */
void add_pier(struct surface *surface) {
    add_slab(surface, 0.40f, 0.40f, 0.0f, 0.20f);
    add_slab(surface, 0.36f, 0.36f, 0.19f, 0.28f);
    add_slab(surface, 0.32f, 0.32f, 0.27f, 2.75f);
    add_slab(surface, 0.36f, 0.36f, 2.74f, 2.88f);
    add_slab(surface, 0.40f, 0.40f, 2.87f, SPRING);
}

/* A little thinner than the walls, whose faces would else coincide with its own. */
void add_lower_corner(struct surface *surface) {
    add_slab(surface, 0.5f * ARCADE_DEPTH - 0.005f, 0.5f * ARCADE_DEPTH - 0.005f, SPRING - 0.01f,
             GALLERY - 0.05f);
}

void add_upper_pier(struct surface *surface) {
    add_slab(surface, 0.18f, 0.18f, 0.99f, 2.3f);
    add_slab(surface, 0.22f, 0.22f, 2.29f, UPPER_SPRING);
    add_slab(surface, 0.5f * UPPER_DEPTH - 0.005f, 0.5f * UPPER_DEPTH - 0.005f, 2.44f,
             EAVES - GALLERY);
}

/* The upper columns stand on the pedestals of the balustrade. */
static const struct lathe_point upper_shaft[] = {
    {0.000f, 1.00f, 0}, {0.185f, 1.00f, 0}, {0.195f, 1.02f, 0}, {0.185f, 1.05f, 0},
    {0.150f, 1.06f, 0}, {0.165f, 1.09f, 0}, {0.140f, 1.11f, 0}, {0.143f, 1.50f, 0},
    {0.124f, 2.08f, 0}, {0.142f, 2.09f, 0}, {0.124f, 2.12f, 0}, {0.000f, 2.12f, 0},
};

static const struct lathe_point upper_capital[] = {
    {0.000f, 2.11f, 0.00f}, {0.122f, 2.11f, 0.00f}, {0.145f, 2.18f, 0.07f},
    {0.185f, 2.25f, 0.13f}, {0.205f, 2.34f, 0.10f}, {0.000f, 2.35f, 0.00f},
};

void add_pedestal(struct surface *surface) {
    add_slab(surface, 0.24f, 0.24f, 0.0f, 0.12f);
    add_slab(surface, 0.20f, 0.20f, 0.11f, 0.86f);
    add_slab(surface, 0.25f, 0.25f, 0.85f, 1.0f);
}

void add_upper_column(struct surface *surface) {
    add_lathe(surface, upper_shaft, COUNT(upper_shaft), 12, 0);
}

void add_upper_capital(struct surface *surface) {
    add_lathe(surface, upper_capital, COUNT(upper_capital), 24, 6);
    add_slab(surface, 0.235f, 0.235f, 2.345f, UPPER_SPRING);
}

/* --- arches ----------------------------------------------------------------------------------- */

static const struct arch_wall lower_arch = {
    .width = PITCH,
    .low = SPRING,
    .high = GALLERY - 0.05f,
    .thickness = ARCADE_DEPTH,
    .half_opening = 0.98f,
    .spring = SPRING,
    .rise = 0.98f,
    .segments = 20,
};

static const struct arch_wall upper_arch = {
    .width = PITCH,
    .low = UPPER_SPRING,
    .high = EAVES - GALLERY,
    .thickness = UPPER_DEPTH,
    .half_opening = 1.04f,
    .spring = UPPER_SPRING,
    .rise = 1.04f,
    .segments = 20,
};

/* Two steps; begins in the wall. */
static const float archivolt[][2] = {{0.02f, -0.02f}, {0.19f, -0.02f}, {0.19f, 0.07f},
                                     {0.13f, 0.07f},  {0.09f, 0.045f}, {0.02f, 0.045f}};

static void add_face_archivolt(struct surface *surface, const struct arch_wall *wall) {
    float profile[COUNT(archivolt)][2];
    for (int i = 0; i < COUNT(archivolt); i++) {
        profile[i][0] = archivolt[i][0];
        profile[i][1] = archivolt[i][1] + 0.5f * wall->thickness;
    }
    add_archivolt(surface, wall, (const float(*)[2])profile, COUNT(archivolt));
}

void add_lower_arch(struct surface *surface) {
    add_arch_wall(surface, &lower_arch);
}

void add_lower_archivolt(struct surface *surface) {
    add_face_archivolt(surface, &lower_arch);
}

void add_upper_arch(struct surface *surface) {
    add_arch_wall(surface, &upper_arch);
}

void add_upper_archivolt(struct surface *surface) {
    add_face_archivolt(surface, &upper_arch);
}

void add_aisle_vault(struct surface *surface, float half_x, float half_z) {
    const struct groin_vault vault = {half_x, half_z, 1.2f, GALLERY - 0.08f - SPRING, 12};
    add_groin_vault(surface, &vault);
}

static const struct arch_wall rib = {
    .width = AISLE,
    .low = SPRING,
    .high = GALLERY - 0.12f,
    .thickness = 0.4f,
    .half_opening = 0.5f * AISLE - 0.27f,
    .spring = SPRING,
    .rise = 1.08f,
    .segments = 16,
};

/* Between two vaults, on a pilaster at the outer wall. */
void add_aisle_rib(struct surface *surface) {
    struct surface arch = {0};
    add_arch_wall(&arch, &rib);
    add_copy(surface, &arch, 1, (const float[]){0.0f, 0.0f, 0.0f});
    surface_free(&arch);
    const float z = -0.5f * AISLE - 0.1f;
    add_box(surface, (const float[]){-0.25f, -0.1f, z}, (const float[]){0.25f, 0.25f, z + 0.4f});
    add_box(surface, (const float[]){-0.2f, 0.24f, z}, (const float[]){0.2f, 2.8f, z + 0.35f});
    add_box(surface, (const float[]){-0.25f, 2.79f, z}, (const float[]){0.25f, SPRING, z + 0.4f});
}

static const struct arch_wall door_wall = {
    .width = PITCH,
    .low = 0.0f,
    .high = SPRING + 1.4f,
    .thickness = 0.35f,
    .half_opening = 0.72f,
    .spring = 1.8f,
    .rise = 0.72f,
    .segments = 16,
};

void add_door_wall(struct surface *surface) {
    add_arch_wall(surface, &door_wall);
}

/* Two leaves of three panels each. */
void add_door(struct surface *surface) {
    add_box(surface, (const float[]){-0.75f, 0.0f, -0.06f}, (const float[]){0.75f, 2.55f, 0.0f});
    for (int leaf = 0; leaf < 2; leaf++)
        for (int panel = 0; panel < 3; panel++) {
            float x = leaf ? 0.06f : -0.66f, y = 0.12f + 0.6f * (float)panel;
            add_box(surface, (const float[]){x, y, -0.01f},
                    (const float[]){x + 0.6f, y + 0.5f, 0.03f});
        }
}

/* --- balustrade ------------------------------------------------------------------------------- */

static const struct lathe_point baluster[] = {
    {0.000f, 0.10f, 0}, {0.062f, 0.10f, 0}, {0.062f, 0.15f, 0},
    {0.034f, 0.19f, 0}, {0.062f, 0.34f, 0}, {0.032f, 0.66f, 0},
    {0.055f, 0.75f, 0}, {0.055f, 0.82f, 0}, {0.000f, 0.82f, 0},
};

void add_balusters(struct surface *surface) {
    enum { BALUSTERS = 6 };
    struct surface one = {0};
    add_lathe(&one, baluster, COUNT(baluster), 7, 0);
    for (int i = 0; i < BALUSTERS; i++) {
        float x = ((float)i - 0.5f * (BALUSTERS - 1)) * 0.31f;
        add_copy(surface, &one, 0, (const float[]){x, 0.0f, 0.0f});
    }
    surface_free(&one);
}

void add_rail(struct surface *surface) {
    static const float profile[][2] = {{-0.13f, 0.81f},       {0.09f, 0.81f}, {0.13f, 0.84f},
                                       {0.13f, RAIL - 0.03f}, {0.10f, RAIL},  {-0.10f, RAIL},
                                       {-0.13f, RAIL - 0.03f}};
    add_moulding(surface, profile, COUNT(profile), PITCH - 0.36f);
    add_slab(surface, 0.5f * PITCH - 0.18f, 0.12f, 0.0f, 0.11f);
}

/* --- mouldings and roof ----------------------------------------------------------------------- */

void add_string_course(struct surface *surface, float length) {
    static const float profile[][2] = {{-0.05f, 0.0f}, {0.04f, 0.0f},  {0.05f, 0.06f},
                                       {0.11f, 0.10f}, {0.14f, 0.13f}, {0.18f, 0.17f},
                                       {0.18f, 0.26f}, {-0.05f, 0.27f}};
    add_moulding(surface, profile, COUNT(profile), length);
}

void add_cornice(struct surface *surface, float length) {
    static const float profile[][2] = {{-0.05f, 0.0f}, {0.05f, 0.0f},  {0.06f, 0.06f},
                                       {0.12f, 0.10f}, {0.20f, 0.16f}, {0.28f, 0.23f},
                                       {0.32f, 0.27f}, {0.32f, 0.33f}, {-0.05f, 0.36f}};
    add_moulding(surface, profile, COUNT(profile), length);
}

/* Falls towards the court. */
void add_roof(struct surface *surface, float length) {
    static const float profile[][2] = {{0.5f, 0.0f}, {0.5f, 0.09f}, {-3.9f, 1.35f}, {-3.9f, 1.2f}};
    add_moulding(surface, profile, COUNT(profile), length);
}

/* --- ornaments -------------------------------------------------------------------------------- */

/* Turned about y, then laid over so that its top faces the court. */
static void add_facing_court(struct surface *surface, const struct surface *piece) {
    uint32_t first = surface->vertex_count;
    for (uint32_t i = 0; i < piece->vertex_count; i++) {
        const float *p = piece->position[i], *n = piece->normal[i];
        surface_add_vertex(surface, (const float[]){p[0], -p[2], p[1]},
                           (const float[]){n[0], -n[2], n[1]});
    }
    for (uint32_t i = 0; i < piece->index_count; i += 3)
        surface_add_triangle(surface, first + piece->indices[i], first + piece->indices[i + 1],
                             first + piece->indices[i + 2]);
}

/* From the rim to the heart: a ring, two wreaths of petals, a bud. */
static const struct lathe_point rosette[] = {
    {0.00f, -0.05f, 0.00f}, {1.22f, -0.05f, 0.00f}, {1.22f, 0.10f, 0.00f},  {1.17f, 0.14f, 0.00f},
    {1.10f, 0.14f, 0.00f},  {1.06f, 0.09f, 0.00f},  {1.02f, 0.03f, 0.00f},  {0.92f, 0.05f, 0.07f},
    {0.86f, 0.11f, 0.08f},  {0.74f, 0.14f, 0.07f},  {0.60f, 0.09f, 0.04f},  {0.54f, 0.08f, -0.08f},
    {0.48f, 0.15f, -0.12f}, {0.38f, 0.19f, -0.10f}, {0.26f, 0.13f, -0.04f}, {0.21f, 0.11f, 0.00f},
    {0.20f, 0.19f, 0.03f},  {0.14f, 0.25f, 0.05f},  {0.07f, 0.28f, 0.03f},  {0.00f, 0.29f, 0.00f},
};

void add_rosette(struct surface *surface) {
    struct surface turned = {0};
    add_lathe(&turned, rosette, COUNT(rosette), 84, 12);
    add_facing_court(surface, &turned);
    surface_free(&turned);
}

void add_rosette_frame(struct surface *surface) {
    static const float profile[][2] = {{-0.05f, -0.15f}, {0.06f, -0.15f}, {0.12f, -0.08f},
                                       {0.12f, 0.05f},   {0.07f, 0.15f},  {-0.05f, 0.15f}};
    struct surface bar = {0};
    add_moulding(&bar, profile, COUNT(profile), 3.0f);
    add_copy(surface, &bar, 0, (const float[]){0.0f, 1.5f, 0.0f});
    add_copy(surface, &bar, 0, (const float[]){0.0f, -1.5f, 0.0f});
    for (int side = -1; side <= 1; side += 2)
        add_box(surface, (const float[]){(float)side * 1.5f - 0.15f, -1.65f, -0.05f},
                (const float[]){(float)side * 1.5f + 0.15f, 1.65f, 0.13f});
    surface_free(&bar);
}

static const struct lathe_point pot[] = {
    {0.00f, 0.00f, 0}, {0.20f, 0.00f, 0}, {0.22f, 0.04f, 0}, {0.17f, 0.09f, 0},
    {0.27f, 0.25f, 0}, {0.31f, 0.42f, 0}, {0.29f, 0.52f, 0}, {0.33f, 0.56f, 0},
    {0.34f, 0.62f, 0}, {0.29f, 0.62f, 0}, {0.27f, 0.55f, 0}, {0.00f, 0.57f, 0},
};

void add_pot(struct surface *surface) {
    add_lathe(surface, pot, COUNT(pot), 14, 0);
}

/* A basin with a bowl on a stem. */
static const struct lathe_point basin[] = {
    {0.00f, 0.00f, 0}, {1.12f, 0.00f, 0}, {1.12f, 0.08f, 0}, {1.02f, 0.12f, 0}, {1.02f, 0.34f, 0},
    {1.10f, 0.38f, 0}, {1.10f, 0.46f, 0}, {0.92f, 0.46f, 0}, {0.90f, 0.30f, 0}, {0.20f, 0.28f, 0},
    {0.16f, 0.40f, 0}, {0.10f, 0.52f, 0}, {0.09f, 0.78f, 0}, {0.14f, 0.86f, 0}, {0.36f, 0.94f, 0},
    {0.52f, 1.06f, 0}, {0.54f, 1.12f, 0}, {0.50f, 1.12f, 0}, {0.34f, 1.02f, 0}, {0.08f, 0.99f, 0},
    {0.06f, 1.20f, 0}, {0.09f, 1.28f, 0}, {0.05f, 1.36f, 0}, {0.00f, 1.38f, 0},
};

void add_fountain(struct surface *surface) {
    add_lathe(surface, basin, COUNT(basin), 36, 0);
}
