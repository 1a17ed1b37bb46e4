/* The parts of `manylight bench MODE`. */
#ifndef LAB_BENCH_BENCH_H
#define LAB_BENCH_BENCH_H

#include "apps/arguments.h"
#include "lab/measure/results.h"
#include "lab/measure/reference.h"
#include "lab/measure/variants.h"
#include "apps/options.h"
#include "base/progress.h"

/* Of all modes; those that a mode has not are zero. */
struct bench_values {
    struct common_values common;
    struct context_desc context;
    struct text_list variants, settings, axes;
    const char *csv, *cache, *output, *reference_file, *picture;
    int size[2], frames, warm_up, passes, reference;
    float noise;
    bool tracer, tables, estimates, whole_frames;
    struct stage_desc stage; /* without a path */
};

enum { BENCH_OWN_MAX = 8 };

/* How far a run is. */
struct bench_work {
    struct progress progress;
    int part;     /* of the arguments */
    int first;    /* its first subject */
    int expected; /* its subjects; 0 = nobody knows yet */
    int printed;  /* subjects that the first table has had */
    int last;     /* that results_print printed last */
};

/* A run of a mode. */
struct bench {
    const struct bench_mode *mode;
    struct bench_values values;
    const char **arguments; /* scenes, or what the mode takes instead */
    int argument_count;
    char *own_scenes[BENCH_OWN_MAX]; /* those of the arguments that nobody gave */
    struct context *context;         /* current */
    struct stage *stage;             /* the present scene; NULL while arguments are tried */
    struct results results;          /* go to --csv as they are measured */
    struct bench_work work;
};

enum { BENCH_TABLES_MAX = 3 };

struct bench_mode {
    const char *name;
    const char *help;      /* its first line stands in `bench --help`, all of it in its own */
    const char *arguments; /* NULL = "[SCENE ...]" */
    const char *options;   /* the names of those that it has, with spaces between */
    /* What is compared unless --variant says otherwise, NULL = the defaults alone; and the scenes
     * where none is named, NULL = the paper's. Both end with NULL. */
    const char *const *variants, *const *scenes;
    bool (*check)(struct bench *bench); /* arguments that are no scenes; NULL where they are */
    /* Each scene, with a subject for each variant at each point of --vary. */
    bool (*measure)(struct bench *bench, const struct measure_list *subjects);
    /* Up to one of no title: a line of the first as soon as it is measured, the others after each
     * scene. */
    struct table tables[BENCH_TABLES_MAX + 1];
    bool (*finish)(struct bench *bench); /* after the last scene; NULL = nothing is left to do */
    bool (*judge)(struct bench *bench);  /* after --csv is written; NULL = nothing can be wrong */
};

extern const struct bench_mode bench_times, bench_sweep, bench_budget, bench_curves, bench_passes,
    bench_quality, bench_temporal, bench_failures, bench_direct, bench_caustics;

/* Measures and prints all, and writes --csv. Error: of a file, a scene or a renderer. */
bool bench_run(struct bench *bench, const struct bench_mode *mode);

/* The options of modes that use OpenGL. */
#define BENCH_CONTEXT " csv context device screen-passes gl-debug"

/* paper and fast. */
extern const char *const bench_variants[];

/* For check, where none is given. */
void bench_add_argument(struct bench *bench, const char *argument);

/* A subject of the present scene, with the options' size and settings over a variant's. Error: of
 * the variant or a setting. */
bool bench_prepare(const struct bench *bench, const char *variant, struct measure_desc *desc);

/* A subject for each of the variants (--variant, or those) at each point of --vary and of one axis
 * more, unless that is NULL. Error: of a variant or a setting; the list is to be freed. */
bool bench_list(const struct bench *bench, const char *const *variants, const char *axis,
                struct measure_list *list);

/* For progress: a scene or what the mode takes instead begins; and how many subjects it has. */
void bench_begin_part(struct bench *bench, int part);
void bench_expect(struct bench *bench, int subjects);

/* As the options say; errors against a reference of that kind. */
struct reference_desc bench_reference(const struct bench *bench, enum reference_kind kind);
bool bench_time(struct bench *bench, const struct measure_list *subjects, enum reference_kind kind);

#endif
