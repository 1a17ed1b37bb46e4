/* What is measured: a stage, drawn by a technique with some settings. A plain value.
 *
 * Settings are spoken of as text wherever that does: "technique=clustered,vals=8,size=400x300".
 */
#ifndef QUALITY_MEASURE_H
#define QUALITY_MEASURE_H

#include "renderer/renderer.h"
#include "renderer/stage.h"

enum { MEASURE_NAME_SIZE = 128 };

struct measure_desc {
    const struct stage *stage; /* must live on */
    int width, height;
    const struct technique *technique; /* NULL: a picture by none, such as a traced one */
    const struct direct_method *direct;
    struct settings settings;
    char variant[MEASURE_NAME_SIZE]; /* as results call it: "fast", "paper hard" */
    char point[MEASURE_NAME_SIZE];   /* its place in a series: "vals=8 terms=2"; or "" */
};

/* All defaults. stage NULL: assignments are only tried. */
struct measure_desc measure_default(const struct stage *stage, int width, int height);

/* What a renderer of the stage shows. */
struct measure_desc measure_of(const struct renderer_desc *desc, const struct stage *stage);

/* Assigns "key=value", or several with spaces or commas between: "technique=NAME", "direct=NAME",
 * "size=WxH" or a setting; presets come first, wherever they stand. NULL is none. Error: of a name
 * or a value. */
bool measure_assign(struct measure_desc *desc, const char *text);

/* The same of several such texts as one. */
bool measure_assign_all(struct measure_desc *desc, const char *const *texts, int count);

/* Whether the settings go together. Error: a sentence; names the variant. */
bool measure_check(const struct measure_desc *desc);

/* The settings that are not default, "clustered.vals=8 map.size=64"; the caller frees it. */
char *measure_settings(const struct measure_desc *desc);

/* The setting of that name as a number; 0 where the technique has none such. */
double measure_setting(const struct measure_desc *desc, const char *name);

static inline double measure_pixels(const struct measure_desc *desc) {
    return (double)desc->width * desc->height;
}

/* Of indirect light: 1 where the technique does not tell. */
int measure_bounces(const struct measure_desc *desc);

/* How often a VPL is looked at in a frame: each pixel takes those of its interleave slot. 0 where
 * there are none. */
double measure_pixel_vpls(const struct measure_desc *desc);

/* A renderer of it, timed; and one that is ready for renderer_add_pass. Error: of the settings or the renderer; names
 * the variant. */
bool measure_start(struct renderer *renderer, const struct measure_desc *desc);
bool measure_start_mean(struct renderer *renderer, const struct measure_desc *desc);

#endif
