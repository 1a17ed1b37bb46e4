#include "passes/lights/vpl_tree.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/vpl.h"

#include <string.h>

static bool init_programs(struct vpl_tree_pass *pass) {
    const struct {
        GLuint *program;
        struct program_desc desc;
    } rows[] = {
        {&pass->keys_program, {.compute = "passes/lights/tree_keys.comp"}},
        {&pass->sort_program, {.compute = "passes/lights/tree_sort.comp"}},
        {&pass->leaves_program, {.compute = "passes/lights/tree_nodes.comp", .defines = "LEAVES"}},
        {&pass->nodes_program, {.compute = "passes/lights/tree_nodes.comp"}},
        {&pass->representatives_program,
         {.screen = {"passes/lights/tree_representatives.frag", .layers = true}}},
    };
    bool ok = true;
    for (size_t i = 0; ok && i < sizeof rows / sizeof *rows; i++)
        ok = program_init(rows[i].program, &rows[i].desc);
    return ok;
}

static bool init_nodes(struct texture *texture, const char *label, GLenum format, int nodes,
                       int layers) {
    return texture_init(texture, &(struct texture_desc){
                                     .label = label,
                                     .target = GL_TEXTURE_2D_ARRAY,
                                     .format = format,
                                     .width = nodes < TREE_COLUMNS ? nodes : TREE_COLUMNS,
                                     .height = (nodes + TREE_COLUMNS - 1) / TREE_COLUMNS,
                                     .layers = layers,
                                 });
}

static bool init_tree(struct vpl_tree_pass *pass) {
    struct vpl_tree *tree = &pass->tree;
    tree->sets = pass->desc.sets;
    tree->leaves = 1;
    while (tree->leaves < pass->desc.vpl_count)
        tree->leaves *= 2;
    return init_nodes(&tree->nodes, "tree of VPLs", GL_RGBA32F, 2 * tree->leaves, TREE_ROWS) &&
           init_nodes(&tree->representatives, "representatives", GL_R32UI, 2 * tree->leaves,
                      tree->sets) &&
           framebuffer_init(&pass->representatives_framebuffer,
                            &(struct framebuffer_desc){.label = "representatives",
                                                       .colors = {&tree->representatives}});
}

bool vpl_tree_pass_init(struct vpl_tree_pass *pass, const struct vpl_tree_desc *desc) {
    *pass = (struct vpl_tree_pass){.desc = *desc};
    if (init_programs(pass) && init_tree(pass) &&
        buffer_init(&pass->keys, "keys of VPLs", (size_t)pass->tree.leaves * 4 * sizeof(GLuint),
                    NULL) &&
        buffer_init(&pass->params, "tree parameters", sizeof(struct vpl_tree_params), NULL))
        return true;
    vpl_tree_pass_free(pass);
    return false;
}

void vpl_tree_pass_free(struct vpl_tree_pass *pass) {
    programs_free(&pass->keys_program, &pass->sort_program, &pass->leaves_program,
                  &pass->nodes_program, &pass->representatives_program);
    framebuffer_free(&pass->representatives_framebuffer);
    textures_free(&pass->tree.nodes, &pass->tree.representatives);
    buffers_free(&pass->keys, &pass->params);
    *pass = (struct vpl_tree_pass){0};
}

static void write_params(const struct vpl_tree_pass *pass, const struct frame *frame) {
    struct vpl_tree_params params = {.vpl_count = pass->desc.vpl_count,
                                     .leaves = pass->tree.leaves};
    memcpy(params.bounds_min, frame->geometry->bounds_min, sizeof frame->geometry->bounds_min);
    memcpy(params.bounds_max, frame->geometry->bounds_max, sizeof frame->geometry->bounds_max);
    buffer_write(&pass->params, 0, sizeof params, &params);
}

static struct pass_state state_of(const struct vpl_tree_pass *pass, GLuint program) {
    return (struct pass_state){
        .name = "tree",
        .program = program,
        .textures = {{UNIT_VPLS, pass->tree.vpls}},
        .blocks = {{BLOCK_PASS, &pass->params}},
        .storages = {{STORAGE_TREE_KEYS, &pass->keys}},
        .barriers = GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT,
    };
}

static void dispatch(int invocations) {
    pass_dispatch((invocations + TREE_GROUP - 1) / TREE_GROUP, 1, 1);
}

static void step(const struct vpl_tree_pass *pass, GLuint program, int first, int second,
                 int invocations) {
    struct pass_state state = state_of(pass, program);
    if (program != pass->sort_program)
        state.images[0] =
            (struct pass_image){IMAGE_TREE_NODES, &pass->tree.nodes, 0, GL_READ_WRITE};
    pass_set_state(&state);
    gl.ProgramUniform4i(program, LOCATION_TREE_STEP, first, second, 0, 0);
    dispatch(invocations);
}

static void sort(const struct vpl_tree_pass *pass) {
    struct pass_state state = state_of(pass, pass->keys_program);
    pass_set_state(&state);
    dispatch(pass->tree.leaves);
    for (int sorted = 2; sorted <= pass->tree.leaves; sorted *= 2)
        for (int apart = sorted / 2; apart > 0; apart /= 2)
            step(pass, pass->sort_program, sorted, apart, pass->tree.leaves / 2);
}

static void build(const struct vpl_tree_pass *pass) {
    int leaves = pass->tree.leaves;
    step(pass, pass->leaves_program, leaves, leaves, leaves);
    for (int level = leaves / 2; level > 0; level /= 2)
        step(pass, pass->nodes_program, level, level, level);
}

static void choose_representatives(const struct vpl_tree_pass *pass) {
    struct pass_state state = state_of(pass, pass->representatives_program);
    state.framebuffer = pass->representatives_framebuffer;
    state.width = pass->tree.representatives.desc.width;
    state.height = pass->tree.representatives.desc.height;
    state.barriers |= GL_TEXTURE_FETCH_BARRIER_BIT;
    pass_add_texture(&state, UNIT_TREE_NODES, pass->tree.nodes.id);
    pass_set_state(&state);
    gl.ProgramUniform1i(pass->representatives_program, LOCATION_FIRST_LAYER, 0);
    pass_draw_fullscreen(pass->tree.sets);
}

void vpl_tree_pass_render(struct vpl_tree_pass *pass, const struct frame *frame,
                          const struct vpl_buffer *vpls) {
    timer_begin(frame->timers, "tree");
    pass->tree.vpls = vpls->buffer.texels;
    write_params(pass, frame);
    sort(pass);
    build(pass);
    choose_representatives(pass);
    timer_end(frame->timers);
}
