#include "scene/gltf/unpack.h"

#include "base/error.h"

#include <meshoptimizer.h>

static bool check(const struct packed_view *view) {
    size_t stride = view->stride;
    bool good = view->mode == PACKED_ATTRIBUTES ? stride > 0 && stride % 4 == 0 && stride <= 256
                                                : stride == 2 || stride == 4;
    if (view->mode == PACKED_TRIANGLES && view->count % 3 != 0)
        return error_set("%zu indices make no whole triangles", view->count);
    if (view->filter == FILTER_OCTAHEDRAL || view->filter == FILTER_COLOR)
        good = good && (stride == 4 || stride == 8);
    if (view->filter == FILTER_QUATERNION)
        good = good && stride == 8;
    if (view->filter != FILTER_NONE && view->mode != PACKED_ATTRIBUTES)
        return error_set("a filter of indices");
    return good || error_set("elements of %zu bytes", stride);
}

static int decode(const struct packed_view *view, unsigned char *to) {
    if (view->mode == PACKED_ATTRIBUTES)
        return meshopt_decodeVertexBuffer(to, view->count, view->stride, view->bytes, view->size);
    if (view->mode == PACKED_TRIANGLES)
        return meshopt_decodeIndexBuffer(to, view->count, view->stride, view->bytes, view->size);
    return meshopt_decodeIndexSequence(to, view->count, view->stride, view->bytes, view->size);
}

bool unpack_meshopt(const struct packed_view *view, unsigned char *to) {
    if (!check(view))
        return false;
    bool is_v1 = view->mode == PACKED_ATTRIBUTES && view->size > 0 && view->bytes[0] == MESHOPT_V1;
    if (is_v1 && !unpack_meshopt_v1(view, to))
        return false;
    if (!is_v1 && decode(view, to) != 0)
        return error_set("%zu bytes are no %zu packed elements", view->size, view->count);
    if (view->filter == FILTER_OCTAHEDRAL)
        meshopt_decodeFilterOct(to, view->count, view->stride);
    if (view->filter == FILTER_QUATERNION)
        meshopt_decodeFilterQuat(to, view->count, view->stride);
    if (view->filter == FILTER_EXPONENTIAL)
        meshopt_decodeFilterExp(to, view->count, view->stride);
    if (view->filter == FILTER_COLOR)
        unpack_meshopt_color(view, to);
    return true;
}
