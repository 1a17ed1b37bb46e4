/* The portable program has no libraries that unpack: such files are refused. */
#include "scene/gltf/unpack.h"

#include "base/error.h"

bool unpack_meshopt(const struct packed_view *view, unsigned char *to) {
    (void)view, (void)to;
    return error_set("EXT_meshopt_compression is not read by this build");
}
