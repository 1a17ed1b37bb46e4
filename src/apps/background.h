/* Parses --background: what a picture shows behind all surfaces, in place of black or the sky. */
#ifndef APPS_BACKGROUND_H
#define APPS_BACKGROUND_H

#include <stdbool.h>

struct background;

/* Parses "none", "#rrggbb" (# is optional; as a display shows it) or "r,g,b" from 0 to 1, linear
 * light of a display. NULL selects the scene's own background. Error: names the text and the
 * valid forms. */
bool background_parse(struct background *background, const char *text);

/* Returns true if the outputs can show it. Error: a format without alpha, or a colour that no
 * output holds. */
bool background_check(const struct background *background, const char *const *paths, int count);

#endif
