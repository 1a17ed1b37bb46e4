/* Plain names of settings, for rows of the panel. */
#ifndef VIEWER_SETTING_LABEL_H
#define VIEWER_SETTING_LABEL_H

#include "base/settings.h"

enum { SETTING_LABEL_SIZE = 32 };

/* A few words, which the row's heading completes. A setting that the table lacks has its option's name, with spaces for
 * dashes. Whether the table has it. */
bool setting_label(const struct setting *setting, char label[SETTING_LABEL_SIZE]);

#endif
