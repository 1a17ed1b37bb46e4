/* Converts colours of other primaries to linear BT.709, in which the program computes. */
#ifndef BASE_PRIMARIES_H
#define BASE_PRIMARIES_H

#include <stdbool.h>

/* x and y of red, green, blue and white. */
enum { PRIMARIES_NUMBERS = 8 };
extern const float primaries_bt709[PRIMARIES_NUMBERS];

/* Makes the matrix from CIE XYZ with white D65 to linear BT.709. Matrices are in columns, as in
 * cglm. */
void primaries_matrix_of_xyz(float matrix[3][3]);

/* Makes the matrix from linear RGB of these primaries; white becomes white by Bradford's
 * adaptation. Returns false if the numbers span no colours. */
bool primaries_matrix(const float primaries[PRIMARIES_NUMBERS], float matrix[3][3]);

/* True if the primaries are BT.709, at the precision of files. */
bool primaries_are_bt709(const float primaries[PRIMARIES_NUMBERS]);

#endif
