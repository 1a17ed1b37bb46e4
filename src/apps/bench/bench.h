/* The parts of `manylight bench MODE`. */
#ifndef APPS_BENCH_BENCH_H
#define APPS_BENCH_BENCH_H

#include "apps/arguments.h"
#include "apps/context_options.h"
#include "measure/results.h"
#include "measure/sweep.h"
#include "measure/truth.h"

/* Of all modes; those that a mode has not are zero. */
struct bench_values {
    struct common_values common;
    struct context_desc context;
    struct text_list variants, settings, axes;
    const char *csv, *cache, *output;
    int size[2], frames, warm_up, reference;
    float noise;
};

/* A run of a mode. */
struct bench {
    struct bench_values values;
    const char **arguments; /* scenes, or what the mode takes instead */
    int argument_count;
    char *settings; /* all of --set */
    struct sweep sweep;
    struct stage stage;      /* of the present scene */
    struct context *context; /* current; NULL where the mode needs none */
    struct results results;  /* written to --csv at the end */
};

struct bench_mode {
    const char *name, *help; /* of `bench --help`, one line */
    const char *synopsis, *summary;
    const struct option *options;
    bool needs_no_context;
    /* Arguments that are no scenes; NULL where they are. Error: of usage. */
    bool (*check)(struct bench *bench);
    /* Variants, unless --variant says otherwise; NULL-terminated. */
    const char *const *usual;
    /* Each scene, with a subject for each variant at each point of the sweep; NULL: no scenes. */
    bool (*measure)(struct bench *bench, const struct measure_desc *descs, int count);
    const struct table *tables;          /* printed after each scene; end with one of no title */
    bool (*finish)(struct bench *bench); /* after the last scene; NULL = nothing is left to do */
};

extern const struct bench_mode bench_times, bench_sweep, bench_scaling, bench_budget, bench_curves,
    bench_temporal, bench_failures, bench_chart;

/* Rows for the options of a mode. */
/* clang-format off */
#define BENCH_VALUE(member) offsetof(struct bench_values, member)
#define BENCH_SIZE(side)                                                                           \
    {"size", 's', OPTION_SIZE, BENCH_VALUE(size), side, 1, 16384, .help = "of the picture, pixels"}
#define BENCH_VARIANTS                                                                             \
    {"variant", 0, OPTION_LIST, BENCH_VALUE(variants),                                             \
     .help = "what to compare, of the list below; repeatable"}
#define BENCH_SETTINGS                                                                             \
    {"set", 0, OPTION_LIST, BENCH_VALUE(settings), .value_name = "KEY=VALUE",                      \
     .help = "a setting of all (manylight render --help); repeatable"}
#define BENCH_FRAMES                                                                               \
    {"frames", 0, OPTION_INT, BENCH_VALUE(frames), 0, 0, 100000,                                   \
     .help = "measured of each; 0 = 5 on software OpenGL, else 100"},                              \
    {"warm-up", 0, OPTION_INT, BENCH_VALUE(warm_up), 0, 0, 100000,                                 \
     .help = "frames before; 0 = 1 on software OpenGL, else 10"}
#define BENCH_NOISE                                                                                \
    {"noise", 0, OPTION_FLOAT, BENCH_VALUE(noise), .01, 1e-4, 1,                                   \
     .help = "of a path-traced reference: standard error over mean"}
#define BENCH_CACHE                                                                                \
    {"cache", 0, OPTION_TEXT, BENCH_VALUE(cache), .value_name = "DIR",                             \
     .help = "where references are kept [$XDG_CACHE_HOME/manylight]"}
#define BENCH_CSV                                                                                  \
    {"csv", 0, OPTION_TEXT, BENCH_VALUE(csv), .value_name = "FILE",                                \
     .help = "write all figures, a row each"}
#define BENCH_CONTEXT CONTEXT_OPTIONS(struct bench_values, context)
/* clang-format on */

extern const char *const bench_usual_variants[], *const bench_no_variants[];

/* A subject with the options' size and settings over a variant's. Error: of the variant or a
 * setting. */
bool bench_prepare(const struct bench *bench, const struct stage *stage, const char *variant,
                   struct measure_desc *desc);

/* A subject for each of the variants (--variant, or the usual ones) at each point of the sweep; the
 * caller frees them. NULL: an error, of a variant or of a setting. */
struct measure_desc *bench_list(const struct bench *bench, const struct stage *stage,
                                const struct sweep *sweep, const char *const *usual, int *count);

/* As the options say; errors against a truth of that kind. */
struct truth_desc bench_truth(const struct bench *bench, enum truth_kind kind);
bool bench_time(struct bench *bench, const struct measure_desc *descs, int count,
                enum truth_kind kind);

#endif
