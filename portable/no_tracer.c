/* What `make portable` has in place of Embree: nothing, and it says so. */
#include "reference/path_tracer.h"
#include "reference/vpl_sum.h"

#include "base/error.h"

static bool refuse(struct image *image) {
    *image = (struct image){0};
    return error_set("this build traces no rays");
}

bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached) {
    (void)desc;
    (void)reached;
    return refuse(image);
}

/* Of what is traced, which nothing is. */
struct pixel path_tracer_pixel(int every, int x, int y) {
    return (struct pixel){x * every, y * every};
}

bool vpl_sum_render(const struct vpl_sum_desc *desc, struct image *image) {
    (void)desc;
    return refuse(image);
}
