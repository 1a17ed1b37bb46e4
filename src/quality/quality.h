/* Chooses settings by the quality or error that the user requires.
 *
 * A quality is a named choice: the same settings on every machine. For a required error, a ladder
 * of choices is climbed from cheap to expensive. The first choice whose estimated error
 * (quality/estimate.h) for this scene and camera is small enough is taken. The order is fixed and
 * depends on no clock. */
#ifndef QUALITY_QUALITY_H
#define QUALITY_QUALITY_H

#include "quality/measure.h"

enum quality { QUALITY_DRAFT, QUALITY_NORMAL, QUALITY_HIGH, QUALITY_FINAL };

/* Names for option tables: "draft", "normal", "high", "final", NULL. */
extern const char *const quality_names[];

struct quality_choice {
    const char *settings;  /* text for renderer_settings_assign; "": unchanged */
    int passes;            /* passes of renderer_add_pass */
    const char *technique; /* NULL: unchanged */
    int samples;           /* path-traced per pixel (quality/traced.h); 0: frames */
};

/* One frame, by the current technique. */
#define QUALITY_FRAME(settings_text)                                                               \
    { .settings = (settings_text), .passes = 1 }

#define QUALITY_TRACED(samples_per_pixel)                                                          \
    { .settings = "", .passes = 1, .samples = (samples_per_pixel) }

/* Returns the choice of a quality. */
struct quality_choice quality_named(enum quality quality);

/* Returns "path=high", "64 passes", "8 path-traced samples" or "cluster-lights
 * picture.samples=16". The caller frees it. */
char *quality_describe(const struct quality_choice *choice);

/* Default limit of passes, and maximum of choices in a ladder. */
enum { QUALITY_MOST_PASSES = 256, QUALITY_CHOICES_MAX = 20 };

/* Fills the ladder, cheapest first: frames and path-traced pictures, then means of up to
 * most_passes. Returns the number of choices. */
int quality_ladder(struct quality_choice choices[QUALITY_CHOICES_MAX], int most_passes);

struct quality_desc {
    /* Stage, size, technique and direct method; the settings are ignored. */
    const struct measure_desc *measure;
    /* Given settings, which override the choice: texts for renderer_settings_assign. */
    const char *const *texts;
    int text_count;
    double error;       /* required relative RMSE of the indirect layer (quality/estimate.h) */
    int most_passes;    /* maximum of passes; 1: single frames only */
    bool any_technique; /* false: only the technique of measure */
    bool traces;        /* true: path-traced pictures, too, where quality/traced.h has them */
};

struct quality_found {
    struct quality_choice choice;
    double error; /* estimated error */
    bool reached; /* true: error is small enough; false: this is near the least error */
    /* Picture of a path-traced choice, if it was the last one that was tried; else zeroed. The
     * caller frees it. */
    struct image picture;
};

/* Estimates the error of a choice; infinity: it is impossible. Called cheapest first. Error: no
 * estimate. */
typedef bool quality_teller(void *user, const struct quality_choice *choice, double *error);

/* Climbs the ladder to the first choice with at most this error. If there is none, takes the
 * cheapest choice within a tenth of the least error. Means end if twice the passes gain less than a
 * tenth. Error: that of `tell`. */
bool quality_climb(double error, int most_passes, quality_teller *tell, void *user,
                   struct quality_found *found);

/* Climbs the ladder by rendering. Needs a current context. Error: as of the path tracer or a
 * renderer. */
bool quality_find(const struct quality_desc *desc, struct quality_found *found);

/* Returns the technique of the choice, else the given one. */
const struct technique *quality_technique(const struct quality_choice *choice,
                                          const struct technique *given);

/* True if the given settings contain a preset, path=. */
bool quality_is_preset(const char *const *texts, int count);

/* Makes the settings of a choice for a technique. Given settings override the choice; a given path=
 * replaces it. Error: a name or a value, or the technique lacks the preset. */
bool quality_settings(const struct quality_choice *choice, const struct technique *technique,
                      const char *const *texts, int count, struct settings *settings);

#endif
