/* Embree 3 and 4 behind one interface. Embree 4 runs a query's filter only with a flag of the
 * query. */
#ifndef REFERENCE_SCENE_EMBREE_H
#define REFERENCE_SCENE_EMBREE_H

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
typedef struct RTCRayQueryContext embree_context;
enum { EMBREE_QUERY_FILTERS = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS };

static inline void embree_intersect(RTCScene scene, embree_context *context,
                                    RTCFilterFunctionN filter, struct RTCRayHit *ray) {
    struct RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    rtcInitRayQueryContext(context);
    arguments.context = context;
    arguments.filter = filter;
    arguments.flags |= filter ? RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER : 0;
    rtcIntersect1(scene, ray, &arguments);
}

static inline struct RTCOccludedArguments embree_occluded_arguments(embree_context *context,
                                                                    RTCFilterFunctionN filter) {
    struct RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    rtcInitRayQueryContext(context);
    arguments.context = context;
    arguments.filter = filter;
    arguments.flags |= filter ? RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER : 0;
    return arguments;
}

static inline void embree_occluded(RTCScene scene, embree_context *context,
                                   RTCFilterFunctionN filter, struct RTCRay *ray) {
    struct RTCOccludedArguments arguments = embree_occluded_arguments(context, filter);
    rtcOccluded1(scene, ray, &arguments);
}

static inline void embree_occluded_4(const int *valid, RTCScene scene, embree_context *context,
                                     RTCFilterFunctionN filter, struct RTCRay4 *rays) {
    struct RTCOccludedArguments arguments = embree_occluded_arguments(context, filter);
    rtcOccluded4(valid, scene, rays, &arguments);
}

#else
#include <embree3/rtcore.h>
typedef struct RTCIntersectContext embree_context;
enum { EMBREE_QUERY_FILTERS = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION };

static inline void embree_begin(embree_context *context, RTCFilterFunctionN filter) {
    rtcInitIntersectContext(context);
    context->filter = filter;
}

static inline void embree_intersect(RTCScene scene, embree_context *context,
                                    RTCFilterFunctionN filter, struct RTCRayHit *ray) {
    embree_begin(context, filter);
    rtcIntersect1(scene, context, ray);
}

static inline void embree_occluded(RTCScene scene, embree_context *context,
                                   RTCFilterFunctionN filter, struct RTCRay *ray) {
    embree_begin(context, filter);
    rtcOccluded1(scene, context, ray);
}

static inline void embree_occluded_4(const int *valid, RTCScene scene, embree_context *context,
                                     RTCFilterFunctionN filter, struct RTCRay4 *rays) {
    embree_begin(context, filter);
    rtcOccluded4(valid, scene, context, rays);
}
#endif

#endif
