// The filter of lights' own maps, by FILTER (shared/lookup.h).
#if FILTER == FILTER_VSSM
#include "visibility/filter_vssm.glsl"
#elif FILTER == FILTER_MSM
#include "visibility/filter_msm.glsl"
#else
#include "visibility/filter_cssm_window.glsl"
#endif
