#include "techniques/implicit-visibility/interpolate.h"

#include "base/memory.h"
#include "gl/program.h"
#include "passes/frame.h"

#include <math.h>
#include <string.h>

/* How far an element reaches, over the longest edge of a cut triangle: all of a surface has some */
static const float reach = 1.2F;

enum { CELLS_MAX = 1 << 20 };

bool interpolate_pass_init(struct interpolate_pass *pass, int width, int height) {
    *pass = (struct interpolate_pass){0};
    if (program_init(&pass->program,
                     &(struct program_desc){
                         .screen = {"techniques/implicit-visibility/interpolate.frag"}}) &&
        irradiance_init(&pass->irradiance, "irradiance of elements", GL_RGBA16F, width, height,
                        1) &&
        buffer_init(&pass->params, "element grid", sizeof pass->grid, NULL))
        return true;
    interpolate_pass_free(pass);
    return false;
}

static void free_room(struct interpolate_pass *pass) {
    buffers_free(&pass->cells, &pass->elements);
    mem_free(pass->firsts, pass->texels);
    pass->firsts = NULL;
    pass->texels = NULL;
}

void interpolate_pass_free(struct interpolate_pass *pass) {
    free_room(pass);
    program_free(&pass->program);
    irradiance_free(&pass->irradiance);
    buffer_free(&pass->params);
    *pass = (struct interpolate_pass){0};
}

/* Cells as wide as elements reach, wider where there would be too many; and a margin of one around
 * them. */
static void fit_grid(struct interpolate_pass *pass, float wanted, const struct geometry *geometry) {
    struct element_grid_params *grid = &pass->grid;
    double count = INFINITY;
    for (grid->cell = wanted; count > CELLS_MAX; grid->cell *= 1.1F) {
        count = 1;
        for (int c = 0; c < 3; c++) {
            double extent = (double)(geometry->bounds_max[c] - geometry->bounds_min[c]);
            double cells = floor(extent / (double)grid->cell) + 3;
            pass->cells_along[c] = (int)fmin(cells, CELLS_MAX);
            count *= cells;
        }
        if (count <= CELLS_MAX)
            break;
    }
    grid->cells_x = pass->cells_along[0];
    grid->cells_y = pass->cells_along[1];
    grid->cells_z = pass->cells_along[2];
    for (int c = 0; c < 3; c++)
        grid->low[c] = geometry->bounds_min[c] - grid->cell;
    pass->cell_count = (int)count;
}

bool interpolate_pass_fit(struct interpolate_pass *pass, const struct elements *elements,
                          const struct geometry *geometry) {
    free_room(pass);
    fit_grid(pass, fmaxf(reach * elements->edge, geometry->radius * 1e-6F), geometry);
    pass->element_count = elements->count;
    const size_t cells = (size_t)pass->cell_count + 1;
    const size_t texels = ELEMENT_TEXELS * (size_t)elements->count;
    pass->firsts = mem_alloc(cells, sizeof *pass->firsts);
    pass->texels = mem_alloc(texels, sizeof *pass->texels);
    return buffer_init(&pass->cells, "cells of elements", cells * sizeof *pass->firsts, NULL) &&
           buffer_init(&pass->elements, "elements", texels * sizeof *pass->texels, NULL);
}

static int cell_of(const struct interpolate_pass *pass, vec3s position) {
    const struct element_grid_params *grid = &pass->grid;
    const int *along = pass->cells_along;
    int cell[3];
    for (int c = 0; c < 3; c++) {
        int at = (int)((position.raw[c] - grid->low[c]) / grid->cell);
        cell[c] = at < 1 ? 1 : at > along[c] - 2 ? along[c] - 2 : at;
    }
    return (cell[2] * along[1] + cell[1]) * along[0] + cell[0];
}

/* firsts[c + 1] counts up from the cell's start to its end. */
static void find_firsts(struct interpolate_pass *pass, const struct elements *elements) {
    uint32_t *firsts = pass->firsts, sum = 0;
    memset(firsts, 0, ((size_t)pass->cell_count + 1) * sizeof *firsts);
    for (int i = 0; i < elements->count; i++)
        firsts[cell_of(pass, elements->items[i].position) + 1]++;
    for (int c = 1; c <= pass->cell_count; c++) {
        uint32_t count = firsts[c];
        firsts[c] = sum;
        sum += count;
    }
}

void interpolate_pass_write(struct interpolate_pass *pass, const struct elements *elements,
                            const struct element_light *light, const struct links *links,
                            float scale) {
    pass->grid.scale = scale;
    find_firsts(pass, elements);
    for (int i = 0; i < elements->count; i++) {
        const struct element *element = &elements->items[i];
        uint32_t to = pass->firsts[cell_of(pass, element->position) + 1]++;
        float(*texels)[4] = pass->texels + (size_t)ELEMENT_TEXELS * to;
        float open = 1 - links->buried[i];
        memcpy(texels[0], element->position.raw, 3 * sizeof(float));
        memcpy(texels[1], element->normal.raw, 3 * sizeof(float));
        memcpy(texels[2], light->irradiance[i], 3 * sizeof(float));
        texels[2][3] = (float)i;
        texels[0][3] = open * open * open * open;
        texels[1][3] = element->pane;
    }
    buffer_write(&pass->params, 0, sizeof pass->grid, &pass->grid);
    buffer_write(&pass->cells, 0, ((size_t)pass->cell_count + 1) * sizeof *pass->firsts,
                 pass->firsts);
    if (elements->count > 0)
        buffer_write(&pass->elements, 0,
                     (size_t)ELEMENT_TEXELS * (size_t)elements->count * sizeof *pass->texels,
                     pass->texels);
}

void interpolate_pass_render(const struct interpolate_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer) {
    pass_begin(frame->timers,
               &(struct pass_state){
                   .name = "interpolate",
                   .program = pass->program,
                   .framebuffer = pass->irradiance.framebuffer,
                   .width = pass->irradiance.width,
                   .height = pass->irradiance.height,
                   .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
                   .storages = {{STORAGE_ELEMENT_CELLS, &pass->cells},
                                {STORAGE_ELEMENTS, &pass->elements}},
                   .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &pass->params}},
               });
    pass_set_ints(LOCATION_OF_PANES, frame->of_panes, 0, 0, 0);
    pass_draw_fullscreen(1);
    pass_end(frame->timers);
}
