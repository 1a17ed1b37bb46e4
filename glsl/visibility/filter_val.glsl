// The filter of VALs' maps, by FILTER (shared/lookup.h).
#if FILTER == FILTER_HARD
#include "visibility/filter_hard.glsl"
#elif FILTER == FILTER_PLANE
#include "visibility/filter_plane.glsl"
#elif FILTER == FILTER_CSSM
#include "visibility/filter_cssm.glsl"
#elif FILTER == FILTER_PCSS
#include "visibility/filter_pcss.glsl"
#endif
