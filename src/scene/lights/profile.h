/* Light profiles: luminous intensity of a lamp by direction, of a file of IES LM-63 of 1986 to 2019
 * [LM-63], or of EULUMDAT.
 *
 * The axis of the lamp, where both angles are 0, is the light's direction. C-planes (type C and
 * EULUMDAT) turn from the light's right to its up. Types A and B have the horizontal angle to the
 * right and the vertical angle up; A turns by the horizontal angle first, B by the vertical one.
 * Left out: TILT, which is for lamps that burn aslant, sizes of the lamp, and where a lamp of
 * EULUMDAT has several sets of lamps, all but the first. */
#ifndef SCENE_LIGHTS_PROFILE_H
#define SCENE_LIGHTS_PROFILE_H

#include <stdbool.h>

struct profile {
    enum profile_type { PROFILE_C = 1, PROFILE_B, PROFILE_A } type; /* LM-63's numbers */
    int plane_count, angle_count;
    double *planes, *angles; /* horizontal and vertical angles, degrees, increasing */
    double *candela;         /* plane by plane */
};

/* Reads a file's text; the line TILT= tells the formats apart. Error: line and reason. */
bool profile_parse(struct profile *profile, const char *text);

/* Returns the intensity, cd, in a direction to the right, up and ahead, of any length: linear
 * between angles, 0 outside the vertical ones, mirrored by the file's symmetry. */
double profile_candela(const struct profile *profile, const double direction[3]);

/* Accepts a zeroed or half-read profile. */
void profile_free(struct profile *profile);

#endif
