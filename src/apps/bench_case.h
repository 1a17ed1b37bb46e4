/* One thing that the benchmark measures: a scene rendered by a technique with some settings; and
 * what came out. */
#ifndef APPS_BENCH_CASE_H
#define APPS_BENCH_CASE_H

#include "gl/timer.h"
#include "renderer/settings.h"

enum { BENCH_NAME_SIZE = 96 };

/* Order statistics of one quantity over the frames. */
struct summary {
    int count;
    double median, p5, p95, minimum, maximum;
};

/* Sorts the values; count is at least 1. */
struct summary summary_of(float *values, int count);

struct bench_pass {
    char path[TIMER_PATH_SIZE]; /* "frame/cssm/basis" */
    int depth;
    struct summary ms;
};

/* Against the reference, as shares of its mean, and FLIP. */
struct bench_errors {
    bool measured;
    double relative_rmse, relative_bias, gradient; /* of the indirect layer */
    double ldr_flip;                               /* of the picture */
};

struct bench_case {
    char scene[BENCH_NAME_SIZE];
    char series[BENCH_NAME_SIZE]; /* the kind: "fast", "instant-radiosity hard" */
    char label[BENCH_NAME_SIZE];  /* the numbers within the kind: "vals=8 terms=2"; or "" */
    const struct technique *technique;
    struct settings settings;
    int width, height;

    unsigned faces;
    struct bench_pass passes[TIMERS_MAX]; /* the first is the whole frame */
    int pass_count;
    struct summary wall_ms; /* a frame without timers, by the clock */
    double gpu_memory;      /* MiB */
    struct bench_errors errors;
};

/* The rows of the paper's Table 2; what belongs to none comes last. */
enum bench_step {
    STEP_DEFERRED,
    STEP_VPLS,
    STEP_CLUSTERING,
    STEP_CSSM,
    STEP_INDIRECT,
    STEP_BLUR,
    STEP_OTHER,
    STEP_COUNT,
};

extern const char *const bench_step_names[STEP_COUNT];

/* The step that a pass belongs to, by its path; "frame/gather" is STEP_INDIRECT. */
enum bench_step bench_step_of(const char *path);

/* "technique=NAME", "size=WxH" or a setting's "key=value". Error: names what is allowed. */
bool bench_assign(struct bench_case *prepared, const char *assignment);

/* The same for "key=value,key=value"; "" is none. */
bool bench_assign_all(struct bench_case *prepared, const char *assignments);

double bench_frame_ms(const struct bench_case *measured);
double bench_step_ms(const struct bench_case *measured, enum bench_step step);

/* All passes directly below the frame. */
double bench_sum_ms(const struct bench_case *measured);

/* The settings that are not default, as "vals=8 visibility=hard"; cut off where text ends. */
void bench_options(const struct settings *settings, char *text, size_t size);

#endif
