/* What the figures were measured on and with. */
#ifndef APPS_BENCH_MACHINE_H
#define APPS_BENCH_MACHINE_H

#include <stdbool.h>

struct bench_machine {
    char vendor[96], renderer[160], version[96]; /* OpenGL's */
    bool software;
    char cpu[96];
    int cores;
    char commit[64], date[16]; /* of the program; of the run, UTC */
};

/* Of the current context. */
void bench_machine_read(struct bench_machine *machine, bool software);

#endif
