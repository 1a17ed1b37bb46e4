#include "passes/vpl_sort.h"

#include "gl/program.h"
#include "passes/frame.h"
#include "shared/vpl.h"

#include <string.h>

bool vpl_sort_init(struct vpl_sort *sort, int count) {
    *sort = (struct vpl_sort){.count = count, .leaves = 1};
    while (sort->leaves < count)
        sort->leaves *= 2;
    if (program_init(&sort->keys_program,
                     &(struct program_desc){.compute = "passes/lights/tree_keys.comp"}) &&
        program_init(&sort->sort_program,
                     &(struct program_desc){.compute = "passes/lights/tree_sort.comp"}) &&
        buffer_init_texels(&sort->keys, GL_RGBA32UI, "keys of VPLs",
                           (size_t)sort->leaves * 4 * sizeof(GLuint), NULL) &&
        buffer_init(&sort->params, "tree parameters", sizeof(struct vpl_tree_params), NULL))
        return true;
    vpl_sort_free(sort);
    return false;
}

void vpl_sort_free(struct vpl_sort *sort) {
    programs_free(&sort->keys_program, &sort->sort_program);
    buffers_free(&sort->keys, &sort->params);
    *sort = (struct vpl_sort){0};
}

struct pass_state vpl_sort_state(const struct vpl_sort *sort, GLuint program, GLuint vpls) {
    return (struct pass_state){
        .name = "tree",
        .program = program,
        .textures = {{UNIT_VPLS, vpls}},
        .blocks = {{BLOCK_PASS, &sort->params}},
        .storages = {{STORAGE_TREE_KEYS, &sort->keys}},
        .barriers = GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT,
    };
}

void vpl_sort_dispatch(int invocations) {
    pass_dispatch((invocations + TREE_GROUP - 1) / TREE_GROUP, 1, 1);
}

static void write_params(const struct vpl_sort *sort, const struct frame *frame) {
    struct vpl_tree_params params = {.vpl_count = sort->count, .leaves = sort->leaves};
    memcpy(params.bounds_min, frame->geometry->bounds_min, sizeof frame->geometry->bounds_min);
    memcpy(params.bounds_max, frame->geometry->bounds_max, sizeof frame->geometry->bounds_max);
    buffer_write(&sort->params, 0, sizeof params, &params);
}

void vpl_sort_render(const struct vpl_sort *sort, const struct frame *frame, GLuint vpls) {
    struct pass_state state = vpl_sort_state(sort, sort->keys_program, vpls);
    write_params(sort, frame);
    pass_set_state(&state);
    vpl_sort_dispatch(sort->leaves);
    state.program = sort->sort_program;
    for (int sorted = 2; sorted <= sort->leaves; sorted *= 2)
        for (int apart = sorted / 2; apart > 0; apart /= 2) {
            pass_set_state(&state);
            gl.ProgramUniform4i(state.program, LOCATION_TREE_STEP, sorted, apart, 0, 0);
            vpl_sort_dispatch(sort->leaves / 2);
        }
}
