// A summed area table.
#include "shared/maps.h"

layout(binding = UNIT_SUMS) uniform usampler2DArray sums; // of moments, or of Fourier bases
