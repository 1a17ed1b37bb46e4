#include "passes/gather/vpl_cut.h"

#include "base/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/targets.h"
#include "shared/gather.h"

#include <assert.h>
#include <stdlib.h>

static bool init_program(GLuint *program, int clamp) {
    char *defines = mem_printf("CLAMP %d", clamp);
    bool ok = program_init(
        program, &(struct program_desc){.compute = "passes/gather/cut.comp", .defines = defines});
    free(defines);
    return ok;
}

static bool init_cuts(struct vpl_cuts *cuts, const struct vpl_cut_desc *desc) {
    cuts->block = desc->block;
    cuts->adaptive_layer = 1 + desc->nodes;
    return texture_init(&cuts->texture,
                        &(struct texture_desc){
                            .label = "cuts",
                            .target = GL_TEXTURE_2D_ARRAY,
                            .format = GL_R32UI,
                            .width = (desc->width + desc->block - 1) / desc->block,
                            .height = (desc->height + desc->block - 1) / desc->block,
                            .layers = 2 + desc->nodes + CUT_NODES_MAX,
                        });
}

bool vpl_cut_pass_init(struct vpl_cut_pass *pass, const struct vpl_cut_desc *desc) {
    assert(desc->nodes <= CUT_NODES_MAX);
    *pass = (struct vpl_cut_pass){.desc = *desc};
    if (init_program(&pass->program, desc->clamp) &&
        (!desc->later || init_program(&pass->later_program, desc->later_clamp)) &&
        init_cuts(&pass->cuts, desc) &&
        buffer_init(&pass->params, "cut parameters", sizeof(struct vpl_cut_params), NULL))
        return true;
    vpl_cut_pass_free(pass);
    return false;
}

void vpl_cut_pass_free(struct vpl_cut_pass *pass) {
    programs_free(&pass->program, &pass->later_program);
    texture_free(&pass->cuts.texture);
    buffer_free(&pass->params);
    *pass = (struct vpl_cut_pass){0};
}

static void write_params(const struct vpl_cut_pass *pass, const struct frame *frame) {
    const struct vpl_cut_desc *desc = &pass->desc;
    struct vpl_cut_params params = {
        .blocks = {pass->cuts.texture.desc.width, pass->cuts.texture.desc.height},
        .block = desc->block,
        .leaves = pass->cuts.tree->leaves,
        .nodes = desc->nodes,
        .more_nodes = CUT_NODES_MAX,
        .tolerance = desc->tolerance,
        .clamp_at = desc->clamp_value / (frame->geometry->radius * frame->geometry->radius),
    };
    buffer_write(&pass->params, 0, sizeof params, &params);
}

void vpl_cut_pass_render(struct vpl_cut_pass *pass, const struct frame *frame,
                         const struct gbuffer *gbuffer, const struct vpl_tree *tree, bool later) {
    const struct texture_desc *blocks = &pass->cuts.texture.desc;
    pass->cuts.tree = tree;
    write_params(pass, frame);
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "cuts",
                   .program = later ? pass->later_program : pass->program,
                   .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                                {UNIT_VPLS, tree->vpls},
                                {UNIT_TREE_NODES, tree->nodes.id},
                                {UNIT_TREE_REPRESENTATIVES, tree->representatives.id}},
                   .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
                   .images = {{IMAGE_CUTS, &pass->cuts.texture, 0, GL_WRITE_ONLY}},
                   .barriers = GL_TEXTURE_FETCH_BARRIER_BIT,
               });
    pass_dispatch((blocks->width + CUT_GROUP - 1) / CUT_GROUP,
                  (blocks->height + CUT_GROUP - 1) / CUT_GROUP, 1);
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    pass_end(frame->timers);
}
