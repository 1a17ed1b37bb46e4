/* manylight bench --temporal: how steady moving pictures are.
 *
 * Flicker is what changes from frame to frame in a picture F and not in the reference R, which has
 * all VPLs with a shadow map each, or is path-traced (--reference path):
 *
 *     mean over frames and pixels of |(F_t - F_t-1) - (R_t - R_t-1)| / mean R
 *
 * of the indirect light. A picture that is wrong, but steadily so, does not flicker.
 */
#ifndef APPS_TEMPORAL_H
#define APPS_TEMPORAL_H

#include "apps/bench.h"

/* Renders each scene's clip with all variants. Prints a table, writes every frame of every variant
 * to --csv, and draws FOLDER/SCENE-flicker and SCENE-vals. Error: of a scene, a variant or a file.
 */
bool bench_temporal(const struct bench_values *values, const char **scenes, int scene_count,
                    bool software);

#endif
