#define _POSIX_C_SOURCE 200809L
#include "render_support.h"

#include "gl/glsl.h"
#include "gl/memory.h"
#include "gl/program.h"
#include "inspect/lights.h"
#include "quality/picture.h"
#include "reference/channels.h"
#include "scene/lights/environment.h"
#include "scene/node.h"
#include "scene/placing.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

#include <dlfcn.h>

struct context *open_context(enum context_kind kind) {
    struct context *context = context_create(&(struct context_desc){.kind = kind, .debug = true});
    if (!context) {
        printf("    skipped: %s\n", error_get());
        skip();
    }
    return context;
}

/* How many objects of OpenGL there are, of the kinds that are named, by the functions that only
 * tests need; 0 where EGL does not give them. */
static int count_named_objects(void) {
    enum { NAMES = 20000 };
    static const char *const kinds[] = {"glIsTexture", "glIsBuffer", "glIsFramebuffer",
                                        "glIsVertexArray"};
    void *library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    void *(*getproc)(const char *) = NULL;
    int count = 0;
    if (library)
        *(void **)&getproc = dlsym(library, "eglGetProcAddress");
    for (size_t i = 0; getproc && i < sizeof kinds / sizeof *kinds; i++) {
        GLboolean (*is)(GLuint) = NULL;
        *(void **)&is = getproc(kinds[i]);
        for (GLuint name = 1; is && name < NAMES; name++)
            count += is(name) != 0;
    }
    if (library)
        dlclose(library);
    return count;
}

static int count_at_start;

int open_group_context(void **state) {
    *state = context_create(&(struct context_desc){.kind = CONTEXT_AUTO, .debug = true});
    if (!*state) {
        printf("    %s\n", error_get());
        return -1;
    }
    count_at_start = count_named_objects();
    return 0;
}

int close_group_context(void **state) {
    int messages = context_message_count(*state), objects = gpu_memory_object_count();
    int named = count_named_objects() - count_at_start, programs = program_use_count();
    printf("    OpenGL messages %d, GPU objects left %d, named %d, programs %d\n", messages,
           objects, named, programs);
    context_free(*state);
    if (messages != 0 || objects != 0 || named != 0 || programs != 0)
        exit(EXIT_FAILURE); /* of what fails here cmocka's status does not tell */
    return 0;
}

void ask_shader(const struct questions *questions) {
    enum { BLOCKS = sizeof questions->blocks / sizeof *questions->blocks };
    const char *shader = form("../test/support/%s", questions->shader);
    const bool asks = questions->asked;
    struct pass_state state = {.name = questions->shader};
    struct buffer blocks[BLOCKS] = {{0}}, asked = {0}, answers;
    struct timers untimed = {0};
    glsl_set_folder("glsl"); /* the test's own shader lies beside the test */
    check_ok(shader,
             program_init(&state.program, &(struct program_desc){.compute = shader,
                                                                 .defines = questions->defines}));
    glsl_set_folder(NULL);
    memcpy(state.textures, questions->textures, sizeof questions->textures);
    for (int i = 0; i < BLOCKS && questions->blocks[i].data; i++) {
        check_ok("block", buffer_init(&blocks[i], "block", questions->blocks[i].bytes,
                                      questions->blocks[i].data));
        pass_add_block(&state, questions->blocks[i].block, &blocks[i]);
    }
    if (asks)
        check_ok("questions",
                 buffer_init(&asked, "questions", questions->asked_bytes, questions->asked));
    check_ok("answers",
             buffer_init(&answers, "answers", questions->answer_bytes, questions->answers));
    state.storages[0] = (struct pass_block){0, asks ? &asked : &answers, 0, 0};
    state.storages[1] = (struct pass_block){1, asks ? &answers : NULL, 0, 0};
    pass_begin(&untimed, &state);
    pass_dispatch(questions->groups[0], questions->groups[1] ? questions->groups[1] : 1, 1);
    pass_end(&untimed);
    buffer_read(&answers, 0, questions->answer_bytes, questions->answers);
    for (int i = 0; i < BLOCKS; i++)
        buffer_free(&blocks[i]);
    buffers_free(&asked, &answers);
    program_free(&state.program);
}

struct stage open_stage(const char *path) {
    struct stage stage;
    check_ok(path, stage_init(&stage, &(struct stage_desc){.path = path}));
    return stage;
}

void pose_stage(struct stage *stage) {
    geometry_free(&stage->geometry);
    check_ok("geometry", geometry_init(&stage->geometry, &stage->scene, 0));
    camera_place(&stage->camera, &stage->scene, 0, 0);
    check_ok("lights", emitters_from_text(&stage->emitters, &stage->scene, NULL, 0));
}

void set_sky(struct stage *stage, int width, int height,
             void (*paint)(const float direction[3], float radiance[3])) {
    struct environment *sky = mem_alloc(1, sizeof *sky);
    *sky = (struct environment){.width = width, .height = height, .strength = 1};
    sky->texels = mem_alloc((size_t)width * (size_t)height, sizeof *sky->texels);
    for (int i = 0; i < width * height; i++) {
        float direction[3];
        environment_direction(sky, i % width + .5, i / width + .5, direction);
        paint(direction, sky->texels[i]);
    }
    environment_free(stage->scene.environment);
    stage->scene.environment = sky;
    stage->emitters.sky = sky;
    stage->emitters.count = 0;
}

void scale_scene(struct scene *scene, float s) {
    for (int i = 0; i < scene->mesh_count; i++)
        for (int p = 0; p < scene->meshes[i].primitive_count; p++) {
            struct primitive *primitive = &scene->meshes[i].primitives[p];
            for (int k = 0; k < primitive->vertex_count; k++)
                glm_vec3_scale(primitive->position[k], s, primitive->position[k]);
        }
    for (int i = 0; i < scene->node_count; i++)
        for (int c = 0; c < 3; c++) {
            scene->nodes[i].translation[c] *= s;
            scene->nodes[i].matrix[12 + c] *= s;
        }
    for (int i = 0; i < scene->light_count; i++) {
        struct scene_light *light = &scene->lights[i];
        for (int c = 0; c < 3 && light->type != EMITTER_AREA; c++)
            light->intensity[c] *= s * s;
        for (int c = 0; c < 2 && light->type != EMITTER_DIRECTIONAL; c++)
            light->size[c] *= s;
        light->range *= s;
    }
    for (int i = 0; i < scene->camera_count; i++) {
        scene->cameras[i].near *= s;
        scene->cameras[i].far *= s;
    }
}

void set_medium(struct stage *stage, float scattering, float absorption, float g) {
    stage->scene.medium = (struct medium){.g = g};
    for (int c = 0; c < 3; c++) {
        stage->scene.medium.scattering[c] = scattering;
        stage->scene.medium.absorption[c] = absorption;
    }
}

void turn_stage(struct stage *stage, double degrees) {
    vec3 y = {0, 1, 0};
    mat4 turn;
    glm_rotate_make(turn, glm_rad((float)degrees), y);
    for (int i = 0; i < stage->scene.node_count; i++) {
        struct node *node = &stage->scene.nodes[i];
        if (node->parent >= 0)
            continue;
        mat4 world, turned;
        node_world(&stage->scene, i, 0, (float *)world);
        glm_mat4_mul(turn, world, turned);
        memcpy(node->matrix, turned, sizeof node->matrix);
        node->has_matrix = true;
    }
    pose_stage(stage);
}

void open_rays(struct rays *rays, const struct stage *stage) {
    hit_table_init(&rays->table, &stage->scene, &stage->geometry, MATERIALS_FULL);
    check_ok("rays", ray_scene_init(&rays->scene, &rays->table));
}

void close_rays(struct rays *rays) {
    ray_scene_free(&rays->scene);
}

static void choose(struct renderer_desc *desc, const char *technique, const char *settings) {
    const char *const texts[] = {"picture.samples=1", settings};
    desc->technique = technique_find(technique);
    assert_non_null(desc->technique);
    renderer_settings_init(&desc->settings);
    check_ok(settings, renderer_settings_assign(&desc->settings, desc->technique, texts, 2));
    check_ok(settings, technique_check(desc->technique, &desc->settings));
}

struct renderer_desc desc_of(const struct stage *stage, const char *technique, const char *settings,
                             int width, int height) {
    struct renderer_desc desc = {
        .width = width,
        .height = height,
        .scene = &stage->scene,
        .geometry = &stage->geometry,
        .emitters = stage->emitters,
        .camera = stage->camera,
    };
    choose(&desc, technique, settings);
    return desc;
}

void open_renderer(struct renderer *renderer, struct renderer_desc desc) {
    check_ok("renderer", renderer_init(renderer, &desc));
    renderer_render(renderer);
}

struct image render_layers(const struct renderer_desc *desc) {
    OWNED(renderer) renderer;
    struct image image;
    open_renderer(&renderer, *desc);
    check_ok("layers", renderer_read_layers(&renderer, &image));
    return image;
}

struct image render_mean(const struct renderer_desc *desc, int first, int count) {
    OWNED(renderer) renderer;
    struct renderer_desc progressive = *desc;
    struct image image;
    progressive.progressive = true;
    check_ok("renderer", renderer_init(&renderer, &progressive));
    for (int i = 0; i < count; i++)
        renderer_add_pass(&renderer, first + i);
    assert_int_equal(renderer_pass_count(&renderer), count);
    check_ok("layers", renderer_read_layers(&renderer, &image));
    return image;
}

struct image follow_layers(struct renderer *renderer, const struct renderer_desc *desc) {
    struct image image;
    if (renderer->desc.width > 0)
        check_ok("follow", renderer_follow(renderer, desc));
    else
        check_ok("renderer", renderer_init(renderer, desc));
    renderer_render(renderer);
    check_ok("layers", renderer_read_layers(renderer, &image));
    return image;
}

struct image render_stage(const struct stage *stage, const char *technique, const char *settings,
                          int size) {
    struct renderer_desc desc = desc_of(stage, technique, settings, size, size);
    return render_layers(&desc);
}

void render_halves(const struct stage *stage, struct renderer_desc desc, struct image *whole,
                   struct image *halves) {
    struct emitter lights[2] = {stage->emitters.items[0]};
    desc.emitters = (struct emitters){.items = lights, .count = 1};
    *whole = render_layers(&desc);
    glm_vec3_scale(lights[0].intensity, .5F, lights[0].intensity);
    lights[1] = lights[0];
    desc.emitters.count = 2;
    *halves = render_layers(&desc);
}

struct vpl *read_vpls(const struct renderer *renderer) {
    struct output_list outputs;
    renderer_outputs(renderer, &outputs);
    return vpls_read(output_vpls(&outputs));
}

void pixel_position(const struct renderer *renderer, const struct image *layers, int x, int y,
                    float position[3]) {
    const struct camera *camera = &renderer->desc.camera;
    float width = (float)layers->width, height = (float)layers->height;
    vec3 origin, direction;
    camera_ray(camera, ((float)x + .5f) / width, ((float)y + .5f) / height, width / height, origin,
               direction);
    float z = image_at(layers, x, y)[image_find_channel(layers, "Z")];
    glm_vec3_copy(origin, position);
    glm_vec3_muladds(direction, z / glm_vec3_dot(direction, (float *)camera->forward), position);
}

bool same_pixels(const struct image *a, const struct image *b) {
    return a->width == b->width && a->height == b->height && a->channel_count == b->channel_count &&
           memcmp(a->pixels, b->pixels,
                  (size_t)a->width * (size_t)a->height * (size_t)a->channel_count *
                      sizeof *a->pixels) == 0;
}

/* --- measures --------------------------------------------------------------------------------- */

/* A layer of two pictures of one size. */
struct pair {
    const struct image *test, *reference;
    int channels[3], reference_channels[3], alpha, reference_alpha;
};

static struct pair pair_of(const struct image *test, const struct image *reference,
                           const char *layer) {
    struct pair pair = {test,
                        reference,
                        {0},
                        {0},
                        image_find_channel(test, "A"),
                        image_find_channel(reference, "A")};
    assert_int_equal(test->width, reference->width);
    assert_int_equal(test->height, reference->height);
    check_ok(layer, image_find_layer(test, layer, pair.channels));
    check_ok(layer, image_find_layer(reference, layer, pair.reference_channels));
    assert_true(pair.alpha >= 0 && pair.reference_alpha >= 0);
    return pair;
}

static bool seen(const struct pair *pair, int x, int y) {
    return image_at(pair->test, x, y)[pair->alpha] > 0 &&
           image_at(pair->reference, x, y)[pair->reference_alpha] > 0;
}

static double difference(const struct pair *pair, int x, int y, int c) {
    return (double)image_at(pair->test, x, y)[pair->channels[c]] -
           (double)image_at(pair->reference, x, y)[pair->reference_channels[c]];
}

double layer_mean(const struct image *image, const char *layer) {
    struct pair pair = pair_of(image, image, layer);
    double sum = 0, count = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3 && seen(&pair, x, y); c++, count++)
                sum += (double)image_at(image, x, y)[pair.channels[c]];
    assert_true(count > 0);
    return sum / count;
}

double relative_rmse(const struct image *test, const struct image *reference, const char *layer) {
    struct pair pair = pair_of(test, reference, layer);
    double sum = 0, count = 0;
    for (int y = 0; y < test->height; y++)
        for (int x = 0; x < test->width; x++)
            for (int c = 0; c < 3 && seen(&pair, x, y); c++, count++)
                sum += pow(difference(&pair, x, y, c), 2);
    return sqrt(sum / count) / layer_mean(reference, layer);
}

double gradient_error(const struct image *test, const struct image *reference, const char *layer) {
    struct pair pair = pair_of(test, reference, layer);
    double sum = 0, count = 0;
    for (int y = 0; y + 1 < test->height; y++)
        for (int x = 0; x + 1 < test->width; x++) {
            if (!seen(&pair, x, y) || !seen(&pair, x + 1, y) || !seen(&pair, x, y + 1))
                continue;
            for (int c = 0; c < 3; c++, count++) {
                double here = difference(&pair, x, y, c);
                sum += pow(difference(&pair, x + 1, y, c) - here, 2) +
                       pow(difference(&pair, x, y + 1, c) - here, 2);
            }
        }
    return sqrt(sum / count) / layer_mean(reference, layer);
}

struct image common_layers(const struct image *traced) {
    struct image image;
    image_init(&image, traced->width, traced->height, CHANNELS_COMMON);
    for (int y = 0; y < traced->height; y++)
        for (int x = 0; x < traced->width; x++)
            memcpy(image_at(&image, x, y), image_at(traced, x, y),
                   (size_t)image.channel_count * sizeof(float));
    return image;
}

struct image trace_stage(const struct stage *stage, int size, int samples) {
    OWNED(image) traced = TRACE(stage, .width = size, .height = size, .bounces = 1,
                                .samples = samples, .centers = true);
    struct image reference = common_layers(&traced);
    return reference;
}

struct image trace_paths(const struct stage *stage, const struct path_tracer_desc *desc) {
    struct image traced;
    check_ok("reference", picture_trace_paths(stage, desc, &traced, NULL));
    return traced;
}

void check_finite(const char *what, const struct image *image) {
    size_t count = (size_t)image->width * (size_t)image->height * (size_t)image->channel_count;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(image->pixels[i])) {
            size_t pixel = i / (size_t)image->channel_count;
            fail_msg("%s: %s is %g at %zu, %zu", what,
                     image->names[i % (size_t)image->channel_count], (double)image->pixels[i],
                     pixel % (size_t)image->width, pixel / (size_t)image->width);
        }
}
