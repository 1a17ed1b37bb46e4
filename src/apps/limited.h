/* --max-memory and low bounds of ulimit: the work in a process of its own.
 *
 * OpenGL drivers end the process where they get no memory. So the limit holds for a child, and its parent
 * turns such an end into one message. The parent passes on what the child says, signals that ask it to end, and its exit
 * status.
 */
#ifndef APPS_LIMITED_H
#define APPS_LIMITED_H

#include <stdbool.h>

/* Starts the subcommand of these arguments anew, waits for it and exits; or returns in the child, which may then hold
 * so many GiB; 0: what the system grants. Error: the limit cannot be set. */
bool limited_begin(int argc, char **argv, double gib);

#endif
