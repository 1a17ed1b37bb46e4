/* Spiral of near-field samples around a receiver, in the logarithm of the radius and the angle.
 * Each sample turns by the golden ratio from the one before. Each slot of the interleaving pattern
 * has its own spiral, rotated and shifted by constant steps from slot to slot.
 *
 * At edges between planes the blur finds only a part of the pattern. Rows, columns, diagonals and
 * quarters of it must therefore be evenly distributed, too. The steps are those with the least
 * error beside edges of all directions between two lit planes. */
#ifndef BASE_SPIRAL_H
#define BASE_SPIRAL_H

/* Shift of all samples of a slot, [0, 1): rotation in turns, and offset as a fraction of the step
 * to the next sample. */
struct spiral_shift {
    float turn, along;
};

/* Returns the shift of slot x, y in a pass of a progressive picture. */
struct spiral_shift spiral_shift(int x, int y, int pass);

/* Rotation from sample to sample, in turns. */
#define SPIRAL_TURN .6180339887498949

#endif
