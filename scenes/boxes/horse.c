#include "boxes/horse.h"

#include <cglm/cglm.h>
#include <stddef.h>

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const struct soft_frame body_frame = {
    {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};

/* --- trunk and neck --------------------------------------------------------------------------- */

static const struct muscle trunk[] = {
    {{0.12f, 1.20f, 0.0f}, {0.58f, 0.320f, 0.275f}, 3.0f, 0.0f},    /* ribs */
    {{0.47f, 1.22f, 0.0f}, {0.30f, 0.350f, 0.225f}, 0.0f, 0.15f},   /* chest */
    {{0.64f, 1.13f, 0.0f}, {0.15f, 0.190f, 0.190f}, 0.0f, 0.12f},   /* breast */
    {{-0.44f, 1.27f, 0.0f}, {0.36f, 0.285f, 0.255f}, -8.0f, 0.15f}, /* croup */
    {{-0.20f, 1.13f, 0.0f}, {0.35f, 0.230f, 0.230f}, -6.0f, 0.12f}, /* flank */
    {{0.34f, 1.49f, 0.0f}, {0.26f, 0.085f, 0.065f}, -8.0f, 0.12f},  /* withers */
};

/* Both sides. */
static const struct muscle quarters[] = {
    {{0.52f, 1.18f, 0.150f}, {0.15f, 0.27f, 0.085f}, -22.0f, 0.08f}, /* shoulder */
    {{0.46f, 1.00f, 0.150f}, {0.17f, 0.11f, 0.080f}, -20.0f, 0.08f}, /* upper arm */
    {{-0.50f, 1.17f, 0.125f}, {0.24f, 0.28f, 0.130f}, 12.0f, 0.10f}, /* thigh */
    {{-0.67f, 1.20f, 0.090f}, {0.12f, 0.22f, 0.095f}, 10.0f, 0.08f}, /* buttock */
};

static const struct bone neck[] = {
    {{0.46f, 1.28f, 0.00f}, 0.265f, {0.72f, 1.56f, 0.01f}, 0.215f, 0.66f, 0.16f},
    {{0.72f, 1.56f, 0.01f}, 0.215f, {0.90f, 1.82f, 0.03f}, 0.155f, 0.62f, 0.08f},
    {{0.90f, 1.82f, 0.03f}, 0.155f, {0.99f, 1.97f, 0.05f}, 0.115f, 0.66f, 0.06f},
};

/* --- legs ------------------------------------------------------------------------------------- */

static const struct bone fore_standing[] = {
    {{0.47f, 1.00f, -0.150f}, 0.105f, {0.46f, 0.80f, -0.150f}, 0.080f, 0.0f, 0.08f},
    {{0.46f, 0.80f, -0.150f}, 0.080f, {0.47f, 0.52f, -0.145f}, 0.050f, 0.0f, 0.04f},
    {{0.475f, 0.53f, -0.145f}, 0.054f, {0.475f, 0.48f, -0.145f}, 0.050f, 0.0f, 0.03f}, /* knee */
    {{0.47f, 0.50f, -0.145f}, 0.040f, {0.465f, 0.23f, -0.145f}, 0.033f, 0.0f, 0.04f},
    {{0.455f, 0.24f, -0.145f}, 0.043f, {0.46f, 0.20f, -0.145f}, 0.042f, 0.0f, 0.03f}, /* fetlock */
    {{0.465f, 0.20f, -0.145f}, 0.037f, {0.52f, 0.10f, -0.145f}, 0.042f, 0.0f, 0.03f},
};

static const struct bone fore_lifted[] = {
    {{0.50f, 1.00f, 0.150f}, 0.105f, {0.60f, 0.88f, 0.155f}, 0.082f, 0.0f, 0.08f},
    {{0.60f, 0.88f, 0.155f}, 0.080f, {0.79f, 0.74f, 0.155f}, 0.052f, 0.0f, 0.04f},
    {{0.79f, 0.75f, 0.155f}, 0.055f, {0.81f, 0.71f, 0.155f}, 0.050f, 0.0f, 0.03f},
    {{0.80f, 0.72f, 0.155f}, 0.041f, {0.69f, 0.47f, 0.150f}, 0.033f, 0.0f, 0.04f},
    {{0.68f, 0.47f, 0.150f}, 0.043f, {0.66f, 0.44f, 0.150f}, 0.042f, 0.0f, 0.03f},
    {{0.665f, 0.45f, 0.150f}, 0.036f, {0.58f, 0.37f, 0.150f}, 0.041f, 0.0f, 0.03f},
};

static const struct bone hind_back[] = {
    {{-0.44f, 1.08f, 0.150f}, 0.170f, {-0.42f, 0.90f, 0.160f}, 0.115f, 0.75f, 0.10f},
    {{-0.42f, 0.92f, 0.160f}, 0.115f, {-0.76f, 0.57f, 0.145f}, 0.052f, 0.80f, 0.06f},
    {{-0.77f, 0.60f, 0.145f}, 0.044f, {-0.76f, 0.52f, 0.145f}, 0.054f, 0.0f, 0.04f}, /* hock */
    {{-0.76f, 0.54f, 0.145f}, 0.046f, {-0.79f, 0.25f, 0.145f}, 0.036f, 0.0f, 0.04f},
    {{-0.80f, 0.25f, 0.145f}, 0.046f, {-0.79f, 0.21f, 0.145f}, 0.044f, 0.0f, 0.03f},
    {{-0.79f, 0.21f, 0.145f}, 0.038f, {-0.735f, 0.10f, 0.145f}, 0.042f, 0.0f, 0.03f},
};

static const struct bone hind_forward[] = {
    {{-0.42f, 1.08f, -0.150f}, 0.170f, {-0.30f, 0.90f, -0.160f}, 0.115f, 0.75f, 0.10f},
    {{-0.30f, 0.92f, -0.160f}, 0.115f, {-0.57f, 0.56f, -0.145f}, 0.052f, 0.80f, 0.06f},
    {{-0.59f, 0.59f, -0.145f}, 0.044f, {-0.57f, 0.51f, -0.145f}, 0.054f, 0.0f, 0.04f},
    {{-0.57f, 0.53f, -0.145f}, 0.046f, {-0.51f, 0.25f, -0.145f}, 0.036f, 0.0f, 0.04f},
    {{-0.52f, 0.25f, -0.145f}, 0.046f, {-0.51f, 0.21f, -0.145f}, 0.044f, 0.0f, 0.03f},
    {{-0.51f, 0.21f, -0.145f}, 0.038f, {-0.455f, 0.10f, -0.145f}, 0.042f, 0.0f, 0.03f},
};

/* From the coronet to the sole, which the ground cuts flat. */
static const struct bone hooves[] = {
    {{0.525f, 0.09f, -0.145f}, 0.048f, {0.555f, -0.02f, -0.145f}, 0.076f, 0.0f, 0.01f},
    {{0.575f, 0.365f, 0.150f}, 0.046f, {0.485f, 0.305f, 0.150f}, 0.066f, 0.0f, 0.01f},
    {{-0.73f, 0.09f, 0.145f}, 0.048f, {-0.70f, -0.02f, 0.145f}, 0.073f, 0.0f, 0.01f},
    {{-0.45f, 0.09f, -0.145f}, 0.048f, {-0.42f, -0.02f, -0.145f}, 0.073f, 0.0f, 0.01f},
};

/* --- head ------------------------------------------------------------------------------------- */

/* In the head's frame: the origin at the poll, x down to the muzzle, y forward. */
static const struct muscle skull[] = {
    {{0.10f, -0.010f, 0.0f}, {0.175f, 0.105f, 0.090f}, 0.0f, 0.07f},
    {{0.50f, -0.012f, 0.0f}, {0.080f, 0.060f, 0.058f}, 0.0f, 0.05f}, /* muzzle */
    {{0.49f, -0.068f, 0.0f}, {0.045f, 0.028f, 0.036f}, 0.0f, 0.03f}, /* chin */
};

static const struct bone face[] = {
    {{0.10f, 0.015f, 0.0f}, 0.078f, {0.48f, 0.002f, 0.0f}, 0.050f, 0.85f, 0.05f},  /* nose */
    {{0.16f, -0.075f, 0.0f}, 0.060f, {0.46f, -0.055f, 0.0f}, 0.036f, 0.9f, 0.05f}, /* jaw */
};

static const struct muscle cheeks[] = {
    {{0.160f, -0.065f, 0.042f}, {0.105f, 0.085f, 0.042f}, 0.0f, 0.04f},
    {{0.148f, 0.054f, 0.072f}, {0.056f, 0.024f, 0.028f}, -8.0f, 0.02f}, /* brow */
    {{0.160f, 0.024f, 0.082f}, {0.034f, 0.027f, 0.024f}, 0.0f, 0.006f}, /* eye */
    {{0.530f, 0.014f, 0.034f}, {0.030f, 0.030f, 0.026f}, 0.0f, 0.02f},  /* nostril */
};

static const struct bone ears[] = {
    {{0.000f, 0.035f, 0.045f}, 0.030f, {-0.085f, 0.055f, 0.068f}, 0.036f, 0.75f, 0.02f},
    {{-0.085f, 0.055f, 0.068f}, 0.036f, {-0.185f, 0.062f, 0.060f}, 0.008f, 0.75f, 0.01f},
};

static const struct muscle hollows[] = {
    {{-0.085f, 0.085f, 0.078f}, {0.070f, 0.022f, 0.018f}, -4.0f, 0.012f}, /* ear */
    {{0.545f, 0.016f, 0.056f}, {0.022f, 0.014f, 0.020f}, 30.0f, 0.006f},  /* nostril */
    {{0.530f, -0.047f, 0.042f}, {0.070f, 0.009f, 0.032f}, 4.0f, 0.006f},  /* mouth */
};

/* --- hair ------------------------------------------------------------------------------------- */

static const struct bone tail[] = {
    {{-0.74f, 1.42f, 0.00f}, 0.050f, {-0.86f, 1.44f, 0.01f}, 0.046f, 0.0f, 0.06f},
    {{-0.86f, 1.44f, 0.01f}, 0.048f, {-0.97f, 1.30f, 0.02f}, 0.062f, 0.0f, 0.02f},
    {{-0.97f, 1.30f, 0.02f}, 0.062f, {-1.02f, 1.02f, 0.03f}, 0.080f, 0.0f, 0.02f},
    {{-1.02f, 1.02f, 0.03f}, 0.080f, {-1.03f, 0.72f, 0.04f}, 0.070f, 0.0f, 0.02f},
    {{-1.03f, 0.72f, 0.04f}, 0.070f, {-1.08f, 0.42f, 0.04f}, 0.012f, 0.0f, 0.02f},
    {{-0.94f, 1.30f, 0.05f}, 0.040f, {-0.97f, 0.80f, 0.08f}, 0.045f, 0.0f, 0.01f},
    {{-0.97f, 0.80f, 0.08f}, 0.045f, {-0.98f, 0.50f, 0.07f}, 0.010f, 0.0f, 0.01f},
    {{-1.00f, 1.20f, -0.02f}, 0.040f, {-1.10f, 0.80f, -0.03f}, 0.045f, 0.0f, 0.01f},
    {{-1.10f, 0.80f, -0.03f}, 0.045f, {-1.16f, 0.52f, -0.02f}, 0.010f, 0.0f, 0.01f},
};

/* The crest of the neck from the withers to the poll; locks of the mane hang from it. */
static const float crest[][3] = {
    {0.46f, 1.575f, 0.00f}, {0.56f, 1.66f, 0.01f},  {0.66f, 1.765f, 0.015f},
    {0.75f, 1.88f, 0.02f},  {0.83f, 1.985f, 0.03f}, {0.92f, 2.06f, 0.045f},
};

static void add_lock(struct soft_body *horse, const float root[3], int number) {
    /* Locks fall to the near side and back, each a little different from its neighbours. */
    float wave = (float)(number % 3 - 1);
    float length = 0.24f + 0.03f * (float)(number % 2);
    struct bone upper = {.from_radius = 0.036f, .to_radius = 0.034f, .blend = 0.02f};
    struct bone lower = {.from_radius = 0.034f, .to_radius = 0.010f, .blend = 0.015f};
    glm_vec3_copy((float *)root, upper.from);
    glm_vec3_copy((vec3){root[0] - 0.045f, root[1] - 0.4f * length, root[2] + 0.115f}, upper.to);
    glm_vec3_copy(upper.to, lower.from);
    glm_vec3_copy(
        (vec3){root[0] - 0.10f + 0.012f * wave, root[1] - length, root[2] + 0.165f + 0.008f * wave},
        lower.to);
    soft_add_bone(horse, &body_frame, &upper, SOFT_ONE);
    soft_add_bone(horse, &body_frame, &lower, SOFT_ONE);
}

static void add_mane(struct soft_body *horse) {
    const int locks = 13;
    for (int i = 0; i < locks; i++) {
        float along = (float)i / (float)(locks - 1) * (float)(COUNT(crest) - 1);
        size_t k = glm_min(along, (float)COUNT(crest) - 1.001f);
        vec3 root;
        glm_vec3_lerp((float *)crest[k], (float *)crest[k + 1], along - (float)k, root);
        add_lock(horse, root, i);
    }
}

static const struct bone forelock[] = {
    {{-0.04f, 0.040f, 0.000f}, 0.036f, {0.05f, 0.105f, 0.012f}, 0.032f, 0.0f, 0.02f},
    {{0.05f, 0.105f, 0.012f}, 0.032f, {0.17f, 0.100f, 0.030f}, 0.008f, 0.0f, 0.01f},
};

/* --- the whole -------------------------------------------------------------------------------- */

static void add_bones(struct soft_body *horse, const struct soft_frame *frame,
                      const struct bone *bones, size_t count, enum soft_side side) {
    for (size_t i = 0; i < count; i++)
        soft_add_bone(horse, frame, &bones[i], side);
}

static void add_muscles(struct soft_body *horse, const struct soft_frame *frame,
                        const struct muscle *muscles, size_t count, enum soft_side side) {
    for (size_t i = 0; i < count; i++)
        soft_add_muscle(horse, frame, &muscles[i], side);
}

/* Nods and turns to the near side. */
static struct soft_frame head_frame(void) {
    const float nod = glm_rad(-58.0f), turn = glm_rad(16.0f);
    struct soft_frame frame = {.origin = {1.02f, 2.00f, 0.055f}};
    glm_vec3_copy((vec3){cosf(nod) * cosf(turn), sinf(nod), cosf(nod) * sinf(turn)}, frame.right);
    glm_vec3_copy((vec3){-sinf(nod) * cosf(turn), cosf(nod), -sinf(nod) * sinf(turn)}, frame.up);
    glm_vec3_cross(frame.right, frame.up, frame.front);
    return frame;
}

static void add_head(struct soft_body *horse) {
    struct soft_frame frame = head_frame();
    add_muscles(horse, &frame, skull, COUNT(skull), SOFT_ONE);
    add_bones(horse, &frame, face, COUNT(face), SOFT_ONE);
    add_muscles(horse, &frame, cheeks, COUNT(cheeks), SOFT_BOTH);
    add_bones(horse, &frame, ears, COUNT(ears), SOFT_BOTH);
    for (size_t i = 0; i < COUNT(hollows); i++)
        soft_carve(horse, &frame, &hollows[i], SOFT_BOTH);
    add_bones(horse, &frame, forelock, COUNT(forelock), SOFT_ONE);
}

void shape_horse(struct soft_body *horse) {
    horse->count = 0;
    add_muscles(horse, &body_frame, trunk, COUNT(trunk), SOFT_ONE);
    add_muscles(horse, &body_frame, quarters, COUNT(quarters), SOFT_BOTH);
    add_bones(horse, &body_frame, fore_standing, COUNT(fore_standing), SOFT_ONE);
    add_bones(horse, &body_frame, fore_lifted, COUNT(fore_lifted), SOFT_ONE);
    add_bones(horse, &body_frame, hind_back, COUNT(hind_back), SOFT_ONE);
    add_bones(horse, &body_frame, hind_forward, COUNT(hind_forward), SOFT_ONE);
    add_bones(horse, &body_frame, hooves, COUNT(hooves), SOFT_ONE);
    add_bones(horse, &body_frame, neck, COUNT(neck), SOFT_ONE);
    add_head(horse);
    add_mane(horse);
    add_bones(horse, &body_frame, tail, COUNT(tail), SOFT_ONE);
    /* The ground: a very large ellipsoid cuts the soles flat. */
    const struct muscle ground = {{0.0f, -2.0f, 0.0f}, {400.0f, 2.0f, 400.0f}, 0.0f, 0.0f};
    soft_carve(horse, &body_frame, &ground, SOFT_ONE);
}
