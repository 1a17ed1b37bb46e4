/* Skies by formula: the general sky of ISO 15469 and CIE S 011, of 15 types from overcast to clear,
 * as type 16 the traditional overcast sky [Moon and Spencer 1942], and the coloured clear sky of a
 * turbidity [Preetham et al. 1999].
 *
 *     "cie:12,elevation=30,azimuth=120,horizontal=12000"
 *     "preetham:3,elevation=30"
 *
 * elevation and azimuth are the sun's, degrees: above the horizon, and from -Z (north) towards +X
 * (east); 45 and 180 by default. `horizontal` is the sky's irradiance of a level plane, W/m2;
 * `zenith` in its place is the radiance of the zenith, W/(sr m2). Both count the luminance of
 * colours. By default `horizontal` is pi for a CIE sky, and a coloured sky has the model's
 * luminance with 1 W for 1000 lm. The sun itself and the ground are black. */
#ifndef SCENE_LIGHTS_SKY_FORMULA_H
#define SCENE_LIGHTS_SKY_FORMULA_H

#include "scene/lights/environment.h"

/* True if the text names such a sky in place of a file. */
bool sky_formula_is(const char *text);

/* Makes the picture of a sky, with turn 0 and strength 1; the caller sets the path. Error: names
 * the word and the reason. */
bool sky_formula_make(struct environment *environment, const char *text);

#endif
