/* Skies by formula: the general sky of ISO 15469 and CIE S 011, of 15 types from overcast to clear,
 * and as type 16 the traditional overcast sky [Moon and Spencer 1942].
 *
 *     "cie:12,elevation=30,azimuth=120,horizontal=12000"
 *
 * elevation and azimuth are the sun's, degrees: above the horizon, and from -Z (north) towards +X
 * (east); 45 and 180 by default. `horizontal` is the sky's irradiance of a level plane, W/m2, pi by
 * default; `zenith` in its place is the radiance of the zenith, W/(sr m2). The sun itself and the
 * ground are black. */
#ifndef SCENE_LIGHTS_CIE_SKY_H
#define SCENE_LIGHTS_CIE_SKY_H

#include "scene/lights/environment.h"

/* True if the text names such a sky in place of a file. */
bool cie_sky_is(const char *text);

/* Makes the picture of a sky, with turn 0 and strength 1; the caller sets the path. Error: names
 * the word and the reason. */
bool cie_sky_make(struct environment *environment, const char *text);

#endif
