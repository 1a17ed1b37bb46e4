#include "quality/meter.h"

#include "base/error.h"
#include "metrics/colour.h"
#include "quality/picture.h"
#include "scene/caustics.h"

#include <cglm/util.h>
#include <math.h>

/* Pixels along each side of a sensor's frame: two tiles of the widest interleave pattern, whose
 * pixels all see the same point. */
enum { SENSOR_PIXELS = 16 };

/* Distance of a sensor's camera and width of its plane, over the scene's radius. */
static const float camera_distance = 1e-3F, sensor_size = 1e-4F;

/* Irradiance of a layer that has irradiance over pi. */
static double irradiance(const float *pixel, const struct image *image, const char *layer) {
    return GLM_PI * (double)rgb_luminance(pixel + image_find_channel(image, layer));
}

static bool read_frame(struct renderer *renderer, struct reading *reading) {
    struct image image;
    const double share = 1. / (SENSOR_PIXELS * SENSOR_PIXELS);
    *reading = (struct reading){0};
    if (!renderer_read_layers(renderer, &image))
        return false;
    for (int i = 0; i < SENSOR_PIXELS * SENSOR_PIXELS; i++) {
        const float *pixel = image_at(&image, i % SENSOR_PIXELS, i / SENSOR_PIXELS);
        reading->direct += share * irradiance(pixel, &image, "direct.R");
        reading->indirect += share * irradiance(pixel, &image, "indirect.R");
    }
    image_free(&image);
    return true;
}

static bool measure_all(struct renderer *renderer, const struct sensor *sensors, int count,
                        struct progress *progress, struct reading *readings) {
    float radius = renderer->desc.geometry->radius;
    bool ok = true;
    for (int i = 0; ok && i < count; i++) {
        struct renderer_desc desc = renderer->desc;
        camera_face(&desc.camera, &sensors[i], camera_distance * radius, sensor_size * radius);
        ok = renderer_follow(renderer, &desc);
        if (!ok)
            break;
        renderer_render(renderer);
        ok = read_frame(renderer, &readings[i]);
        progress_show(progress, (i + 1.) / count, "");
    }
    return ok;
}

bool meter_frames(const struct measure_desc *desc, const struct sensor *sensors, int count,
                  struct progress *progress, struct reading *readings) {
    const struct stage *stage = desc->stage;
    struct renderer_desc start = {.width = SENSOR_PIXELS,
                                  .height = SENSOR_PIXELS,
                                  .technique = desc->technique,
                                  .direct = desc->direct,
                                  .settings = desc->settings,
                                  .scene = &stage->scene,
                                  .geometry = &stage->geometry,
                                  .emitters = stage->emitters,
                                  .sensor = camera_distance * stage->geometry.radius,
                                  .keep_lights = true};
    struct renderer renderer;
    if (caustics_shown(&stage->scene, &desc->settings))
        return error_set("sensors do not measure caustics: caustics.surface=off");
    renderer_settings_roughen(&start.settings);
    camera_face(&start.camera, sensors, start.sensor, sensor_size * stage->geometry.radius);
    if (!technique_check(desc->technique, &start.settings) || !renderer_init(&renderer, &start))
        return false;
    bool ok = measure_all(&renderer, sensors, count, progress, readings);
    renderer_free(&renderer);
    return ok;
}

bool meter_paths(const struct stage *stage, const struct path_tracer_desc *desc,
                 const struct sensor *sensors, int count, struct reading *readings,
                 struct path_tracer_progress *reached) {
    struct path_tracer_desc own = *desc;
    struct image image;
    own.sensors = sensors;
    own.width = 1;
    own.height = count;
    own.seen = true;    /* tells the noise of direct light */
    own.centers = true; /* a jitter would round to the next sensor */
    if (!picture_trace_paths(stage, &own, &image, reached))
        return false;
    int direct_error = image_find_channel(&image, "standard_error.direct.Y");
    for (int i = 0; i < count; i++) {
        const float *pixel = image_at(&image, 0, i);
        readings[i].direct = irradiance(pixel, &image, "direct.R");
        readings[i].indirect = irradiance(pixel, &image, "indirect.R");
        readings[i].error = hypot(GLM_PI * (double)pixel[direct_error],
                                  irradiance(pixel, &image, "standard_error.R"));
    }
    image_free(&image);
    return true;
}
