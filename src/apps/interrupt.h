/* Holds back or remembers SIGINT and SIGTERM, so that nothing is left half done.
 *
 * Held back while a sequence is rendered, so that it ends with its last whole frame. A process that
 * has not ended a second later, or when another signal comes, ends wherever it is: files appear
 * when they are whole (base/file/output_file.h).
 *
 *     interrupts_hold();         before anything starts threads: they inherit it
 *     ... interrupt_came() ...   between two frames, and interrupt_asked within one
 *     interrupts_release();      the process ends here if one came, by that signal
 *
 * Remembered where threads run already and would take the signal, SIGHUP too:
 *
 *     interrupts_catch(), interrupt_came(), interrupts_obey(): the process ends here if one came
 *
 * Signals that the caller ignores, as nohup does, stay ignored. */
#ifndef APPS_INTERRUPT_H
#define APPS_INTERRUPT_H

#include <stdbool.h>

void interrupts_hold(void);
bool interrupt_came(void);

/* Same as interrupt_came, for gl/cancel.h, which passes NULL. */
bool interrupt_asked(void *user);

void interrupts_release(void);
void interrupts_catch(void);
void interrupts_obey(void);

#endif
