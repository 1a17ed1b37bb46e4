#include "passes/lights/vpl_tree.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "shared/vpl.h"

static bool init_programs(struct vpl_tree_pass *pass) {
    const struct {
        GLuint *program;
        struct program_desc desc;
    } rows[] = {
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
    tree->leaves = pass->sort.leaves;
    return init_nodes(&tree->nodes, "tree of VPLs", GL_RGBA32F, 2 * tree->leaves, TREE_ROWS) &&
           init_nodes(&tree->representatives, "representatives", GL_R32UI, 2 * tree->leaves,
                      tree->sets) &&
           framebuffer_init(&pass->representatives_framebuffer,
                            &(struct framebuffer_desc){.label = "representatives",
                                                       .colors = {&tree->representatives}});
}

bool vpl_tree_pass_init(struct vpl_tree_pass *pass, const struct vpl_tree_desc *desc) {
    *pass = (struct vpl_tree_pass){.desc = *desc};
    if (vpl_sort_init(&pass->sort, desc->vpl_count) && init_programs(pass) && init_tree(pass))
        return true;
    vpl_tree_pass_free(pass);
    return false;
}

void vpl_tree_pass_free(struct vpl_tree_pass *pass) {
    programs_free(&pass->leaves_program, &pass->nodes_program, &pass->representatives_program);
    vpl_sort_free(&pass->sort);
    framebuffer_free(&pass->representatives_framebuffer);
    textures_free(&pass->tree.nodes, &pass->tree.representatives);
    *pass = (struct vpl_tree_pass){0};
}

static void step(const struct vpl_tree_pass *pass, GLuint program, int first, int nodes) {
    struct pass_state state = vpl_sort_state(&pass->sort, program, pass->tree.vpls);
    state.images[0] = (struct pass_image){IMAGE_TREE_NODES, &pass->tree.nodes, 0, GL_READ_WRITE};
    pass_set_state(&state);
    gl.ProgramUniform4i(program, LOCATION_TREE_STEP, first, nodes, 0, 0);
    vpl_sort_dispatch(nodes);
}

static void build(const struct vpl_tree_pass *pass) {
    int leaves = pass->tree.leaves;
    step(pass, pass->leaves_program, leaves, leaves);
    for (int level = leaves / 2; level > 0; level /= 2)
        step(pass, pass->nodes_program, level, level);
}

static void choose_representatives(const struct vpl_tree_pass *pass) {
    struct pass_state state =
        vpl_sort_state(&pass->sort, pass->representatives_program, pass->tree.vpls);
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
    vpl_sort_render(&pass->sort, frame, pass->tree.vpls);
    build(pass);
    choose_representatives(pass);
    timer_end(frame->timers);
}
