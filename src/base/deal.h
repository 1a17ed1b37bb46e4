/* Divides whole things among takers in proportion to weights, for example samples among lights.
 *
 * Method: the divisor method of Sainte-Lague. A taker with a weight above 0 gets at least one thing
 * if there are enough. The things of a taker are spread evenly over the sequence, so any run holds
 * the takers in proportion. */
#ifndef BASE_DEAL_H
#define BASE_DEAL_H

/* A thing: its taker, and its index among the things of this taker, from 0. */
struct dealt {
    int taker, number;
};

/* Assigns a taker to each of thing_count things. weights: finite, not negative; if all are 0, all
 * count alike. counts, unless NULL, receives the number of things of each taker. */
void deal(const double *weights, int taker_count, struct dealt *things, int thing_count,
          int *counts);

#endif
