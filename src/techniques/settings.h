/* All settings of the renderer, as one option table: --set key=value, the viewer's panel, sweeps.
 *
 * Defaults are the paper's where it gives them [Dong 2009 §5-7]. Lengths are fractions of the
 * scene's radius or extent, so that no setting depends on the scene's units.
 */
#ifndef TECHNIQUES_SETTINGS_H
#define TECHNIQUES_SETTINGS_H

#include "base/option.h"

enum visibility_kind { VISIBILITY_CSSM, VISIBILITY_HARD, VISIBILITY_PCSS };

/* Which way through the frame: sets other settings when it is assigned (settings_assign). */
enum path_kind { PATH_FAST, PATH_PAPER };

struct settings {
    int path;                 /* enum path_kind: the last one assigned */
    int vpl_count, val_count; /* N, M */
    int seed;
    int rsm_size, shadow_size;
    float shadow_bias;
    int iterations;
    int start;                            /* enum cluster_start of passes/cluster.h */
    float weight_position, weight_normal; /* w_x, w_alpha */
    int visibility;                       /* enum visibility_kind, of `clustered` */
    int map_size, basis_terms;            /* K */
    float bias, map_bias, near_clip, shift, gain, sharpen_a, sharpen_b;
    int taps;
    bool filter_jacobian;
    int visibility_block; /* pixels a side; 0 = each pixel looks itself up */
    int map_batch;        /* maps in memory at once, of `instant-radiosity` */
    int clamp;            /* enum gather_clamp */
    float clamp_value;
    float near_reach;
    int near_samples;
    int interleave, blur_radius;
    bool blur_separable;
    float blur_distance, blur_cosine; /* alpha, beta */
    float caster_edge, caster_error;
    int samples; /* of the pixel's area, for its edges */
    float exposure;
    int tone_map;
};

extern const struct option settings_table[];

/* Parses "key=value"; "path=NAME" also sets what belongs to that path. Use it, not option_assign.
 */
bool settings_assign(struct settings *settings, const char *assignment);

/* The defaults, but for what belongs to that path. */
void settings_of_path(struct settings *settings, int path);

/* Sets what belongs to settings->path, after that alone was changed. */
void settings_apply_path(struct settings *settings);

/* Checks what single ranges cannot: interleave^2 <= N. Error: a sentence for the user.
 */
bool settings_check(const struct settings *settings);

#endif
