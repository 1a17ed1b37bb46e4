/* Colours of other red, green, blue and white than those of BT.709, which this program computes in. */
#ifndef BASE_PRIMARIES_H
#define BASE_PRIMARIES_H

#include <stdbool.h>

/* x and y of red, green, blue and white. */
enum { PRIMARIES_NUMBERS = 8 };
extern const float primaries_bt709[PRIMARIES_NUMBERS];

/* Linear RGB of BT.709 of CIE XYZ, whose white is D65. */
void primaries_matrix_of_xyz(double matrix[3][3]);

/* Linear RGB of BT.709 of linear RGB of these primaries; white becomes white, by Bradford's adaptation. False: the
 * numbers span no colours. */
bool primaries_matrix(const float primaries[PRIMARIES_NUMBERS], double matrix[3][3]);

/* Whether they are those of BT.709, as far as files write them. */
bool primaries_are_bt709(const float primaries[PRIMARIES_NUMBERS]);

#endif
