#include "gl/cancel.h"

#include "base/clock.h"
#include "base/parallel.h"
#include "gl/api.h"

#include <assert.h>

enum { BATCH_MOST = 1 << 14 };

static _Thread_local struct {
    cancel_ask *ask;
    void *user;
    double interval, last; /* ms */
    int batch, drawn;      /* draws from one question to the next, and since the last */
    bool cancelled;
    /* The driver's own, or those that check samplers. */
    PFNGLDRAWARRAYSPROC draw_arrays;
    PFNGLDRAWARRAYSINSTANCEDPROC draw_arrays_instanced;
    PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXPROC draw_elements_instanced;
    PFNGLDISPATCHCOMPUTEPROC dispatch_compute;
    PFNGLDISPATCHCOMPUTEINDIRECTPROC dispatch_compute_indirect;
} watch;

/* Batches grow where they take a quarter of the interval, and shrink where they take more than all
 * of it. */
static void ask(void) {
    gl.Finish();
    double time = clock_ms(), took = time - watch.last;
    watch.drawn = 0;
    if (took < watch.interval / 4 && watch.batch < BATCH_MOST)
        watch.batch *= 2;
    else if (took > watch.interval && watch.batch > 1)
        watch.batch /= 2;
    if (took < watch.interval)
        return;
    watch.last = time;
    watch.cancelled = watch.ask(watch.user);
}

/* Asks before a draw, or leaves it out. */
static bool is_wanted(void) {
    if (!watch.cancelled && ++watch.drawn >= watch.batch)
        ask();
    return !watch.cancelled;
}

/* The same of loops of the CPU, by time: their parts are no draws. */
static bool is_loop_wanted(void) {
    if (!watch.cancelled && clock_ms() - watch.last >= watch.interval)
        ask();
    return !watch.cancelled;
}

static void APIENTRY draw_arrays(GLenum mode, GLint first, GLsizei count) {
    if (is_wanted())
        watch.draw_arrays(mode, first, count);
}

static void APIENTRY draw_arrays_instanced(GLenum mode, GLint first, GLsizei count,
                                           GLsizei instances) {
    if (is_wanted())
        watch.draw_arrays_instanced(mode, first, count, instances);
}

static void APIENTRY draw_elements_instanced(GLenum mode, GLsizei count, GLenum type,
                                             const void *indices, GLsizei instances, GLint base) {
    if (is_wanted())
        watch.draw_elements_instanced(mode, count, type, indices, instances, base);
}

static void APIENTRY dispatch_compute(GLuint x, GLuint y, GLuint z) {
    if (is_wanted())
        watch.dispatch_compute(x, y, z);
}

static void APIENTRY dispatch_compute_indirect(GLintptr offset) {
    if (is_wanted())
        watch.dispatch_compute_indirect(offset);
}

void cancel_begin(cancel_ask *ask, void *user, double interval) {
    assert(!watch.ask);
    watch.ask = ask;
    watch.user = user;
    watch.interval = interval;
    watch.last = clock_ms();
    watch.batch = 1;
    watch.drawn = 0;
    watch.cancelled = false;
    watch.draw_arrays = gl.DrawArrays;
    watch.draw_arrays_instanced = gl.DrawArraysInstanced;
    watch.draw_elements_instanced = gl.DrawElementsInstancedBaseVertex;
    watch.dispatch_compute = gl.DispatchCompute;
    watch.dispatch_compute_indirect = gl.DispatchComputeIndirect;
    gl.DrawArrays = draw_arrays;
    gl.DrawArraysInstanced = draw_arrays_instanced;
    gl.DrawElementsInstancedBaseVertex = draw_elements_instanced;
    gl.DispatchCompute = dispatch_compute;
    gl.DispatchComputeIndirect = dispatch_compute_indirect;
    parallel_watch(is_loop_wanted);
}

bool cancel_came(void) {
    return watch.ask && watch.cancelled;
}

bool cancel_end(void) {
    gl.DrawArrays = watch.draw_arrays;
    gl.DrawArraysInstanced = watch.draw_arrays_instanced;
    gl.DrawElementsInstancedBaseVertex = watch.draw_elements_instanced;
    gl.DispatchCompute = watch.dispatch_compute;
    gl.DispatchComputeIndirect = watch.dispatch_compute_indirect;
    watch.ask = NULL;
    parallel_watch(NULL);
    return watch.cancelled;
}
