/* The time that passes. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/* Milliseconds since some moment of the past, on a clock that is never set. */
double clock_ms(void);

/* Milliseconds that the process has had of all cores together. */
double clock_cpu_ms(void);

#endif
