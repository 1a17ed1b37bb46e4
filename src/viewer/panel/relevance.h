/* Which settings have an effect as things are: what has none is not shown. */
#ifndef VIEWER_RELEVANCE_H
#define VIEWER_RELEVANCE_H

#include "renderer/settings.h"

/* Whether it changes the pictures of the technique: a need that only another technique's settings
 * could meet is not met; one of what the technique does not use is none. */
bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique);

#endif
