/* Matrix row-column sampling [Hašan et al. 2007]. Some rows of the matrix of pixels x VPLs show
 * which VPLs are alike. One VPL of each cluster is drawn for all pixels, with a map of its own.
 *
 * It reads the rows back and clusters on the CPU: the GPU waits once a frame. The random numbers
 * are the same in each frame, so that a frame depends on its time alone. */
#include "base/error.h"
#include "base/memory.h"
#include "passes/frame.h"
#include "shared/vpl.h"
#include "techniques/row-column/columns.h"
#include "techniques/row-column/rows.h"
#include "techniques/vpl_maps.h"

/* As wide as textures are everywhere. */
enum { LIGHTS_OF_MATRIX = 16384 };

enum {
    MAP_BATCH = 64,        /* maps that are in memory at once */
    COLUMN_INTERLEAVE = 2, /* of the chosen VPLs, which are fewer; at most gather.interleave */
};

struct row_column_settings {
    int rows, columns; /* r, c */
};

#define ROW(name) offsetof(struct row_column_settings, name)

static const struct option table[] = {
    {"rows", 0, OPTION_INT, ROW(rows), 100, 1, 16384, .label = "rows (pixels)",
     .help = "number of rows: pixels that test all VPLs;\n"
             "raise if small regions are too dark or bright"},
    {"columns", 0, OPTION_INT, ROW(columns), 200, 1, 16384, .label = "columns (lights)",
     .help = "largest number of columns: VPLs drawn for\n"
             "all pixels; raise against hard shadow edges"},
    {NULL},
};

static const struct settings_part own_part = {"row-column", "rows and columns", table,
                                              sizeof(struct row_column_settings)};

/* VPLs of the first bounce; of later ones. */
enum { FIRST, LATER, KINDS };

struct row_column {
    struct many_lights lights;
    struct paraboloid_pass paraboloid;
    struct vpl_maps maps;
    struct rows_pass rows;
    struct columns columns;
    int seed;
    struct vpl_buffer chosen[KINDS]; /* those VPLs that are drawn */
    /* On the CPU: the matrix, all VPLs, their powers, and the chosen ones. */
    float (*matrix)[4];
    struct vpl *vpls;
    float *powers;
    struct column *list;
    struct vpl *room;
};

static void free_state(void *state) {
    struct row_column *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        paraboloid_pass_free(&technique->paraboloid);
        vpl_maps_free(&technique->maps);
        rows_pass_free(&technique->rows);
        columns_free(&technique->columns);
        for (int kind = 0; kind < KINDS; kind++)
            vpl_buffer_free(&technique->chosen[kind]);
        mem_free(technique->matrix, technique->vpls, technique->powers, technique->list,
                 technique->room);
    }
    free(technique);
}

/* Of the gather. */
static int interleave_of(const struct settings *settings) {
    const struct gather_settings *gather =
        settings_of(struct gather_settings, settings, &gather_part);
    return COLUMN_INTERLEAVE < gather->interleave ? COLUMN_INTERLEAVE : gather->interleave;
}

static bool check(const struct settings *settings) {
    const struct row_column_settings *own =
        settings_of(struct row_column_settings, settings, &own_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, settings, &lights_part);
    int n = interleave_of(settings), most = lights->vpls;
    most += lights->bounces > 1 ? lights->paths : 0;
    if (own->columns < n * n || lights->vpls < n * n)
        return error_set("row-column needs at least %d columns and VPLs", n * n);
    return most <= LIGHTS_OF_MATRIX ||
           error_set("%d VPLs of all bounces are more than %d, which row-column takes", most,
                     LIGHTS_OF_MATRIX);
}

/* --- init ------------------------------------------------------------------------------------- */

static bool init_rows(struct row_column *technique, const struct technique_desc *desc, int lights) {
    const struct row_column_settings *own =
        settings_of(struct row_column_settings, desc->settings, &own_part);
    const struct gather_desc *gather = &technique->lights.gather.desc;
    return rows_pass_init(&technique->rows, &(struct rows_desc){
                                                .rows = own->rows,
                                                .lights = lights,
                                                .clamp = gather->clamp,
                                                .later = GATHER_CLAMP_PATCH,
                                                .has_later = gather->later,
                                                .visibility = gather->visibility,
                                            });
}

static bool init_choice(struct row_column *technique, const struct technique_desc *desc,
                        int lights) {
    const struct row_column_settings *own =
        settings_of(struct row_column_settings, desc->settings, &own_part);
    const struct lights_settings *lights_settings =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    size_t count = (size_t)lights, rows = (size_t)own->rows;
    technique->seed = lights_settings->seed;
    technique->matrix = mem_alloc(count * rows, sizeof *technique->matrix);
    technique->vpls = mem_alloc(count, sizeof *technique->vpls);
    technique->powers = mem_alloc(count, sizeof *technique->powers);
    technique->list = mem_alloc((size_t)own->columns, sizeof *technique->list);
    technique->room = mem_alloc((size_t)own->columns, sizeof *technique->room);
    columns_init(&technique->columns, &(struct columns_desc){lights, own->rows, own->columns});
    return vpl_buffer_init(&technique->chosen[FIRST], "chosen VPLs", own->columns) &&
           vpl_buffer_init(&technique->chosen[LATER], "chosen VPLs of bounces", own->columns);
}

/* As many samples of the near field for each pixel as with the pattern that all have. */
static bool init(void **state, const struct technique_desc *desc) {
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    struct row_column *technique = *state = mem_alloc(1, sizeof *technique);
    struct settings settings = *desc->settings;
    struct technique_desc with_own = *desc;
    struct gather_settings gather = *settings_of(struct gather_settings, &settings, &gather_part);
    int n = interleave_of(&settings), before = gather.interleave;
    gather.near_samples = (gather.near_samples * n * n + before * before - 1) / (before * before);
    gather.interleave = n;
    settings_set(&settings, &gather_part, &gather);
    with_own.settings = &settings;
    int all = lights->vpls + (lights->bounces > 1 ? lights->paths : 0);
    struct many_lights_visibility visibility = {VISIBILITY_LOOKUP_PLANE, .map_per_vpl = true,
                                                .map_count = MAP_BATCH};
    return many_lights_init(&technique->lights, &with_own, &visibility) &&
           vpl_maps_init_true(&technique->maps, &technique->paraboloid, &with_own, MAP_BATCH) &&
           init_rows(technique, &with_own, all) && init_choice(technique, desc, all);
}

/* --- rows ------------------------------------------------------------------------------------- */

/* VPLs of their own that are as far apart as all: maps of these leave out as much of what
 * is near. */
static struct vpl_buffer with_sums_of(const struct vpl_buffer *vpls, const struct vpl_buffer *all) {
    struct vpl_buffer like = *vpls;
    like.sums = all->sums;
    return like;
}

static void render_rows(struct row_column *technique, const struct frame *frame,
                        const struct gbuffer *gbuffer, uint32_t seed) {
    struct many_lights *lights = &technique->lights;
    rows_pass_pick(&technique->rows, frame, gbuffer, seed);
    struct vpl_buffer pixels = with_sums_of(&technique->rows.pixels, &lights->vpls);
    gather_pass_write_params(&lights->gather, frame, &(struct gather_inputs){.count = 0});
    vpl_maps_drop(&technique->maps);
    for (int first = 0, count;
         (count = vpl_maps_render_batch(&technique->maps, frame, &pixels, first)) > 0;
         first += count) {
        struct rows_inputs inputs = {
            .vpls = &lights->vpls,
            .first = first,
            .count = count,
            .gather_params = &lights->gather.params,
            .visibility = vpl_maps_inputs(&technique->maps),
        };
        rows_pass_render(&technique->rows, frame, &inputs);
        inputs.vpls = &lights->bounce.vpls;
        inputs.first_light = lights->vpls.count;
        inputs.later = true;
        if (lights->bounces > 1)
            rows_pass_render(&technique->rows, frame, &inputs);
    }
    vpl_maps_drop(&technique->maps);
}

/* --- columns ---------------------------------------------------------------------------------- */

static void read_vpls(struct row_column *technique) {
    const struct many_lights *lights = &technique->lights;
    const struct vpl_buffer *buffers[KINDS] = {&lights->vpls, &lights->bounce.vpls};
    int count = 0;
    for (int kind = 0; kind < (lights->bounces > 1 ? KINDS : 1); kind++) {
        buffer_read(&buffers[kind]->buffer, 0,
                    (size_t)buffers[kind]->count * sizeof *technique->vpls,
                    &technique->vpls[count]);
        count += buffers[kind]->count;
    }
    for (int i = 0; i < count; i++) {
        const float *flux = technique->vpls[i].flux;
        technique->powers[i] = flux[0] + flux[1] + flux[2];
    }
}

/* VPLs of the list from `begin` on, as long as they are before `last`, with their weights; and dark
 * ones, so that each place of the pattern has one. Returns where it stopped. */
static int write_chosen(struct row_column *technique, int kind, int begin, int end, int last) {
    int n = technique->lights.gather.desc.interleave, count = 0, at = begin;
    for (; at < end && technique->list[at].light < last; at++) {
        struct vpl *vpl = &technique->room[count++];
        *vpl = technique->vpls[technique->list[at].light];
        for (int c = 0; c < 3; c++)
            vpl->flux[c] *= technique->list[at].weight;
    }
    for (; count > 0 && count < n * n; count++) {
        technique->room[count] = technique->room[0];
        for (int c = 0; c < 3; c++)
            technique->room[count].flux[c] = 0;
    }
    technique->chosen[kind].count = count;
    buffer_write(&technique->chosen[kind].buffer, 0, (size_t)count * sizeof *technique->room,
                 technique->room);
    return at;
}

static void choose_columns(struct row_column *technique, const struct frame *frame, uint32_t seed) {
    timer_begin(frame->timers, "columns");
    int all = technique->columns.desc.lights;
    rows_pass_read(&technique->rows, technique->matrix);
    read_vpls(technique);
    columns_cluster(&technique->columns, (const float(*)[4])technique->matrix,
                    technique->rows.pixels.count, technique->powers, seed);
    int count = columns_choose(&technique->columns, seed, technique->list);
    int later = write_chosen(technique, FIRST, 0, count, technique->lights.vpls.count);
    write_chosen(technique, LATER, later, count, all);
    timer_end(frame->timers);
}

/* --- the frame -------------------------------------------------------------------------------- */

static void render_lights(void *state, const struct frame *frame) {
    struct row_column *technique = state;
    vpl_maps_render_vpls(&technique->maps, &technique->lights, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct row_column *technique = state;
    struct many_lights *lights = &technique->lights;
    uint32_t seed = (uint32_t)technique->seed * 4096 + (uint32_t)frame->pass;
    render_rows(technique, frame, gbuffer, seed);
    choose_columns(technique, frame, seed);
    many_lights_begin(lights, frame, gbuffer);
    for (int kind = 0; kind < KINDS; kind++) {
        struct vpl_buffer chosen = with_sums_of(
            &technique->chosen[kind], kind == FIRST ? &lights->vpls : &lights->bounce.vpls);
        vpl_maps_gather(&technique->maps, lights, &chosen, kind == LATER, frame, gbuffer);
        vpl_maps_drop(&technique->maps);
    }
    many_lights_finish(lights, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct row_column *technique = state;
    many_lights_outputs(&technique->lights, &technique->lights.vpls, outputs);
    output_add(outputs, &(struct output){"chosen-vpl", "those that are drawn for all", OUTPUT_VPLS,
                                         &technique->chosen[FIRST]});
}

static const struct settings_part *const parts[] = {
    &lights_part, &own_part, &map_part, &caster_part, &gather_part, &blur_part, NULL};

static const struct preset presets[] = {MANY_LIGHTS_FAST,
                                        {"paper", "all columns at each pixel, no blur",
                                         "gather.interleave=1 gather.near-samples=64 blur.radius=0",
                                         NULL},
                                        {NULL}};

extern const struct technique row_column_technique;
const struct technique row_column_technique = {
    .name = "row-column",
    .help = "VPLs chosen by rows and columns of the matrix of pixels and VPLs",
    MANY_LIGHTS_TECHNIQUE,
    .refinement = &many_lights_refinement,
    .check = check,
    .resize = many_lights_resize,
};
