/* Animated scenes: three creatures in the atrium [Dong 2009, Fig. 11], and a figure that walks. */
#include "moving/figure.h"
#include "scenes.h"

#define COUNT(table) ((int)(sizeof(table) / sizeof(table)[0]))

/* A four-legged grazer. Legs of one diagonal go together. */
static const struct figure_bone grazer_bones[] = {
    {"trunk", -1, {-0.45f, 1.0f, 0}, 0.24f, {0.45f, 1.02f, 0}, 0.26f, 0.1f, 'z', 0, 2, 0.1f},
    {"neck", 0, {0.50f, 1.10f, 0}, 0.17f, {0.86f, 1.52f, 0}, 0.11f, 0.12f, 'z', 0, 8, 0.2f},
    {"head", 1, {0.86f, 1.54f, 0}, 0.12f, {1.14f, 1.42f, 0}, 0.075f, 0.05f, 'z', -4, 6, 0.5f},
    {"tail", 0, {-0.62f, 1.08f, 0}, 0.06f, {-0.95f, 0.70f, 0}, 0.03f, 0.06f, 'x', 0, 25, 0.0f},
    {"near fore thigh",
     0,
     {0.40f, 0.85f, 0.15f},
     0.12f,
     {0.40f, 0.45f, 0.15f},
     0.065f,
     0.08f,
     'z',
     0,
     24,
     0.0f},
    {"near fore shin",
     4,
     {0.40f, 0.45f, 0.15f},
     0.06f,
     {0.42f, 0.05f, 0.15f},
     0.055f,
     0.03f,
     'z',
     -16,
     16,
     0.25f},
    {"off fore thigh",
     0,
     {0.40f, 0.85f, -0.15f},
     0.12f,
     {0.40f, 0.45f, -0.15f},
     0.065f,
     0.08f,
     'z',
     0,
     24,
     0.5f},
    {"off fore shin",
     6,
     {0.40f, 0.45f, -0.15f},
     0.06f,
     {0.42f, 0.05f, -0.15f},
     0.055f,
     0.03f,
     'z',
     -16,
     16,
     0.75f},
    {"near hind thigh",
     0,
     {-0.45f, 0.88f, 0.15f},
     0.15f,
     {-0.45f, 0.46f, 0.15f},
     0.075f,
     0.08f,
     'z',
     0,
     24,
     0.5f},
    {"near hind shin",
     8,
     {-0.45f, 0.46f, 0.15f},
     0.065f,
     {-0.47f, 0.05f, 0.15f},
     0.055f,
     0.03f,
     'z',
     14,
     14,
     0.75f},
    {"off hind thigh",
     0,
     {-0.45f, 0.88f, -0.15f},
     0.15f,
     {-0.45f, 0.46f, -0.15f},
     0.075f,
     0.08f,
     'z',
     0,
     24,
     0.0f},
    {"off hind shin",
     10,
     {-0.45f, 0.46f, -0.15f},
     0.065f,
     {-0.47f, 0.05f, -0.15f},
     0.055f,
     0.03f,
     'z',
     14,
     14,
     0.25f},
};

static const struct figure grazer = {
    .name = "grazer",
    .bones = grazer_bones,
    .bone_count = COUNT(grazer_bones),
    .cell = 0.035f,
    .faces = 2400,
    .cycle = 1.1f,
};

static const struct figure_bone walker_bones[] = {
    {"trunk", -1, {0, 1.00f, 0}, 0.17f, {0, 1.40f, 0}, 0.19f, 0.1f, 'y', 0, 7, 0.5f},
    {"head", 0, {0, 1.58f, 0}, 0.07f, {0.02f, 1.78f, 0}, 0.13f, 0.05f, 'z', 0, 4, 0.2f},
    {"left arm", 0, {0, 1.45f, 0.24f}, 0.085f, {0, 1.14f, 0.29f}, 0.055f, 0.06f, 'z', 0, 30, 0.5f},
    {"left forearm",
     2,
     {0, 1.14f, 0.29f},
     0.055f,
     {0, 0.86f, 0.30f},
     0.05f,
     0.03f,
     'z',
     22,
     14,
     0.5f},
    {"right arm",
     0,
     {0, 1.45f, -0.24f},
     0.085f,
     {0, 1.14f, -0.29f},
     0.055f,
     0.06f,
     'z',
     0,
     30,
     0.0f},
    {"right forearm",
     4,
     {0, 1.14f, -0.29f},
     0.055f,
     {0, 0.86f, -0.30f},
     0.05f,
     0.03f,
     'z',
     22,
     14,
     0.0f},
    {"left thigh", 0, {0, 0.94f, 0.11f}, 0.12f, {0, 0.52f, 0.12f}, 0.075f, 0.06f, 'z', 3, 27, 0.0f},
    {"left shin",
     6,
     {0, 0.52f, 0.12f},
     0.075f,
     {0, 0.09f, 0.12f},
     0.055f,
     0.03f,
     'z',
     -20,
     20,
     0.25f},
    {"left foot",
     7,
     {0, 0.07f, 0.12f},
     0.06f,
     {0.16f, 0.05f, 0.12f},
     0.045f,
     0.03f,
     'z',
     3,
     9,
     0.3f},
    {"right thigh",
     0,
     {0, 0.94f, -0.11f},
     0.12f,
     {0, 0.52f, -0.12f},
     0.075f,
     0.06f,
     'z',
     3,
     27,
     0.5f},
    {"right shin",
     9,
     {0, 0.52f, -0.12f},
     0.075f,
     {0, 0.09f, -0.12f},
     0.055f,
     0.03f,
     'z',
     -20,
     20,
     0.75f},
    {"right foot",
     10,
     {0, 0.07f, -0.12f},
     0.06f,
     {0.16f, 0.05f, -0.12f},
     0.045f,
     0.03f,
     'z',
     3,
     9,
     0.8f},
};

static const struct figure walker = {
    .name = "walker",
    .bones = walker_bones,
    .bone_count = COUNT(walker_bones),
    .cell = 0.018f,
    .faces = 4000,
    .cycle = 1.2f,
};

static const float seconds = 10.0f;

void make_creatures(struct glb *glb) {
    static const float times[] = {0, 5, 10};
    static const float big[][3] = {{-3.0f, 0, -1.0f}, {0.5f, 0, -1.6f}, {4.0f, 0, -1.0f}};
    static const float middle[][3] = {{3.0f, 0, 0.6f}, {0.0f, 0, 1.1f}, {-3.0f, 0, 0.4f}};
    static const float small[][3] = {{-4.5f, 0, 0.2f}, {-2.6f, 0, -0.2f}, {-0.6f, 0, 0.3f}};
    static const float there[] = {8, 0, -8}, back[] = {172, 180, 188}, straight[] = {4, -4, -10};
    make_atrium(glb);
    int ochre =
        glb_add_material(glb, "ochre", (const float[]){0.68f, 0.42f, 0.16f}, GLB_SINGLE_SIDED);
    int pale =
        glb_add_material(glb, "pale", (const float[]){0.80f, 0.76f, 0.70f}, GLB_SINGLE_SIDED);
    int moss =
        glb_add_material(glb, "moss", (const float[]){0.25f, 0.50f, 0.22f}, GLB_SINGLE_SIDED);
    add_figure(glb, &grazer, ochre, 1.7f, &(struct figure_path){3, times, big, there}, seconds);
    add_figure(glb, &grazer, pale, 1.2f, &(struct figure_path){3, times, middle, back}, seconds);
    add_figure(glb, &grazer, moss, 0.8f, &(struct figure_path){3, times, small, straight}, seconds);
}

/* Walks a triangle through the Cornell box. */
void make_character(struct glb *glb) {
    static const float times[] = {0, 3.0f, 3.6f, 6.4f, 7.0f, 9.4f, 10.0f};
    static const float places[][3] = {{-1.5f, 0, -1.2f}, {1.4f, 0, -1.2f}, {1.5f, 0, -1.0f},
                                      {0.1f, 0, 1.2f},   {-0.1f, 0, 1.2f}, {-1.5f, 0, -1.0f},
                                      {-1.5f, 0, -1.2f}};
    static const float headings[] = {0, 0, -122, -122, -238, -238, -360};
    add_cornell_room(glb);
    int clay =
        glb_add_material(glb, "clay", (const float[]){0.74f, 0.55f, 0.40f}, GLB_SINGLE_SIDED);
    add_figure(glb, &walker, clay, 1.7f, &(struct figure_path){7, times, places, headings},
               seconds);
    glb_add_spot(glb, (const float[]){-0.9f, 2.4f, 2.3f}, (const float[]){0.781f, 0.556f, -0.284f},
                 29.0, 500.0);
}
