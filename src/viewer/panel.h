/* The sections of the panel that have files of their own, and the row of a setting. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include "viewer/viewer.h"
#include "viewer/window/ui.h"

/* A row for a setting, under that name and help in place of the table's unless NULL. Whether the
 * user changed it. */
bool panel_draw_setting(const struct setting *setting, struct settings *settings, const char *name,
                        const char *help);

void panel_draw_technique(struct viewer *viewer);
void panel_draw_reference(struct viewer *viewer);
void panel_draw_compare(struct viewer *viewer);
void panel_draw_session(struct viewer *viewer);

#endif
