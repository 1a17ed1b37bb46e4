/* Which settings have an effect as things are: what has none is not shown. */
#ifndef VIEWER_RELEVANCE_H
#define VIEWER_RELEVANCE_H

#include "renderer/settings.h"

/* A setting, and what must hold for it to change anything: another setting, "=", ">" or "!=", and a
 * value, or several with bars between. */
struct relevance {
    const char *name, *needs;
};

/* Ends with a row of no name. A setting may stand in several rows: all must hold. */
extern const struct relevance relevances[];

/* Whether it changes the pictures of the technique: a need that only another technique's settings
 * could meet is not met. */
bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique);

#endif
