#include "lights/light_samples.h"

#include "base/halton.h"

#include <math.h>

static bool is_wide(const struct emitter *light, const struct light_samples_desc *desc) {
    float widest = fmaxf(light->size[0], light->size[1]);
    switch (emitter_shape(light)) {
    case EMITTER_IS_RECTANGLE:
    case EMITTER_IS_DISK:
        return widest > desc->wide * desc->radius;
    case EMITTER_IS_CAP:
        return widest > desc->wide;
    case EMITTER_IS_POINT:
    case EMITTER_IS_SPHERE: /* a few bits of its surface do not shine evenly all around */
        break;
    }
    return false;
}

void light_samples_choose_place(float place[2], int k, int n, int pass) {
    double half = .5 / n;
    double x = half + (double)k / n + radical_inverse(2, (uint32_t)pass);
    double y = half + radical_inverse(2, (uint32_t)k) + radical_inverse(3, (uint32_t)pass);
    place[0] = (float)(x - floor(x));
    place[1] = (float)(y - floor(y));
    for (int i = 0; i < 2; i++) /* what is next to 1 may be rounded to it */
        place[i] = fminf(place[i], 1 - 0x1p-24F);
}

static void add_pieces(struct light_samples *samples, const struct emitter *light, int n,
                       int pass) {
    samples->groups[samples->group_count++] = (struct light_group){samples->count, n};
    for (int k = 0; k < n; k++) {
        struct emitter *piece = &samples->items[samples->count++];
        float place[2];
        light_samples_choose_place(place, k, n, pass);
        *piece = n > 1 || pass > 0 ? emitter_piece(light, place) : *light;
        for (int c = 0; n > 1 && c < 3; c++)
            piece->intensity[c] /= (float)n;
    }
}

static void add_sky(struct light_samples *samples, const struct light_samples_sky *sky,
                    const struct environment *environment, int pass) {
    int count = sky->groups->count;
    float place[2];
    light_samples_choose_place(place, 0, 1, pass);
    samples->sky = count ? environment : NULL;
    if (count)
        samples->groups[samples->group_count++] = (struct light_group){samples->count, count};
    for (int i = 0; i < count; i++)
        samples->items[samples->count++] =
            pass > 0 ? sky_group_piece(sky->lights, sky->groups, i, environment, place)
                     : sky_group_emitter(sky->lights, sky->groups, i, environment);
}

static void add_many(struct light_samples *samples, double flux) {
    struct emitter many = emitter_new(EMITTER_MANY);
    for (int c = 0; c < 3; c++)
        many.intensity[c] = (float)flux;
    samples->groups[samples->group_count++] = (struct light_group){samples->count, 1};
    samples->items[samples->count++] = many;
}

struct emitters light_samples_emitters(struct light_samples *samples) {
    return (struct emitters){.items = samples->items, .count = samples->count, .sky = samples->sky};
}

struct light_layout light_samples_layout(struct light_samples *samples) {
    struct emitters emitters = light_samples_emitters(samples);
    struct light_layout layout;
    light_layout_count(&layout, &emitters);
    layout.groups = samples->group_count;
    layout.sized = false; /* samples have no size */
    return layout;
}

void light_samples_place(struct light_samples *samples, const struct emitters *emitters,
                         const struct light_samples_sky *sky, const struct light_samples_desc *desc,
                         int pass) {
    int wide = 0;
    for (int i = 0; i < emitters->count; i++)
        wide += is_wide(&emitters->items[i], desc);
    int each = wide > 0 && desc->count > wide ? desc->count / wide : 1;
    while (each > 1 &&
           emitters->count + sky->groups->count + desc->many + wide * (each - 1) > LIGHTS_MAX)
        each--;
    for (bool fits = false; !fits; each--) {
        samples->count = samples->group_count = 0;
        for (int i = 0; i < emitters->count; i++) {
            const struct emitter *light = &emitters->items[i];
            add_pieces(samples, light, is_wide(light, desc) ? each : 1, pass);
        }
        if (desc->many)
            add_many(samples, desc->flux);
        add_sky(samples, sky, emitters->sky, pass);
        struct light_layout layout = light_samples_layout(samples);
        fits = each == 1 || light_layout_fits(&layout);
    }
}
