#include "inspect/inspect.h"

#include "base/error.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "passes/frame.h"
#include "passes/maps.h"
#include "passes/vpls.h"
#include "shared/inspect.h"

#include <cglm/util.h>

#include <math.h>
#include <string.h>

enum { SHEET_GAP = 6 }; /* pixels of a monitor of scale 1 */

static bool make_blank(struct texture *texture, GLenum target) {
    return texture_init(
        texture, &(struct texture_desc){
                     .label = "nothing to inspect", .target = target, .format = GL_R8, .width = 1});
}

bool inspect_init(struct inspect *inspect) {
    *inspect = (struct inspect){0};
    if (program_init(&inspect->program,
                     &(struct program_desc){.screen = {"inspect/inspect.frag"}}) &&
        buffer_init(&inspect->params, "inspect parameters", sizeof(struct inspect_params), NULL) &&
        make_blank(&inspect->no_plane, GL_TEXTURE_2D) &&
        make_blank(&inspect->no_layers, GL_TEXTURE_2D_ARRAY) && marks_init(&inspect->marks))
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
    lookup_free(&inspect->visibility);
    buffer_free(&inspect->params);
    textures_free(&inspect->no_plane, &inspect->no_layers);
    free_canvas(inspect);
    marks_free(&inspect->marks);
    false_colours_free(&inspect->light);
}

/* --- what there is --- */

/* What is shown of an output. */
struct shown {
    enum output_kind kind;
    const struct vpl_buffer *vpls;
    const struct val_output *vals;
    const struct drawn_output *drawn; /* NULL: every frame has it */
    const struct texture *texture;    /* what is drawn, or the ground for marks */
    const struct texture *depth;      /* of normals: whether a surface is there */
    int width, height, layers;        /* of one layer in its own size, and how many */
};

/* By the output's kind. Marks lie on the picture. */
static const struct texture *texture_of(const struct renderer *renderer,
                                        const struct output *output) {
    switch (output->kind) {
    case OUTPUT_IRRADIANCE:
        return &((const struct irradiance *)output->source)->texture;
    case OUTPUT_NORMAL:
        return &((const struct gbuffer *)output->source)->normal;
    case OUTPUT_MAP_DEPTH:
        return &((const struct depth_maps *)output->source)->depth;
    case OUTPUT_VPLS:
    case OUTPUT_VALS:
    case OUTPUT_VISIBILITY:
    case OUTPUT_AO:
    case OUTPUT_ILLUMINANCE:
    case OUTPUT_LUMINANCE:
    case OUTPUT_VOXELS: /* of the same size */
        return &renderer->composite.display;
    default:
        return output->source;
    }
}

/* False where there is no such output. */
static bool find(struct shown *shown, const struct renderer *renderer, const char *name) {
    struct output_list outputs;
    renderer_outputs(renderer, &outputs);
    const struct output *output = output_find(&outputs, name);
    if (!output)
        return false;
    const struct texture *texture = texture_of(renderer, output);
    *shown =
        (struct shown){.kind = output->kind,
                       .vpls = output->kind == OUTPUT_VPLS ? output->source : output_vpls(&outputs),
                       .vals = output_vals(&outputs),
                       .texture = texture,
                       .width = texture->desc.width,
                       .height = texture->desc.height,
                       .layers = texture->desc.layers};
    if (shown->kind == OUTPUT_NORMAL)
        shown->depth = &((const struct gbuffer *)output->source)->depth;
    if (shown->kind == OUTPUT_VOXELS)
        shown->drawn = output->source;
    if (shown->kind == OUTPUT_VISIBILITY)
        shown->layers = shown->vals->maps.views->count;
    return true;
}

int inspect_layers(const struct renderer *renderer, const char *output) {
    struct shown shown;
    return find(&shown, renderer, output) ? shown.layers : 0;
}

const char *inspect_find(const struct renderer *renderer, enum output_kind kind) {
    struct output_list outputs;
    renderer_outputs(renderer, &outputs);
    for (int i = 0; i < outputs.count; i++)
        if (outputs.items[i].kind == kind)
            return outputs.items[i].name;
    return NULL;
}

bool inspect_is(const struct renderer *renderer, const char *output, enum output_kind kind) {
    struct shown shown;
    return find(&shown, renderer, output) && shown.kind == kind;
}

static struct sheet sheet_of(const struct shown *shown, const struct inspect_choice *choice) {
    return sheet_fit(choice->width, choice->height, shown->layers,
                     (float)shown->width / (float)shown->height);
}

bool inspect_sheet(const struct renderer *renderer, const struct inspect_choice *choice,
                   struct sheet *sheet) {
    struct shown shown;
    if (!find(&shown, renderer, choice->output) || shown.layers <= 1 || choice->layer >= 0)
        return false;
    *sheet = sheet_of(&shown, choice);
    return true;
}

int inspect_sheet_layer(const struct renderer *renderer, const struct inspect_choice *choice,
                        float x, float y) {
    struct shown shown;
    if (!find(&shown, renderer, choice->output))
        return -1;
    struct sheet sheet = sheet_of(&shown, choice);
    return sheet_layer_at(&sheet, x, y);
}

/* --- drawing --- */

static bool fit_canvas(struct inspect *inspect, int width, int height) {
    if (inspect->framebuffer && inspect->canvas.desc.width == width &&
        inspect->canvas.desc.height == height)
        return true;
    free_canvas(inspect);
    return framebuffer_init_target(
        &inspect->canvas, &inspect->framebuffer,
        &(struct texture_desc){
            .label = "inspected buffer", .format = GL_RGBA8, .width = width, .height = height});
}

static void draw_texture(const struct inspect *inspect, const struct frame *frame,
                         const struct texture *source, const struct texture *depth) {
    bool plane = source->desc.target == GL_TEXTURE_2D;
    pass_set_state(&(struct pass_state){
        .name = "inspect",
        .program = inspect->program,
        .framebuffer = inspect->framebuffer,
        .width = inspect->canvas.desc.width,
        .height = inspect->canvas.desc.height,
        .textures = {{UNIT_INSPECTED_PLANE, plane ? source->id : inspect->no_plane.id},
                     {UNIT_INSPECTED_LAYERS, plane ? inspect->no_layers.id : source->id},
                     {UNIT_GBUFFER_DEPTH, depth ? depth->id : inspect->no_layers.id}},
        .blocks = {{BLOCK_VIEW, frame->view},
                   {BLOCK_LIGHTS, frame->lights},
                   {BLOCK_PASS, &inspect->params}},
    });
    pass_draw_fullscreen(1);
}

static void draw_visibility(const struct inspect *inspect, const struct frame *frame,
                            const struct gbuffer *gbuffer, const struct val_output *vals) {
    struct pass_state state = {
        .name = "inspect visibility",
        .program = inspect->visibility.program,
        .framebuffer = inspect->framebuffer,
        .width = inspect->canvas.desc.width,
        .height = inspect->canvas.desc.height,
        .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                     {UNIT_GBUFFER_NORMAL, gbuffer->normal.id}},
        .blocks = {{BLOCK_VIEW, frame->view}, {BLOCK_PASS, &inspect->params}},
    };
    visibility_add(&state, vals->visibility, &inspect->visibility.params, &vals->maps);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

/* The mean flux of VPLs of albedo 1/2. */
static float usual_flux(const struct renderer *renderer, int vpl_count) {
    float sum = 0;
    for (int i = 0; i < renderer->light_block->count; i++) {
        const struct light *light = &renderer->light_block->sources[i];
        const float *rgb = light->intensity;
        sum += .5F * fmaxf(rgb[0], fmaxf(rgb[1], rgb[2])) * light->measure;
    }
    return sum / (float)vpl_count;
}

static void draw_marks(const struct inspect *inspect, const struct renderer *renderer,
                       const struct frame *frame, const struct shown *shown,
                       const struct inspect_choice *choice) {
    bool one_shadow = shown->kind == OUTPUT_VISIBILITY, vpls_alone = shown->kind == OUTPUT_VPLS;
    marks_draw(&inspect->marks, frame, &renderer->gbuffer,
               &(struct marks_desc){
                   .framebuffer = inspect->framebuffer,
                   .width = inspect->canvas.desc.width,
                   .height = inspect->canvas.desc.height,
                   .scale = choice->scale,
                   .vpls = one_shadow ? NULL : shown->vpls,
                   .vals = vpls_alone ? NULL : shown->vals,
                   .by_cluster = !vpls_alone,
                   .chosen = one_shadow ? choice->layer : choice->chosen,
                   .only_chosen = one_shadow,
                   .usual_flux = shown->vpls ? usual_flux(renderer, shown->vpls->count) : 0,
               });
}

/* Outputs that are drawn only when they are shown. */
static bool draw_asked(struct renderer *renderer, const struct frame *frame, struct shown *shown) {
    const struct drawn_output *drawn = shown->drawn;
    const struct irradiance *picture =
        drawn ? drawn->draw(drawn->state, renderer, frame, &renderer->gbuffer) : NULL;
    if (picture)
        shown->texture = &picture->texture;
    return picture || !drawn;
}

/* Without a shader: colours are those of `probe --map`. */
static bool draw_light(struct inspect *inspect, struct renderer *renderer, enum output_kind kind,
                       const struct inspect_choice *choice) {
    struct heat_map *light = &inspect->light;
    struct bitmap picture;
    if (!false_colours_init(light, renderer, kind, choice->unit, choice->top) ||
        !fit_canvas(inspect, light->width, light->height))
        return false;
    heat_map_draw_values(light, &picture);
    texture_write_bitmap(&inspect->canvas, &picture);
    bitmap_free(&picture);
    return true;
}

const struct heat_map *inspect_light(const struct inspect *inspect,
                                     const struct inspect_choice *choice) {
    return choice->output && inspect->light.values ? &inspect->light : NULL;
}

static int mode_of(enum output_kind kind) {
    static const int modes[] = {
        [OUTPUT_NORMAL] = INSPECT_NORMAL,         [OUTPUT_ALBEDO] = INSPECT_ALBEDO,
        [OUTPUT_DEPTH] = INSPECT_DEPTH,           [OUTPUT_SINGLE_DEPTH] = INSPECT_SINGLE_DEPTH,
        [OUTPUT_FACE_DEPTH] = INSPECT_FACE_DEPTH, [OUTPUT_IRRADIANCE] = INSPECT_IRRADIANCE,
        [OUTPUT_VPLS] = INSPECT_DIMMED,           [OUTPUT_VALS] = INSPECT_DIMMED,
        [OUTPUT_VISIBILITY] = INSPECT_VISIBILITY, [OUTPUT_MAP_DEPTH] = INSPECT_MAP_DEPTH,
        [OUTPUT_BASIS] = INSPECT_BASIS,           [OUTPUT_SIGNED_BASIS] = INSPECT_SIGNED_BASIS,
        [OUTPUT_AO] = INSPECT_IRRADIANCE,         [OUTPUT_AIRLIGHT] = INSPECT_IRRADIANCE,
        [OUTPUT_RADIANCE] = INSPECT_IRRADIANCE,   [OUTPUT_VOXELS] = INSPECT_IRRADIANCE,
    };
    _Static_assert(sizeof modes / sizeof *modes == OUTPUT_KINDS, "a mode for each kind");
    return modes[kind];
}

/* sheet NULL: one layer. */
static void write_params(const struct inspect *inspect, const struct renderer *renderer,
                         const struct frame *frame, const struct inspect_choice *choice,
                         const struct shown *shown, const struct sheet *sheet) {
    const struct geometry *geometry = renderer->desc.geometry;
    struct inspect_params params = {
        .kind = mode_of(shown->kind),
        .first_layer = choice->layer < 0 ? 0 : choice->layer,
        .layer_count = shown->layers,
        .exposure = exp2f(renderer_exposure(renderer)) / ((float)GLM_PI * frame->irradiance_scale),
    };
    if (shown->kind == OUTPUT_AO)
        params.exposure = 1;
    if (shown->kind == OUTPUT_AIRLIGHT) /* radiance, not irradiance */
        params.exposure *= (float)GLM_PI;
    if (shown->kind == OUTPUT_RADIANCE)
        params.exposure = exp2f(renderer_exposure(renderer));
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
    struct frame frame = renderer_frame(renderer);
    struct shown shown;
    if (!find(&shown, renderer, choice->output))
        return error_set("technique '%s' has no output '%s'", renderer->technique->name,
                         choice->output);
    false_colours_free(&inspect->light);
    if (shown.kind == OUTPUT_ILLUMINANCE || shown.kind == OUTPUT_LUMINANCE)
        return draw_light(inspect, renderer, shown.kind, choice);
    if (!draw_asked(renderer, &frame, &shown))
        return false;
    bool visibility = shown.kind == OUTPUT_VISIBILITY,
         whole = shown.layers > 1 && choice->layer < 0;
    struct sheet sheet = sheet_of(&shown, choice);
    /* One layer is shown in its own size, a sheet in what room there is. */
    int width = whole ? sheet.columns * sheet.cell_width : shown.width;
    int height = whole ? sheet.rows * sheet.cell_height : shown.height;
    if (!fit_canvas(inspect, width, height) ||
        (visibility && !lookup_fit(&inspect->visibility, "inspect/inspect_visibility.frag",
                                   shown.vals->visibility)))
        return false;
    write_params(inspect, renderer, &frame, choice, &shown, whole ? &sheet : NULL);
    if (visibility)
        draw_visibility(inspect, &frame, &renderer->gbuffer, shown.vals);
    else
        draw_texture(inspect, &frame, shown.texture, shown.depth);
    if (shown.kind == OUTPUT_VPLS || shown.kind == OUTPUT_VALS || (visibility && !whole))
        draw_marks(inspect, renderer, &frame, &shown, choice);
    return true;
}
