/* Describes a measurement: a stage drawn by a technique with settings. A plain value.
 *
 * Settings have a text form: "technique=clustered,vals=8,size=400x300". */
#ifndef QUALITY_MEASURE_H
#define QUALITY_MEASURE_H

#include "renderer/renderer.h"
#include "renderer/stage.h"

enum { MEASURE_NAME_SIZE = 128 };

struct measure_desc {
    const struct stage *stage; /* not owned */
    int width, height;
    const struct technique *technique; /* NULL: none, for example a traced picture */
    const struct direct_method *direct;
    struct settings settings;
    char variant[MEASURE_NAME_SIZE]; /* name in results: "fast", "paper hard" */
    char point[MEASURE_NAME_SIZE];   /* position in a series: "vals=8 terms=2"; or "" */
};

/* Returns the defaults. stage NULL: only for checks of assignments. */
struct measure_desc measure_default(const struct stage *stage, int width, int height);

/* Describes what a renderer of the stage shows. */
struct measure_desc measure_of(const struct renderer_desc *desc, const struct stage *stage);

/* Assigns "key=value", or several separated by spaces or commas: "technique=NAME", "direct=NAME",
 * "size=WxH" or a setting. Presets come first, wherever they stand. NULL: none. Error: a name or a
 * value. */
bool measure_assign(struct measure_desc *desc, const char *text);

/* Assigns several texts as one. */
bool measure_assign_all(struct measure_desc *desc, const char *const *texts, int count);

/* Checks that the settings fit together. Error: explains the conflict and names the variant. */
bool measure_check(const struct measure_desc *desc);

/* Returns the settings that differ from the defaults, "clustered.vals=8 map.size=64". The caller
 * frees the text. */
char *measure_settings(const struct measure_desc *desc);

/* Returns the named setting as a number; 0 if the technique lacks it. */
double measure_setting(const struct measure_desc *desc, const char *name);

/* Returns the number of pixels. */
static inline double measure_pixels(const struct measure_desc *desc) {
    return (double)desc->width * desc->height;
}

/* Returns the indirect bounces; 1 if the technique has no setting for them. */
int measure_bounces(const struct measure_desc *desc);

/* Returns the evaluations of VPLs in a frame: each pixel takes the VPLs of its interleave slot. 0:
 * no VPLs. */
double measure_pixel_vpls(const struct measure_desc *desc);

/* Make a timed renderer, or a renderer ready for renderer_add_pass. Error: as of the settings or
 * the renderer; names the variant. */
bool measure_start(struct renderer *renderer, const struct measure_desc *desc);
bool measure_start_mean(struct renderer *renderer, const struct measure_desc *desc);

#endif
