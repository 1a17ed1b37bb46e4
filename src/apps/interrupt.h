/* SIGINT and SIGTERM held back while a sequence is rendered, so that it ends between two frames.
 *
 *     interrupts_hold();         before anything starts threads: they inherit it
 *     ... interrupt_came() ...   between two frames
 *     interrupts_release();      the process ends here if one came, by that signal
 *
 * Signals that the caller ignores, as nohup does, stay ignored.
 */
#ifndef APPS_INTERRUPT_H
#define APPS_INTERRUPT_H

#include <stdbool.h>

void interrupts_hold(void);
bool interrupt_came(void);
void interrupts_release(void);

#endif
