/* Where samples of the near field lie around a receiver, by the logarithm of their radius and by angle: on a spiral that
 * makes the golden ratio of a turn from sample to sample. Each place of an interleaving pattern has a spiral of its
 * own, turned and moved along by steps that are alike from place to place.
 *
 * Where planes meet, the blur finds but a part of a pattern. So not the whole of it alone has to be even, but its
 * rows, its columns, its slanted lines and its quarters, too: the steps are those that err least beside edges of all
 * directions between two lit planes.
 */
#ifndef BASE_SPIRAL_H
#define BASE_SPIRAL_H

/* Of all samples of a place, [0, 1): by what part of a turn they are turned, and moved along by what part of the way to
 * the next sample. */
struct spiral_shift {
    float turn, along;
};

/* Each pass of many has its own. */
struct spiral_shift spiral_shift(int x, int y, int pass);

/* Of a turn, from sample to sample. */
#define SPIRAL_TURN .6180339887498949

#endif
