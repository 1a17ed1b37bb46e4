/* The parts of `manylight bench MODE`. */
#ifndef LAB_BENCH_BENCH_H
#define LAB_BENCH_BENCH_H

#include "apps/arguments.h"
#include "lab/measure/results.h"
#include "lab/measure/reference.h"
#include "lab/measure/variants.h"
#include "apps/options.h"
#include "base/progress.h"

/* Values of the options of all modes; 0 for options that a mode lacks. */
struct bench_values {
    struct common_values common;
    struct context_desc context;
    struct text_list variants, settings, axes;
    const char *csv, *cache, *output, *reference_file, *picture;
    int size[2], frames, warm_up, passes, reference;
    float noise;
    bool tracer, estimates, whole_frames;
    struct stage_desc stage; /* without a path */
};

enum { BENCH_OWN_MAX = 8 };

/* Progress of a run. */
struct bench_work {
    struct progress progress;
    int part;     /* index of the argument */
    int first;    /* its first subject */
    int expected; /* number of its subjects; 0: unknown */
    int printed;  /* number of subjects in the first table so far */
    int last;     /* subject that results_print printed last */
};

/* A run of a mode. */
struct bench {
    const struct bench_mode *mode;
    struct bench_values values;
    const char **arguments; /* scenes, or what the mode takes instead */
    int argument_count;
    char *own_scenes[BENCH_OWN_MAX]; /* arguments that the user did not give */
    struct context *context;         /* current */
    struct stage *stage;             /* current scene; NULL while arguments are checked */
    struct results results;          /* written to --csv as they are measured */
    struct bench_work work;
};

enum { BENCH_TABLES_MAX = 3 };

struct bench_mode {
    const char *name;
    const char *help;      /* `bench --help` prints its first line, the mode's --help all */
    const char *arguments; /* NULL: "[SCENE ...]" */
    const char *options;   /* names of its options, separated by spaces */
    /* Variants without --variant, NULL: the defaults alone; scenes if none is named, NULL: the
     * paper's. Both end with NULL. */
    const char *const *variants, *const *scenes;
    bool (*check)(struct bench *bench); /* checks arguments; NULL: they are scenes */
    /* Measures one scene, a subject for each variant at each point of --vary; NULL: no scenes. */
    bool (*measure)(struct bench *bench, const struct measure_list *subjects);
    /* Ends with a table without a title. Rows of the first table are printed as they are measured,
     * the others after each scene. */
    struct table tables[BENCH_TABLES_MAX + 1];
    bool (*finish)(struct bench *bench); /* runs after the last scene; NULL: nothing */
    bool (*judge)(struct bench *bench);  /* checks results after --csv is written; NULL: nothing */
};

extern const struct bench_mode bench_times, bench_sweep, bench_budget, bench_curves, bench_passes,
    bench_quality, bench_temporal, bench_failures, bench_direct;

/* Measures and prints everything, and writes --csv. Error: a file, scene or renderer failed. */
bool bench_run(struct bench *bench, const struct bench_mode *mode);

/* Options of modes that use OpenGL. */
#define BENCH_CONTEXT " csv context device screen-passes gl-debug"

/* "paper" and "fast", null-terminated. */
extern const char *const bench_variants[];

/* Adds an argument, for check. */
void bench_add_argument(struct bench *bench, const char *argument);

/* Makes a subject of the current scene: the variant, with size and settings of the options over it.
 * Error: names the variant or setting. */
bool bench_prepare(const struct bench *bench, const char *variant, struct measure_desc *desc);

/* Makes a subject for each variant (of --variant, or else `variants`) at each point of --vary and
 * of `axis`; NULL: no axis. Error: names the variant or setting; the caller frees the list. */
bool bench_list(const struct bench *bench, const char *const *variants, const char *axis,
                struct measure_list *list);

/* Begin an argument, and set the number of its subjects, for progress. */
void bench_begin_part(struct bench *bench, int part);
void bench_expect(struct bench *bench, int subjects);

/* Returns the reference of this kind; measures time and errors against it. */
struct reference_desc bench_reference(const struct bench *bench, enum reference_kind kind);
bool bench_time(struct bench *bench, const struct measure_list *subjects, enum reference_kind kind);

#endif
