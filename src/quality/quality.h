/* How a picture is made where the user names no settings, but how good it has to be.
 *
 * Qualities are choices by name: the same settings on every machine. An error asked for is looked for on a ladder of
 * choices, each dearer than the one before: the first whose picture errs no more is taken, as estimate.h tells it of this
 * very scene and camera. The ladder's order is fixed: it depends on no clock of the run.
 */
#ifndef QUALITY_QUALITY_H
#define QUALITY_QUALITY_H

#include "quality/measure.h"

enum quality { QUALITY_DRAFT, QUALITY_NORMAL, QUALITY_HIGH, QUALITY_FINAL };

/* For option tables: "draft", "normal", "high", "final", NULL. */
extern const char *const quality_names[];

struct quality_choice {
    const char *settings;  /* as renderer_settings_assign's; "" = as they are */
    int passes;            /* of renderer_add_pass */
    const char *technique; /* NULL: as it is */
    int samples; /* of a pixel, path-traced in place of frames (quality/traced.h); 0: frames */
};

/* One frame, by the technique as it is. */
#define QUALITY_FRAME(settings_text)                                                               \
    { .settings = (settings_text), .passes = 1 }

#define QUALITY_TRACED(samples_per_pixel)                                                          \
    { .settings = "", .passes = 1, .samples = (samples_per_pixel) }

struct quality_choice quality_named(enum quality quality);

/* "path=high", "64 passes", "8 path-traced samples", "cluster-lights picture.samples=16"; the caller frees it. */
char *quality_describe(const struct quality_choice *choice);

/* Where a ladder ends that nothing else ends. */
enum { QUALITY_MOST_PASSES = 256, QUALITY_CHOICES_MAX = 20 };

/* Fills in the ladder, cheapest first: frames and path-traced pictures, then means of up to most_passes. Returns their
 * number. */
int quality_ladder(struct quality_choice choices[QUALITY_CHOICES_MAX], int most_passes);

struct quality_desc {
    /* Stage, size, technique and direct method; its settings do not count. */
    const struct measure_desc *measure;
    const char *const *texts; /* settings that are given, and win: as renderer_settings_assign's */
    int text_count;
    double error;       /* relative RMSE of the indirect layer, as estimate.h has it */
    int most_passes;    /* of a picture; 1: no means */
    bool any_technique; /* else the measure's alone */
    bool traces;        /* path-traced pictures, too, where quality/traced.h has them */
};

struct quality_found {
    struct quality_choice choice;
    double error; /* as estimated */
    bool reached; /* else nothing errs much less */
};

/* Tells the error of a choice; infinity: it cannot be made. They are asked for cheapest first. Error: there is no telling. */
typedef bool quality_teller(void *user, const struct quality_choice *choice, double *error);

/* Up the ladder to the first choice that errs no more than asked for. Where none does, the cheapest of those that
 * nothing errs less than by a tenth; means end where twice as many passes gain less than that. Error: the teller's. */
bool quality_climb(double error, int most_passes, quality_teller *tell, void *user,
                   struct quality_found *found);

/* With a context. Error: of the tracer or a renderer. */
bool quality_find(const struct quality_desc *desc, struct quality_found *found);

/* That of the choice, else the given one. */
const struct technique *quality_technique(const struct quality_choice *choice,
                                          const struct technique *given);

/* Whether settings that are given name a preset, path=. */
bool quality_is_preset(const char *const *texts, int count);

/* The settings of a choice for a technique, but for those that are given; a path= among those takes the choice's place. Error: of a
 * name or a value, or the technique has no such preset. */
bool quality_settings(const struct quality_choice *choice, const struct technique *technique,
                      const char *const *texts, int count, struct settings *settings);

#endif
