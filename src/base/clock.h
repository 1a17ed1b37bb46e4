/* Clocks of the machine and of the process. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/* Returns milliseconds from a fixed moment in the past, on a clock that is never set. */
double clock_ms(void);

/* Returns milliseconds of CPU time of the process, summed over all cores. */
double clock_cpu_ms(void);

#endif
