/* The passes of clustered visibility in a frame, against second implementations on the CPU: views,
 * depth maps, bases. test_cluster has the clusters. */
#include "render_support.h"

#include "passes/maps.h"
#include "passes/vpls.h"
#include "shared/maps.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

/* One frame of `clustered`, with all that its outputs say read back. */
struct frame_of_vals {
    struct stage stage;
    struct renderer renderer;
    const struct val_output *vals;
    int val_count;
    struct map_view *views;
};

static void open_vals(struct frame_of_vals *frame, const char *scene, const char *settings) {
    frame->stage = open_stage(scene);
    const char *by_maps = form("path=maps %s", settings);
    struct renderer_desc desc = desc_of(&frame->stage, "clustered", by_maps, 32, 32);
    open_renderer(&frame->renderer, desc);
    struct output_list outputs;
    renderer_outputs(&frame->renderer, &outputs);
    frame->vals = output_vals(&outputs);
    frame->val_count = (int)settings_number(&desc.settings, "vals");
    frame->views = mem_alloc((size_t)frame->val_count, sizeof *frame->views);
    buffer_read(&frame->vals->maps.views->buffer, 0,
                (size_t)frame->val_count * sizeof *frame->views, frame->views);
}

static void close_vals(struct frame_of_vals *frame) {
    renderer_free(&frame->renderer);
    stage_free(&frame->stage);
    free(frame->views);
}

/* --- sums of VPLs ----------------------------------------------------------------------------- */

/* The geometric mean of the distances of VPLs from the first ones, and the sum of fluxes. */
TEST(sums) {
    enum { VPLS = 512, FIRST = 256 };
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct output_list outputs;
    double logs = 0, count = 0, light[2] = {0};
    float sums[4];
    open_renderer(&renderer, desc_of(&stage, "unshadowed", "vpls=512", 16, 16));
    renderer_outputs(&renderer, &outputs);
    gl.GetTextureImage(output_vpls(&outputs)->sums.id, 0, GL_RGBA, GL_FLOAT, sizeof sums, sums);
    struct vpl *vpls = read_vpls(&renderer);
    for (int i = 0; i < VPLS; i++) {
        for (int c = 0; c < 2; c++)
            light[c] += vpls[i].reach > 0 ? (double)vpls[i].flux[c] : 0;
        for (int j = 0; j < FIRST && vpls[i].reach > 0; j++) {
            if (vpls[j].reach <= 0)
                continue;
            logs += log2((double)vpls[i].area +
                         (double)glm_vec3_distance2(vpls[i].position, vpls[j].position)) /
                    2;
            count++;
        }
    }
    check_near("spread", exp2((double)(sums[0] / sums[1])) / exp2(logs / count), 1, 1e-4);
    for (int c = 0; c < 2; c++)
        check_near(c ? "green light" : "red light", (double)sums[2 + c] / light[c], 1, 1e-4);
    free(vpls);
}

/* --- views ------------------------------------------------------------------------------------ */

/* The mean of VPLs on a ball lies within it; the map looks from without. */
TEST(views_from_outside) {
    struct frame_of_vals frame;
    open_vals(&frame, "scenes/failures/center-inside.glb", "vpls=512 vals=4 interleave=1");
    vec3 middle = {0, 1.2f, 0};
    float positions[4][4];
    double mean = INFINITY, view = INFINITY;
    gl.GetTextureImage(frame.vals->positions->id, 0, GL_RGBA, GL_FLOAT, sizeof positions,
                       positions);
    for (int k = 0; k < frame.val_count; k++) {
        mean = fmin(mean, (double)glm_vec3_distance(positions[k], middle));
        view = fmin(view, (double)glm_vec3_distance((float *)frame.views[k].center, middle));
    }
    check_at_most("the deepest mean's distance from the middle of the ball", mean, .58);
    check_at_most("the ball's radius over that of its nearest view", .59 / view, 1);
    close_vals(&frame);
}

/* --- depth maps ------------------------------------------------------------------------------- */

/* One layer of one level, of one or four channels. */
static float *read_layer(const struct texture *texture, int level, int layer, GLenum format) {
    int size = texture->desc.width >> level, channels = format == GL_RGBA ? 4 : 1;
    size_t count = (size_t)size * (size_t)size * (size_t)channels;
    float *texels = mem_alloc(count, sizeof *texels);
    gl.GetTextureSubImage(texture->id, level, 0, 0, layer, size, size, 1, format, GL_FLOAT,
                          (GLsizei)(count * sizeof *texels), texels);
    return texels;
}

/* The world direction of a texel; false outside the half space of the view. */
static bool texel_direction(const struct map_view *view, int size, int x, int y, vec3s *direction) {
    float px = 2 * ((float)x + .5f) / (float)size - 1, py = 2 * ((float)y + .5f) / (float)size - 1;
    float p2 = px * px + py * py;
    vec3s axis = to_vec3s(view->axis), tangent = to_vec3s(view->tangent);
    vec3s bitangent = glms_vec3_cross(axis, tangent);
    *direction = glms_vec3_scale(axis, (1 - p2) / (1 + p2));
    *direction = glms_vec3_muladds(tangent, 2 * px / (1 + p2), *direction);
    *direction = glms_vec3_muladds(bitangent, 2 * py / (1 + p2), *direction);
    return p2 < .98f; /* the rim looks along the plane, where nothing is as it seems */
}

/* The depth of a texel by rays; negative where the map does not look. */
static float true_depth(const struct frame_of_vals *frame, const struct rays *rays, int k, int x,
                        int y) {
    const struct map_view *view = &frame->views[k];
    vec3s direction;
    struct hit hit;
    if (!texel_direction(view, frame->vals->maps.depth->size, x, y, &direction))
        return -1;
    /* What is nearer than the near clip is not there. */
    vec3s from = glms_vec3_muladds(direction, view->near, to_vec3s(view->center));
    if (!ray_scene_hit(&rays->scene, from, direction, &hit))
        return 1;
    return glms_vec3_distance(hit.position, to_vec3s(view->center)) / view->z_far;
}

/* Depths of texels of one map against rays: how many differ by more than a hundredth. */
static void compare_map(const struct frame_of_vals *frame, const struct rays *rays, int k,
                        int *wrong, int *count) {
    const struct depth_maps *maps = frame->vals->maps.depth;
    float *depths = read_layer(&maps->depth, 0, k, GL_DEPTH_COMPONENT);
    for (int y = 0; y < maps->size; y += 3)
        for (int x = 0; x < maps->size; x += 3) {
            float depth = true_depth(frame, rays, k, x, y);
            *count += depth >= 0;
            *wrong += depth >= 0 && fabsf(depths[y * maps->size + x] - depth) > .01f;
        }
    free(depths);
}

static double wrong_texels(const char *scene, const char *settings) {
    struct frame_of_vals frame;
    struct rays rays;
    int wrong = 0, count = 0;
    open_vals(&frame, scene, settings);
    open_rays(&rays, &frame.stage);
    for (int k = 0; k < frame.val_count; k++)
        compare_map(&frame, &rays, k, &wrong, &count);
    close_rays(&rays);
    close_vals(&frame);
    return (double)wrong / count;
}

/* Within a triangle the depth is exact. Its outline is drawn straight where it is bent: the more so
 * the wider the triangle is seen, and most where it reaches behind the VAL. A long one has the true
 * outline; a texel of a silhouette shows either side. */
TEST(depth_maps) {
    static const char *const scenes[] = {"scenes/cornell-box.glb", "scenes/cornell-animal.glb"};
    for (int i = 0; i < 2; i++) {
        printf("  %s\n", scenes[i]);
        double straight =
            wrong_texels(scenes[i], "vpls=256 vals=8 interleave=1 map-size=128 caster-long=0");
        double bent = wrong_texels(scenes[i], "vpls=256 vals=8 interleave=1 map-size=128");
        check_at_most("texels that differ, bent edges", bent, .01);
        check_at_most("bent edges over straight ones", bent / straight, .05);
    }
}

/* Texels that show nothing between two that show something, where a ray meets something. */
static int count_cracks(const struct frame_of_vals *frame, const struct rays *rays, int k) {
    const struct depth_maps *maps = frame->vals->maps.depth;
    int size = maps->size, cracks = 0;
    float *depths = read_layer(&maps->depth, 0, k, GL_DEPTH_COMPONENT);
    for (int y = 1; y < size - 1; y++)
        for (int x = 1; x < size - 1; x++) {
            const float *at = depths + y * size + x;
            if (*at < 1 || ((at[-1] == 1 || at[1] == 1) && (at[-size] == 1 || at[size] == 1)))
                continue;
            float depth = true_depth(frame, rays, k, x, y);
            cracks += depth >= 0 && depth < 1;
        }
    free(depths);
    return cracks;
}

/* Be the edges that two triangles share drawn straight or bent, no crack opens along them. What is
 * left lies around triangles that a VAL's near clip leaves out. */
TEST(cracks) {
    static const int longest[] = {0, 500, 5000, 20000};
    for (int i = 0; i < 4; i++) {
        struct frame_of_vals frame;
        struct rays rays;
        int cracks = 0, size = 128;
        const char *settings =
            form("vals=32 caster-error=0 map-size=%d caster-long=%d", size, longest[i]);
        open_vals(&frame, "scenes/sphere.glb", settings);
        open_rays(&rays, &frame.stage);
        for (int k = 0; k < frame.val_count; k++)
            cracks += count_cracks(&frame, &rays, k);
        printf("  the %d longest bent\n", longest[i]);
        check_at_most("share of texels that are cracks",
                      (double)cracks / (frame.val_count * size * size), 1e-3);
        close_rays(&rays);
        close_vals(&frame);
    }
}

/* --- bases ------------------------------------------------------------------------------------ */

/* What a map's depths are, and what they make of one. */
struct fitted {
    double nearest, farthest, knee; /* the knee beyond the nearest, twice as far as the mean */
    double step, end;               /* of the argument: from 0 to 1, and of the farthest */
};

static struct fitted fit(const struct frame_of_vals *frame, int k) {
    const struct depth_maps *maps = frame->vals->maps.depth;
    float *depths = read_layer(&maps->depth, 0, k, GL_DEPTH_COMPONENT);
    double nearest = 1, farthest = 0, sum = 0;
    int count = 0;
    for (int i = 0; i < maps->size * maps->size; i++) {
        double z = (double)depths[i];
        if (z == 1) /* nothing */
            continue;
        nearest = fmin(nearest, z);
        farthest = fmax(farthest, z);
        sum += z;
        count++;
    }
    free(depths);
    double step = 1.22 / (2 * frame->vals->maps.bases->terms);
    bool open = count < GLM_PI / 8 * maps->size * maps->size; /* half of the disc */
    return (struct fitted){nearest, farthest, 2 * (sum / count - nearest), step,
                           1 - (open ? 2 : 1) * step};
}

/* Where nothing is, one step before the end of half the period. */
static double argument(const struct fitted *fitted, double z) {
    if (z == 1)
        return 1 - fitted->step;
    double range = fitted->farthest - fitted->nearest, beyond = z - fitted->nearest;
    return fitted->end * beyond / (beyond + fitted->knee) * (range + fitted->knee) / range;
}

TEST(ranges) {
    struct frame_of_vals frame;
    open_vals(&frame, "scenes/cornell-animal.glb",
              "vpls=256 vals=8 interleave=1 map-size=64 visibility=cssm");
    const struct basis_maps *maps = frame.vals->maps.bases;
    struct series_range ranges[8];
    buffer_read(&maps->ranges, 0, sizeof ranges, ranges);
    double bounds = 0, knees = 0, ends = 0;
    for (int k = 0; k < frame.val_count; k++) {
        struct fitted own = fit(&frame, k);
        bounds = fmax(bounds, fabs((double)ranges[k].nearest - own.nearest));
        bounds = fmax(bounds, fabs((double)ranges[k].farthest - own.farthest));
        knees = fmax(knees, fabs((double)ranges[k].knee - own.knee));
        double beyond = own.farthest - own.nearest;
        ends = fmax(ends, fabs((double)ranges[k].scale * beyond / (beyond + own.knee) - own.end));
    }
    check_at_most("nearest and farthest, map depth", bounds, 0);
    check_at_most("knee, map depth", knees, 1e-6);
    check_at_most("the farthest's argument", ends, 1e-5);
    close_vals(&frame);
}

/* The largest difference of a basis from a function of the depth, over one map and group. */
static double basis_error(const struct frame_of_vals *frame, const struct texture *texture, int k,
                          int group, double (*basis)(double c, double a), bool coded) {
    const struct basis_maps *maps = frame->vals->maps.bases;
    struct fitted fitted = fit(frame, k);
    float *depths = read_layer(&frame->vals->maps.depth->depth, 0, k, GL_DEPTH_COMPONENT);
    float *texels = read_layer(texture, 0, group * maps->count + k, GL_RGBA);
    double worst = 0;
    for (int i = 0; i < maps->size * maps->size; i++)
        for (int term = 4 * group; term < 4 * group + 4 && term < maps->terms; term++) {
            double value = (double)texels[4 * i + term - 4 * group];
            double expected = basis(GLM_PI * (2 * term + 1), argument(&fitted, (double)depths[i]));
            worst = fmax(worst, fabs((coded ? 2 * value - 1 : value) - expected));
        }
    mem_free(depths, texels);
    return worst;
}

static double basis_cos(double c, double a) {
    return cos(c * a);
}
static double basis_sin(double c, double a) {
    return sin(c * a);
}
static double basis_z_cos(double c, double a) {
    return a * cos(c * a);
}
static double basis_z_sin(double c, double a) {
    return a * sin(c * a);
}

/* A level's texels are means of four of the level above. */
static double mip_error(const struct texture *texture, int level, int layer) {
    float *fine = read_layer(texture, level - 1, layer, GL_RGBA);
    float *coarse = read_layer(texture, level, layer, GL_RGBA);
    int size = texture->desc.width >> level;
    double worst = 0;
    for (int i = 0; i < 4 * size * size; i++) {
        int x = i / 4 % size, y = i / 4 / size, c = i % 4;
        double sum = 0;
        for (int j = 0; j < 4; j++)
            sum += (double)fine[4 * ((2 * y + j / 2) * 2 * size + 2 * x + j % 2) + c];
        worst = fmax(worst, fabs((double)coarse[i] - sum / 4));
    }
    mem_free(fine, coarse);
    return worst;
}

static void check_bases(const struct frame_of_vals *frame, int k, int group) {
    /* RGBA8: half a step of 2 / 255, and what drivers round up. RGBA16F: 11 bits. */
    const double eight_bits = 1.5 / 255, half = 1. / 1024;
    const struct basis_maps *maps = frame->vals->maps.bases;
    check_at_most("cos", basis_error(frame, &maps->cos, k, group, basis_cos, true), eight_bits);
    check_at_most("sin", basis_error(frame, &maps->sin, k, group, basis_sin, true), eight_bits);
    check_at_most("z cos", basis_error(frame, &maps->z_cos, k, group, basis_z_cos, false), half);
    check_at_most("z sin", basis_error(frame, &maps->z_sin, k, group, basis_z_sin, false), half);
    for (int level = 1; maps->size >> level; level++) {
        int layer = group * maps->count + k;
        check_at_most("MIP level of cos", mip_error(&maps->cos, level, layer), 1.01 / 255);
        check_at_most("MIP level of z sin", mip_error(&maps->z_sin, level, layer), half);
    }
}

TEST(bases) {
    struct frame_of_vals frame;
    open_vals(&frame, "scenes/cornell-box.glb",
              "vpls=64 vals=3 interleave=1 map-size=64 visibility=cssm "
              "terms=6");
    for (int k = 0; k < frame.val_count; k++)
        for (int group = 0; group < 2; group++)
            check_bases(&frame, k, group);
    close_vals(&frame);
}

RUN_TESTS(open_group_context, close_group_context)
