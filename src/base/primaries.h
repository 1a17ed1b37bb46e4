/* Colours of other red, green, blue and white than those of BT.709, which this program computes in. */
#ifndef BASE_PRIMARIES_H
#define BASE_PRIMARIES_H

#include <stdbool.h>

/* x and y of red, green, blue and white. */
enum { PRIMARIES_NUMBERS = 8 };
extern const float primaries_bt709[PRIMARIES_NUMBERS];

/* To linear RGB of BT.709 from CIE XYZ, whose white is D65. Matrices are columns, as cglm has them. */
void primaries_matrix_of_xyz(float matrix[3][3]);

/* The same from linear RGB of these primaries; white becomes white, by Bradford's adaptation. False: the
 * numbers span no colours. */
bool primaries_matrix(const float primaries[PRIMARIES_NUMBERS], float matrix[3][3]);

/* Whether they are those of BT.709, as far as files write them. */
bool primaries_are_bt709(const float primaries[PRIMARIES_NUMBERS]);

#endif
