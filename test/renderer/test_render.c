/* What may change without changing the picture: the context, the frame, the neighbours,
 * the threads, the order of VPLs, the place of the scene, how meshes are cut. */
#define _POSIX_C_SOURCE 200809L
#include "render_support.h"

#include "gl/memory.h"
#include "passes/frame.h"
#include "passes/gather/gather.h"
#include "passes/vpls.h"
#include "shared/vpl.h"

static const char *const cornell_animal = "scenes/cornell-animal.glb";

/* Techniques with settings that keep a frame cheap. */
static const struct recipe {
    const char *technique, *settings;
} recipes[] = {
    {"clustered", "vpls=256 vals=12 map-size=128 interleave=4"},
    {"clustered", "path=paper vpls=256 vals=12 map-size=128 interleave=4"},
    {"instant-radiosity", "vpls=32 map-size=128 interleave=4"},
    {"unshadowed", "vpls=256 interleave=4"},
};
enum { RECIPES = sizeof recipes / sizeof *recipes, SIZE = 96 };

static struct image render_recipe(const struct stage *stage, const struct recipe *recipe) {
    return render_stage(stage, recipe->technique, recipe->settings, SIZE);
}

static struct image render_with(const struct stage *stage, const struct recipe *recipe,
                                const char *setting) {
    char *settings = mem_printf("%s %s", recipe->settings, setting);
    struct image image = render_stage(stage, recipe->technique, settings, SIZE);
    free(settings);
    return image;
}

/* --- the same bits ---------------------------------------------------------------------------- */

/* Frame after frame, renderer after renderer. */
TEST(twice) {
    OWNED(stage) stage = open_stage(cornell_animal);
    for (int i = 0; i < RECIPES; i++) {
        struct image images[3];
        struct renderer renderer;
        open_renderer(&renderer,
                      desc_of(&stage, recipes[i].technique, recipes[i].settings, SIZE, SIZE));
        check_ok("layers", renderer_read_layers(&renderer, &images[0]));
        renderer_render(&renderer);
        check_ok("layers", renderer_read_layers(&renderer, &images[1]));
        renderer_free(&renderer);
        images[2] = render_recipe(&stage, &recipes[i]);
        assert_true(same_pixels(&images[0], &images[1]));
        assert_true(same_pixels(&images[0], &images[2]));
        for (int k = 0; k < 3; k++)
            image_free(&images[k]);
    }
}

/* Three renderers in one context take turns; each draws what it draws alone. */
TEST(neighbours) {
    struct renderer renderers[RECIPES];
    struct image alone[RECIPES];
    OWNED(stage) stage = open_stage(cornell_animal);
    for (int i = 0; i < RECIPES; i++)
        alone[i] = render_recipe(&stage, &recipes[i]);
    for (int i = 0; i < RECIPES; i++) {
        open_renderer(&renderers[i],
                      desc_of(&stage, recipes[i].technique, recipes[i].settings, SIZE, SIZE));
    }
    for (int i = 0; i < RECIPES; i++)
        renderer_render(&renderers[i]);
    for (int i = 0; i < RECIPES; i++) {
        OWNED(image) image;
        check_ok("layers", renderer_read_layers(&renderers[i], &image));
        assert_true(same_pixels(&image, &alone[i]));
    }
    for (int i = 0; i < RECIPES; i++) {
        renderer_free(&renderers[i]);
        image_free(&alone[i]);
    }
}

/* Two libraries, of one Mesa or of two, which may have other places of samples and filter textures
 * otherwise: Mesa 26 makes path=paper .0012 of 22 and 25. */
TEST(contexts) {
    struct image images[2][RECIPES];
    char versions[2][128];
    OWNED(stage) stage = open_stage(cornell_animal);
    for (int k = 0; k < 2; k++) {
        struct context *context = context_create(
            &(struct context_desc){.kind = k ? CONTEXT_OSMESA : CONTEXT_EGL, .debug = true});
        if (!context || !gl.software) {
            printf("    skipped: EGL and OSMesa in software are not both there\n");
            context_free(context);
            context_make_current(*state);
            skip();
        }
        snprintf(versions[k], sizeof versions[k], "%s", (const char *)gl.GetString(GL_VERSION));
        printf("    %s: %s\n", context_description(context), versions[k]);
        for (int i = 0; i < RECIPES; i++)
            images[k][i] = render_with(&stage, &recipes[i], "samples=1");
        assert_int_equal(context_message_count(context), 0);
        context_free(context);
    }
    context_make_current(*state);
    for (int i = 0; i < RECIPES; i++) {
        assert_true(strcmp(versions[0], versions[1]) != 0 ||
                    same_pixels(&images[0][i], &images[1][i]));
        check_at_most("of two Mesas, relative RMSE",
                      relative_rmse(&images[1][i], &images[0][i], ""), .005);
        images_free(&images[0][i], &images[1][i]);
    }
}

static struct image run_binary(const char *environment, const struct recipe *recipe,
                               const char *more) {
    char command[1024], output[4096], set[256] = "";
    const char *path = scratch("render.exr");
    char *settings = mem_strdup(recipe->settings), *rest = NULL;
    for (char *item = strtok_r(settings, " ", &rest); item; item = strtok_r(NULL, " ", &rest))
        snprintf(set + strlen(set), sizeof set - strlen(set), " --set %s", item);
    free(settings);
    snprintf(command, sizeof command, "%s %s render %s --technique %s%s %s --size %dx%d -o %s",
             environment, binary_path(), cornell_animal, recipe->technique, set, more, SIZE, SIZE,
             path);
    if (run_command(command, output, sizeof output) != 0)
        fail_msg("%s: %s", command, output);
    struct image image;
    check_ok(path, image_read(&image, path));
    remove(path);
    return image;
}

/* One thread of llvmpipe, or several, or another library: the same file. */
TEST(threads) {
    for (int i = 0; i < RECIPES; i++) {
        if (!is_tried_here((size_t)i, 2))
            continue;
        OWNED(image) one = run_binary("LP_NUM_THREADS=0", &recipes[i], "");
        OWNED(image) four = run_binary("LP_NUM_THREADS=4", &recipes[i], "");
        assert_true(same_pixels(&one, &four));
    }
}

/* --- scenes that are the same ----------------------------------------------------------------- */

/* Every primitive's triangles in two primitives, of which the second is a mesh of its own on a node
 * of its own. */
static void split_meshes(struct scene *scene) {
    int nodes = scene->node_count, meshes = scene->mesh_count;
    scene->nodes = mem_resize(scene->nodes, 2 * (size_t)nodes, sizeof *scene->nodes);
    scene->meshes = mem_resize(scene->meshes, 2 * (size_t)meshes, sizeof *scene->meshes);
    for (int m = 0; m < meshes; m++) {
        struct mesh *mesh = &scene->meshes[m], *rest = &scene->meshes[meshes + m];
        *rest = *mesh;
        rest->primitives = mem_alloc((size_t)mesh->primitive_count, sizeof *rest->primitives);
        for (int p = 0; p < mesh->primitive_count; p++) {
            struct primitive *first = &mesh->primitives[p], *second = &rest->primitives[p];
            int cut = first->index_count / 6 * 3;
            size_t vertices = (size_t)first->vertex_count;
            *second = *first;
            second->index_count = first->index_count - cut;
            first->index_count = cut;
            second->position = mem_alloc(vertices, sizeof *second->position);
            second->normal = mem_alloc(vertices, sizeof *second->normal);
            second->indices = mem_alloc((size_t)second->index_count, sizeof *second->indices);
            memcpy(second->position, first->position, vertices * sizeof *first->position);
            memcpy(second->normal, first->normal, vertices * sizeof *first->normal);
            memcpy(second->indices, first->indices + cut,
                   (size_t)second->index_count * sizeof *second->indices);
            memset(second->uv, 0, sizeof second->uv);
            second->color = NULL;
        }
    }
    for (int n = 0; n < nodes; n++) {
        struct node *copy = &scene->nodes[nodes + n];
        *copy = scene->nodes[n];
        copy->light = copy->camera = -1;
        copy->mesh = copy->mesh < 0 ? -1 : copy->mesh + meshes;
    }
    scene->node_count = 2 * nodes;
    scene->mesh_count = 2 * meshes;
}

/* The same triangles in another order: only what is equally deep could differ. All triangles are
 * casters, because simplified ones keep vertices where parts meet. */
TEST(split_meshes) {
    OWNED(stage) stage = open_stage(cornell_animal);
    struct image whole[RECIPES];
    for (int i = 0; i < RECIPES; i++)
        whole[i] = render_with(&stage, &recipes[i], "caster-error=0");
    uint32_t triangles = stage.geometry.index_count;
    split_meshes(&stage.scene);
    pose_stage(&stage);
    assert_int_equal(stage.geometry.index_count, triangles);
    for (int i = 0; i < RECIPES; i++) {
        OWNED(image) split = render_with(&stage, &recipes[i], "caster-error=0");
        check_at_most("a scene of meshes in two, relative RMSE",
                      relative_rmse(&split, &whole[i], ""), 1e-3);
        image_free(&whole[i]);
    }
}

/* Everything turned together. What is rounded, and along which axes boxes are measured, changes:
 * bounds, and with them the lengths that are fractions of the radius; maps' texels fall otherwise,
 * and the outlines of hard shadows with them. By a right angle bounds stay. */
TEST(turns) {
    static const struct { double degrees, bound; } turns[] = {{90, .01}, {180, .01}, {37, .06}};
    struct stage stage = open_stage(cornell_animal);
    struct image straight[RECIPES];
    for (int i = 0; i < RECIPES; i++)
        straight[i] = render_recipe(&stage, &recipes[i]);
    stage_free(&stage);
    for (int t = 0; t < 3; t++) {
        printf("  %g degrees\n", turns[t].degrees);
        stage = open_stage(cornell_animal);
        turn_stage(&stage, turns[t].degrees);
        for (int i = 0; i < RECIPES; i++) {
            OWNED(image) turned = render_recipe(&stage, &recipes[i]);
            check_at_most(recipes[i].technique, relative_rmse(&turned, &straight[i], "indirect"),
                          turns[t].bound);
        }
        stage_free(&stage);
    }
    for (int i = 0; i < RECIPES; i++)
        image_free(&straight[i]);
}

/* --- VPLs ------------------------------------------------------------------------------------- */

/* The irradiance of a gather of its own, red of all texels. */
static float *gather(struct renderer *renderer, const struct vpl_buffer *vpls, int interleave,
                     size_t *count) {
    struct gather_pass pass;
    check_ok("gather", gather_pass_init(&pass, &FILLED(gather_desc, .width = SIZE, .height = SIZE,
                                                       .interleave = interleave,
                                                       .clamp = GATHER_CLAMP_DISK)));
    struct frame frame = renderer_frame(renderer);
    gather_pass_clear(&pass);
    gather_pass_render(&pass, &frame, &renderer->gbuffer, &(struct gather_inputs){.vpls = vpls});
    const struct texture_desc *desc = &pass.irradiance.texture.desc;
    *count = (size_t)desc->width * (size_t)desc->height;
    float *texels = mem_alloc(*count, sizeof *texels);
    gl.GetTextureImage(pass.irradiance.texture.id, 0, GL_RED, GL_FLOAT,
                       (GLsizei)(*count * sizeof *texels), texels);
    gather_pass_free(&pass);
    return texels;
}

/* Turns the order of every `run` VPLs around. */
static void reverse_runs(const struct vpl_buffer *vpls, int run) {
    size_t bytes = (size_t)vpls->count * sizeof(struct vpl);
    struct vpl *old = mem_alloc(bytes, 1), *turned = mem_alloc(bytes, 1);
    buffer_read(&vpls->buffer, 0, bytes, old);
    for (int i = 0; i < vpls->count; i++)
        turned[i] = old[i / run * run + run - 1 - i % run];
    buffer_write(&vpls->buffer, 0, bytes, turned);
    mem_free(old, turned);
}

/* Sums in another order: half floats round in the last bit. */
static void check_order(struct renderer *renderer, int interleave, int run) {
    struct output_list outputs;
    renderer_outputs(renderer, &outputs);
    const struct vpl_buffer *vpls = output_vpls(&outputs);
    size_t count;
    float *before = gather(renderer, vpls, interleave, &count);
    reverse_runs(vpls, run);
    float *after = gather(renderer, vpls, interleave, &count);
    reverse_runs(vpls, run);
    double worst = 0, sum = 0;
    for (size_t i = 0; i < count; i++) {
        worst =
            fmax(worst, fabs((double)(after[i] - before[i])) / (fabs((double)before[i]) + 1e-6));
        sum += (double)before[i];
    }
    assert_true(sum > 0);
    printf("  interleave %d, runs of %d\n", interleave, run);
    check_at_most("VPLs in another order, worst pixel, relative", worst, 2. / 1024);
    mem_free(before, after);
}

TEST(order) {
    OWNED(stage) stage = open_stage(cornell_animal);
    OWNED(renderer) renderer;
    open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=1024", SIZE, SIZE));
    check_order(&renderer, 1, 1024);
    check_order(&renderer, 8, 16);
    check_order(&renderer, 4, 64);
}

/* Another set of VPLs is another sample of the same light. */
TEST(seeds) {
    OWNED(stage) stage = open_stage(cornell_animal);
    for (int i = 0; i < RECIPES; i++) {
        bool map_per_vpl = strcmp(recipes[i].technique, "instant-radiosity") == 0;
        struct image images[2];
        for (int k = 0; k < 2; k++) {
            const char *text = form("%s vpls=%d interleave=1 seed=%d", recipes[i].settings,
                                    map_per_vpl ? 256 : 1024, 7 * k);
            images[k] = render_stage(&stage, recipes[i].technique, text, 48);
        }
        double mean = layer_mean(&images[1], "indirect") / layer_mean(&images[0], "indirect");
        printf("  %s %s\n", recipes[i].technique, recipes[i].settings);
        check_near("mean of another seed", mean, 1, .02);
        check_at_most("another seed, relative RMSE",
                      relative_rmse(&images[1], &images[0], "indirect"), .1);
        assert_false(same_pixels(&images[0], &images[1]));
        images_free(&images[0], &images[1]);
    }
}

/* Twice the VPLs at half the flux: the picture stays and its error falls. */
TEST(more_vpls) {
    OWNED(stage) stage = open_stage(cornell_animal);
    struct image many =
        render_stage(&stage, "unshadowed", "vpls=16384 interleave=1 near-samples=100", 48);
    double first = 0, last = 0;
    for (int n = 128; n <= 2048; n *= 2) {
        const char *settings = form("vpls=%d interleave=1 near-samples=100", n);
        OWNED(image) image = render_stage(&stage, "unshadowed", settings, 48);
        last = relative_rmse(&image, &many, "indirect");
        first = n == 128 ? last : first;
        printf("    N = %4d: relative RMSE %.4f, mean %.4f\n", n, last,
               layer_mean(&image, "indirect") / layer_mean(&many, "indirect"));
    }
    /* Random points would give a quarter, give or take. */
    check_at_most("error of 2048 over that of 128", last / first, .35);
    image_free(&many);
}

/* --- memory ----------------------------------------------------------------------------------- */

/* The bounds have 15 MiB for adaptive pixels, and 3 for planes of blocks. 34 are for edge samples
 * with the normals of samples, and 20 for planes in a map per VPL. */
TEST(memory) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    for (int i = 0; i < RECIPES; i++) {
        struct renderer renderer;
        size_t before = gpu_memory_total();
        int objects = gpu_memory_object_count();
        const char *settings = strstr(recipes[i].settings, "path=paper") ? "path=paper" : "";
        struct renderer_desc desc = desc_of(&stage, recipes[i].technique, settings, 800, 800);
        check_ok("renderer", renderer_init(&renderer, &desc));
        printf("  %s %s\n", recipes[i].technique, settings);
        bool maps_have_planes = strcmp(recipes[i].technique, "instant-radiosity") == 0;
        check_at_most("MiB at 800x800", (double)(gpu_memory_total() - before) / (1 << 20),
                      *settings ? 142 : (maps_have_planes ? 138 : 118));
        renderer_free(&renderer);
        assert_int_equal(gpu_memory_total(), before);
        assert_int_equal(gpu_memory_object_count(), objects);
    }
}

RUN_TESTS(open_group_context, close_group_context)
