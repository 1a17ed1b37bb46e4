#include "viewer/inspect.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/inspect.h"
#include "shared/visibility.h"

#include <cglm/util.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct inspect_row inspect_rows[SHOW_COUNT] = {
    [SHOW_PICTURE] = {"picture", "what the technique makes"},
    [SHOW_NORMAL] = {"normals", "G-buffer: world normals as colours"},
    [SHOW_ALBEDO] = {"albedo", "G-buffer: the surfaces' own colours"},
    [SHOW_DEPTH] = {"depth", "G-buffer: near is bright"},
    [SHOW_RSM_NORMAL] = {"RSM normals", "reflective shadow map: what the light sees"},
    [SHOW_RSM_ALBEDO] = {"RSM albedo", "reflective shadow map: the surfaces' own colours"},
    [SHOW_RSM_DEPTH] = {"RSM depth", "reflective shadow map: near to the light is bright"},
    [SHOW_VPLS] = {"VPLs", "virtual point lights, in the colour of their light"},
    [SHOW_CLUSTERS] = {"clusters", "VPLs in the colour of their VAL, with the VALs' rectangles and "
                                   "normals"},
    [SHOW_MAP_DEPTH] = {"VAL depth maps", "paraboloid depth maps from the VALs"},
    [SHOW_BASIS_COS] = {"basis cos",
                        "Fourier bases cos c_k z of the depth maps; three terms as RGB"},
    [SHOW_BASIS_SIN] = {"basis sin", "Fourier bases sin c_k z; three terms as RGB"},
    [SHOW_BASIS_Z_COS] = {"basis z cos", "z cos c_k z, for the mean depth of blockers"},
    [SHOW_BASIS_Z_SIN] = {"basis z sin", "z sin c_k z, for the mean depth of blockers"},
    [SHOW_VISIBILITY] = {"visibility", "the soft shadow of each VAL alone [Dong 2009 Fig. 9]"},
    [SHOW_GATHERED] = {"interleaved", "irradiance before the blur, in tiles of the pattern"},
    [SHOW_BLURRED] = {"irradiance", "after the blur, before the surfaces' colours"},
};

enum { SHEET_GAP = 6 }; /* pixels of a monitor of scale 1 */

bool inspect_init(struct inspect *inspect) {
    *inspect = (struct inspect){0};
    if (program_init(&inspect->program,
                     &(struct program_desc){.vertex = "fullscreen.vert",
                                            .fragment = "viewer/inspect.frag"}) &&
        buffer_init(&inspect->params, "inspect parameters", sizeof(struct inspect_params), NULL) &&
        buffer_init(&inspect->visibility_params, "inspect visibility parameters",
                    sizeof(struct visibility_params), NULL) &&
        marks_init(&inspect->marks))
        return true;
    inspect_free(inspect);
    return false;
}

static void free_canvas(struct inspect *inspect) {
    framebuffer_free(&inspect->framebuffer);
    texture_free(&inspect->canvas);
}

void inspect_free(struct inspect *inspect) {
    program_free(&inspect->program);
    program_free(&inspect->visibility_program);
    buffer_free(&inspect->params);
    buffer_free(&inspect->visibility_params);
    free_canvas(inspect);
    marks_free(&inspect->marks);
}

/* --- what there is --- */

/* The buffer that is shown; NULL where the technique has none. */
static const struct texture *source_of(const struct renderer *renderer, enum inspect_kind kind) {
    struct technique_outputs outputs;
    renderer_outputs(renderer, &outputs);
    struct contribution contribution = renderer_contribution(renderer);
    const struct basis_maps *basis = outputs.basis_maps;
    switch (kind) {
    case SHOW_NORMAL:
        return &renderer->gbuffer.normal;
    case SHOW_ALBEDO:
        return &renderer->gbuffer.albedo;
    case SHOW_DEPTH:
        return &renderer->gbuffer.depth;
    case SHOW_RSM_NORMAL:
        return outputs.rsm ? &outputs.rsm->normal : NULL;
    case SHOW_RSM_ALBEDO:
        return outputs.rsm ? &outputs.rsm->albedo : NULL;
    case SHOW_RSM_DEPTH:
        return outputs.rsm ? &outputs.rsm->depth : NULL;
    case SHOW_VPLS:
        return outputs.vpls ? &renderer->composite.display : NULL;
    case SHOW_CLUSTERS:
        return outputs.val_views ? &renderer->composite.display : NULL;
    case SHOW_MAP_DEPTH:
        return outputs.depth_maps ? &outputs.depth_maps->depth : NULL;
    case SHOW_BASIS_COS:
        return basis ? &basis->cos : NULL;
    case SHOW_BASIS_SIN:
        return basis ? &basis->sin : NULL;
    case SHOW_BASIS_Z_COS:
        return basis ? &basis->z_cos : NULL;
    case SHOW_BASIS_Z_SIN:
        return basis ? &basis->z_sin : NULL;
    case SHOW_VISIBILITY:
        return outputs.val_views ? &outputs.depth_maps->depth : NULL;
    case SHOW_GATHERED:
        return outputs.gathered ? &outputs.gathered->texture : NULL;
    case SHOW_BLURRED:
        return contribution.irradiance ? &contribution.irradiance->texture : NULL;
    case SHOW_PICTURE:
    case SHOW_COUNT:
        break;
    }
    return &renderer->composite.display;
}

int inspect_layers(const struct renderer *renderer, enum inspect_kind kind) {
    const struct texture *source = source_of(renderer, kind);
    return source ? source->desc.layers : 0;
}

static int mode_of(enum inspect_kind kind) {
    static const int modes[SHOW_COUNT] = {
        [SHOW_PICTURE] = INSPECT_DIMMED,
        [SHOW_NORMAL] = INSPECT_NORMAL,
        [SHOW_ALBEDO] = INSPECT_ALBEDO,
        [SHOW_DEPTH] = INSPECT_DEPTH,
        [SHOW_RSM_NORMAL] = INSPECT_NORMAL,
        [SHOW_RSM_ALBEDO] = INSPECT_ALBEDO,
        [SHOW_RSM_DEPTH] = INSPECT_LIGHT_DEPTH,
        [SHOW_VPLS] = INSPECT_DIMMED,
        [SHOW_CLUSTERS] = INSPECT_DIMMED,
        [SHOW_MAP_DEPTH] = INSPECT_MAP_DEPTH,
        [SHOW_BASIS_COS] = INSPECT_BASIS,
        [SHOW_BASIS_SIN] = INSPECT_BASIS,
        [SHOW_BASIS_Z_COS] = INSPECT_SIGNED_BASIS,
        [SHOW_BASIS_Z_SIN] = INSPECT_SIGNED_BASIS,
        [SHOW_VISIBILITY] = INSPECT_VISIBILITY,
        [SHOW_GATHERED] = INSPECT_IRRADIANCE,
        [SHOW_BLURRED] = INSPECT_IRRADIANCE,
    };
    return modes[kind];
}

/* --- sheets --- */

struct sheet {
    int columns, rows, cell_width, cell_height; /* cells with their gaps, pixels */
};

/* The columns that make cells of that shape largest. */
static struct sheet lay_out(const struct inspect_choice *choice, int layers, float aspect) {
    struct sheet best = {1, layers, 1, 1};
    for (int columns = 1; columns <= layers; columns++) {
        int rows = (layers + columns - 1) / columns;
        float across = (float)choice->width / (float)columns,
              down = (float)choice->height / (float)rows;
        int height = (int)fminf(across / aspect, down);
        if (height > best.cell_height)
            best = (struct sheet){columns, rows, (int)((float)height * aspect), height};
    }
    return best;
}

/* Of one layer as it is shown. */
static float aspect_of(const struct renderer *renderer, enum inspect_kind kind) {
    const struct texture *source = source_of(renderer, kind);
    bool on_screen = kind == SHOW_VISIBILITY;
    return on_screen ? (float)renderer->desc.width / (float)renderer->desc.height
                     : (float)source->desc.width / (float)source->desc.height;
}

int inspect_sheet_layer(const struct renderer *renderer, const struct inspect_choice *choice,
                        float x, float y) {
    int layers = inspect_layers(renderer, choice->kind);
    struct sheet sheet = lay_out(choice, layers, aspect_of(renderer, choice->kind));
    int column = (int)(x * (float)sheet.columns), row = (int)(y * (float)sheet.rows);
    int layer = row * sheet.columns + column;
    bool inside = x >= 0 && y >= 0 && column < sheet.columns && row < sheet.rows;
    return inside && layer < layers ? layer : -1;
}

/* --- drawing --- */

static bool fit_canvas(struct inspect *inspect, int width, int height) {
    if (inspect->framebuffer && inspect->canvas.desc.width == width &&
        inspect->canvas.desc.height == height)
        return true;
    free_canvas(inspect);
    return texture_init(&inspect->canvas, &(struct texture_desc){.label = "inspected buffer",
                                                                 .format = GL_RGBA8,
                                                                 .width = width,
                                                                 .height = height}) &&
           framebuffer_init(&inspect->framebuffer,
                            &(struct framebuffer_desc){.label = "inspected buffer",
                                                       .colors = {&inspect->canvas}});
}

/* The technique's lookup may have changed since the last time. */
static bool fit_visibility(struct inspect *inspect, const struct visibility_desc *desc) {
    inspect->visibility = *desc;
    program_free(&inspect->visibility_program);
    char *defines = visibility_defines(desc);
    bool ok = program_init(&inspect->visibility_program,
                           &(struct program_desc){.vertex = "fullscreen.vert",
                                                  .fragment = "viewer/inspect_visibility.frag",
                                                  .defines = defines});
    free(defines);
    return ok;
}

static void draw_layers(const struct inspect *inspect, const struct frame *frame,
                        const struct texture *source) {
    bool plane = source->desc.target == GL_TEXTURE_2D;
    pass_set_state(&(struct pass_state){
        .name = "inspect",
        .program = inspect->program,
        .framebuffer = inspect->framebuffer,
        .width = inspect->canvas.desc.width,
        .height = inspect->canvas.desc.height,
        .textures = {{plane ? UNIT_INSPECTED_PLANE : UNIT_INSPECTED_LAYERS, source->id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHT, frame->light},
                   {BLOCK_PASS, &inspect->params}},
    });
    pass_draw_fullscreen(1);
}

static void draw_visibility(const struct inspect *inspect, const struct frame *frame,
                            const struct gbuffer *gbuffer,
                            const struct technique_outputs *outputs) {
    struct pass_state state = {
        .name = "inspect visibility",
        .program = inspect->visibility_program,
        .framebuffer = inspect->framebuffer,
        .width = inspect->canvas.desc.width,
        .height = inspect->canvas.desc.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &inspect->params}},
    };
    visibility_add(&state, &inspect->visibility, &inspect->visibility_params,
                   &(struct visibility_inputs){.views = outputs->val_views,
                                               .depth = outputs->depth_maps,
                                               .bases = outputs->basis_maps});
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

/* The flux of a VPL of albedo 1/2. */
static float usual_flux(const struct renderer *renderer, int vpl_count) {
    const struct light_block *light = &renderer->light_block;
    float brightest = fmaxf(light->intensity[0], fmaxf(light->intensity[1], light->intensity[2]));
    return .5F * brightest * light->measure / (float)vpl_count;
}

static void draw_marks(const struct inspect *inspect, const struct renderer *renderer,
                       const struct frame *frame, const struct technique_outputs *outputs,
                       const struct inspect_choice *choice) {
    bool one_shadow = choice->kind == SHOW_VISIBILITY;
    marks_draw(&inspect->marks, frame, &renderer->gbuffer, outputs,
               &(struct marks_desc){
                   .framebuffer = inspect->framebuffer,
                   .width = inspect->canvas.desc.width,
                   .height = inspect->canvas.desc.height,
                   .scale = choice->scale,
                   .by_cluster = choice->kind != SHOW_VPLS,
                   .with_vpls = !one_shadow,
                   .with_vals = choice->kind != SHOW_VPLS,
                   .chosen = one_shadow ? choice->layer : choice->chosen,
                   .only_chosen = one_shadow,
                   .usual_flux = usual_flux(renderer, outputs->vpls->count),
               });
}

static void write_params(const struct inspect *inspect, const struct renderer *renderer,
                         const struct frame *frame, const struct inspect_choice *choice,
                         const struct sheet *sheet, int layers) {
    const struct geometry *geometry = renderer->desc.geometry;
    struct inspect_params params = {
        .kind = mode_of(choice->kind),
        .first_layer = choice->layer < 0 ? 0 : choice->layer,
        .layer_count = layers,
        .exposure = exp2f(renderer_exposure(renderer)) / ((float)GLM_PI * frame->irradiance_scale),
    };
    if (sheet) {
        params.columns = sheet->columns;
        params.rows = sheet->rows;
        params.cell[0] = (float)sheet->cell_width;
        params.cell[1] = (float)sheet->cell_height;
        params.gap = SHEET_GAP * choice->scale;
    }
    memcpy(params.center, geometry->center, sizeof geometry->center);
    params.radius = geometry->radius;
    buffer_write(&inspect->params, 0, sizeof params, &params);
}

bool inspect_draw(struct inspect *inspect, struct renderer *renderer,
                  const struct inspect_choice *choice) {
    struct technique_outputs outputs;
    renderer_outputs(renderer, &outputs);
    struct frame frame = renderer_frame(renderer);
    const struct texture *source = source_of(renderer, choice->kind);
    bool visibility = choice->kind == SHOW_VISIBILITY;
    int layers = source->desc.layers;
    bool whole = layers > 1 && choice->layer < 0;
    struct sheet sheet = lay_out(choice, layers, aspect_of(renderer, choice->kind));
    /* One layer is shown in its own size, a sheet in what room there is. */
    int width = visibility ? renderer->desc.width : source->desc.width;
    int height = visibility ? renderer->desc.height : source->desc.height;
    if (whole) {
        width = sheet.columns * sheet.cell_width;
        height = sheet.rows * sheet.cell_height;
    }
    if (!fit_canvas(inspect, width, height) ||
        (visibility && !fit_visibility(inspect, outputs.visibility)))
        return false;
    write_params(inspect, renderer, &frame, choice, whole ? &sheet : NULL, layers);
    if (visibility)
        draw_visibility(inspect, &frame, &renderer->gbuffer, &outputs);
    else
        draw_layers(inspect, &frame, source);
    if (choice->kind == SHOW_VPLS || choice->kind == SHOW_CLUSTERS || (visibility && !whole))
        draw_marks(inspect, renderer, &frame, &outputs, choice);
    return true;
}
