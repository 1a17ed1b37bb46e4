/* --background: what is seen behind all surfaces, in place of black or the sky. */
#ifndef APPS_BACKGROUND_H
#define APPS_BACKGROUND_H

#include <stdbool.h>

struct background;

/* "none"; "#rrggbb" with or without #, as a display shows it; or "r,g,b" from 0 to 1, the display's
 * light. NULL is the scene's own. Error: names the text and the right ones. */
bool background_parse(struct background *background, const char *text);

/* Whether the outputs can show it. Error: a format without alpha, or a colour that no
 * output holds. */
bool background_check(const struct background *background, const char *const *paths, int count);

#endif
