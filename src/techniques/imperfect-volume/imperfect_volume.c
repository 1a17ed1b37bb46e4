/* Indirect light or ambient occlusion in voxels made of points [Mavridis and Papaioannou 2011]: the
 * other family of techniques, without virtual lights. Its cost hardly depends on pixels. */
#include "base/memory.h"
#include "passes/frame.h"
#include "passes/visibility/shadow_map.h"
#include "techniques/imperfect-volume/voxels.h"
#include "techniques/many_lights.h"
#include "techniques/volume.h"

/* Texels a side of a light's shadow map: finer than voxels. */
enum { SHADOW_SIZE = 512 };

/* Ambient radiance of volume=ao, over the irradiance that the lights could make across the scene */
static const float ambient = .1F;

struct imperfect_volume {
    struct volume_light light;
    struct shadow_map_pass shadows; /* volume=gi */
    struct voxel_view voxels;       /* zeroed until somebody looks at them */
    struct drawn_output drawn;      /* these */
};

static void free_state(void *state) {
    struct imperfect_volume *technique = state;
    if (technique) {
        volume_light_free(&technique->light);
        shadow_map_pass_free(&technique->shadows);
        voxel_view_free(&technique->voxels);
    }
    free(technique);
}

static bool is_lit(const struct imperfect_volume *technique) {
    return technique->light.volume.desc.channels == VOLUME_RADIANCE;
}

static const struct irradiance *draw_voxels(void *state, struct renderer *renderer,
                                            const struct frame *frame,
                                            const struct gbuffer *gbuffer) {
    struct imperfect_volume *technique = state;
    struct voxel_view *view = &technique->voxels;
    (void)renderer;
    if (!voxel_view_fit(view, &technique->light, gbuffer->width, gbuffer->height))
        return NULL;
    if (!view->drawn)
        voxel_view_draw(view, frame, gbuffer, &technique->light);
    view->drawn = true;
    return &view->picture;
}

static bool init(void **state, const struct technique_desc *desc) {
    struct imperfect_volume *technique = *state = mem_alloc(1, sizeof *technique);
    const struct volume_settings *own =
        settings_of(struct volume_settings, desc->settings, &volume_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    bool lit = own->volume == VOLUME_LIGHT_GI;
    technique->drawn = (struct drawn_output){.draw = draw_voxels, .state = technique};
    return volume_light_init(&technique->light,
                             &(struct volume_light_desc){
                                 .settings = desc->settings,
                                 .scene = desc->scene,
                                 .geometry = desc->geometry,
                                 .width = desc->width,
                                 .height = desc->height,
                                 .channels = lit ? VOLUME_RADIANCE : VOLUME_VISIBILITY,
                                 .bounces = lit ? lights->bounces : 1,
                                 .medium = desc->medium,
                             }) &&
           (!lit || shadow_map_pass_init(&technique->shadows,
                                         &(struct shadow_map_desc){SHADOW_SIZE, *desc->lights}));
}

static bool resize(void *state, int width, int height) {
    struct imperfect_volume *technique = state;
    return irradiance_resize(&technique->light.reconstruct.irradiance, width, height);
}

static bool update(void *state, const struct geometry *geometry) {
    struct imperfect_volume *technique = state;
    return volume_light_update(&technique->light, geometry);
}

static bool follows_camera(const void *state) {
    const struct imperfect_volume *technique = state;
    return technique->light.settings.reprojection;
}

static void render_lights(void *state, const struct frame *frame) {
    struct imperfect_volume *technique = state;
    if (!is_lit(technique)) {
        volume_light_render(&technique->light, frame, NULL, ambient * 3.14159265F);
        return;
    }
    shadow_map_pass_render(&technique->shadows, frame);
    volume_light_render(&technique->light, frame, technique->shadows.maps, frame->irradiance_scale);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct imperfect_volume *technique = state;
    technique->voxels.drawn = false;
    volume_light_render_view(&technique->light, frame, gbuffer);
}

static struct contribution contribution(const void *state) {
    const struct imperfect_volume *technique = state;
    return (struct contribution){.irradiance = &technique->light.reconstruct.irradiance};
}

static void outputs(const void *state, struct output_list *list) {
    const struct imperfect_volume *technique = state;
    if (is_lit(technique))
        output_add(list, &(struct output){"voxels", "voxels of surfaces, in their reflected light",
                                          OUTPUT_VOXELS, &technique->drawn});
}

static const struct settings_part *const parts[] = {&lights_part, &volume_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "as published: 19 points a triangle, order 2, pixels of the camera",
     "volume.published=on volume.reprojection=on volume.voxel-points=19 volume.order=2", NULL},
    {NULL}};

extern const struct technique imperfect_volume_technique;
const struct technique imperfect_volume_technique = {
    .name = "imperfect-volume",
    .help = "voxels made of points, with light as spherical harmonics",
    .parts = parts,
    .presets = presets,
    .init = init,
    .free = free_state,
    .resize = resize,
    .update = update,
    .render_lights = render_lights,
    .follows_camera = follows_camera,
    .render_view = render_view,
    .contribution = contribution,
    .outputs = outputs,
};
