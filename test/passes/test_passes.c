/* The passes of clustered visibility against second implementations on the CPU: clusters, views,
 * depth maps, bases. */
#include "render_support.h"

#include "passes/maps.h"
#include "shared/maps.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

/* One frame of `clustered`, with all that its outputs say read back. */
struct frame_of_vals {
    struct stage stage;
    struct renderer renderer;
    const struct val_output *vals;
    int vpl_count, val_count, iterations;
    double by_place, by_normal; /* weights of the clustering, of a distance in metres and a turn */
    struct vpl *vpls;
    struct map_view *views;
    float (*positions)[4], (*normals)[4], (*fluxes)[4]; /* of the VALs */
};

static float (*read_row(const struct texture *texture, int count))[4] {
    float(*row)[4] = mem_alloc((size_t)count, sizeof *row);
    gl.GetTextureImage(texture->id, 0, GL_RGBA, GL_FLOAT, (GLsizei)((size_t)count * sizeof *row),
                       row);
    return row;
}

static bool emits(const struct vpl *vpl) {
    return vpl->reach > 0;
}

/* The geometric mean of the distances of VPLs from the first ones. */
static double spread(const struct frame_of_vals *frame) {
    double sum = 0, count = 0;
    for (int i = 0; i < frame->vpl_count; i++)
        for (int j = 0; j < frame->vpl_count && j < 256; j++) {
            const struct vpl *a = &frame->vpls[i], *b = &frame->vpls[j];
            if (!emits(a) || !emits(b))
                continue;
            double apart = (double)a->area;
            for (int c = 0; c < 3; c++)
                apart += pow((double)a->position[c] - (double)b->position[c], 2);
            sum += log(apart) / 2;
            count++;
        }
    return exp(sum / fmax(count, 1));
}

static void open_vals(struct frame_of_vals *frame, const char *scene, const char *settings) {
    frame->stage = open_stage(scene);
    const char *by_maps = form("path=maps %s", settings);
    struct renderer_desc desc = desc_of(&frame->stage, "clustered", by_maps, 32, 32);
    open_renderer(&frame->renderer, desc);
    struct output_list outputs;
    renderer_outputs(&frame->renderer, &outputs);
    frame->vals = output_vals(&outputs);
    frame->vpl_count = (int)settings_number(&desc.settings, "vpls");
    frame->val_count = (int)settings_number(&desc.settings, "vals");
    frame->iterations = (int)settings_number(&desc.settings, "iterations");
    frame->vpls = read_vpls(&frame->renderer);
    frame->by_place = settings_number(&desc.settings, "weight-position") / spread(frame);
    frame->by_normal = settings_number(&desc.settings, "weight-normal") / GLM_PI;
    frame->views = mem_alloc((size_t)frame->val_count, sizeof *frame->views);
    buffer_read(&frame->vals->maps.views->buffer, 0,
                (size_t)frame->val_count * sizeof *frame->views, frame->views);
    frame->positions = read_row(frame->vals->positions, frame->val_count);
    frame->normals = read_row(frame->vals->normals, frame->val_count);
    frame->fluxes = read_row(frame->vals->fluxes, frame->val_count);
}

static void close_vals(struct frame_of_vals *frame) {
    renderer_free(&frame->renderer);
    stage_free(&frame->stage);
    mem_free(frame->vpls, frame->views, frame->positions, frame->normals, frame->fluxes);
}

/* --- k-means ---------------------------------------------------------------------------------- */

struct means {
    double position[64][3], normal[64][3], count[64];
};

static double criterion(const struct frame_of_vals *frame, const struct vpl *vpl,
                        const struct means *means, int k) {
    double apart = 0, cosine = 0;
    for (int c = 0; c < 3; c++) {
        apart += pow((double)vpl->position[c] - means->position[k][c], 2);
        cosine += (double)vpl->normal[c] * means->normal[k][c];
    }
    double angle = acos(fmax(-1, fmin(1, cosine)));
    return frame->by_place * sqrt(apart) + frame->by_normal * angle;
}

/* The nearest, and how much farther the second nearest is. */
static int nearest(const struct frame_of_vals *frame, const struct vpl *vpl,
                   const struct means *means, double *margin) {
    int best = 0;
    double least = INFINITY, second = INFINITY;
    for (int k = 0; k < frame->val_count; k++) {
        double d = criterion(frame, vpl, means, k);
        if (d < least) {
            second = least;
            least = d;
            best = k;
        } else if (d < second) {
            second = d;
        }
    }
    *margin = second - least;
    return best;
}

static void iterate_means(const struct frame_of_vals *frame, struct means *means) {
    struct means sums = {0};
    double margin;
    for (int i = 0; i < frame->vpl_count; i++) {
        const struct vpl *vpl = &frame->vpls[i];
        if (!emits(vpl))
            continue;
        int k = nearest(frame, vpl, means, &margin);
        sums.count[k]++;
        for (int c = 0; c < 3; c++) {
            sums.position[k][c] += (double)vpl->position[c];
            sums.normal[k][c] += (double)vpl->normal[c];
        }
    }
    for (int k = 0; k < frame->val_count; k++) {
        double length =
            sqrt(pow(sums.normal[k][0], 2) + pow(sums.normal[k][1], 2) + pow(sums.normal[k][2], 2));
        means->count[k] = sums.count[k];
        for (int c = 0; c < 3 && sums.count[k] > 0; c++) {
            means->position[k][c] = sums.position[k][c] / sums.count[k];
            if (length > 1e-6)
                means->normal[k][c] = sums.normal[k][c] / length;
        }
    }
}

static struct means run_k_means(const struct frame_of_vals *frame) {
    struct means means = {0};
    for (int k = 0; k < frame->val_count; k++) {
        int i = k * frame->vpl_count / frame->val_count;
        while (!emits(&frame->vpls[i]))
            i = (i + 1) % frame->vpl_count;
        for (int c = 0; c < 3; c++) {
            means.position[k][c] = (double)frame->vpls[i].position[c];
            means.normal[k][c] = (double)frame->vpls[i].normal[c];
        }
    }
    for (int i = 0; i < frame->iterations; i++)
        iterate_means(frame, &means);
    return means;
}

static void check_means(const struct frame_of_vals *frame, const struct means *means) {
    double worst_position = 0, worst_normal = 0, worst_count = 0;
    for (int k = 0; k < frame->val_count; k++) {
        for (int c = 0; c < 3; c++) {
            worst_position =
                fmax(worst_position, fabs((double)frame->positions[k][c] - means->position[k][c]));
            worst_normal =
                fmax(worst_normal, fabs((double)frame->normals[k][c] - means->normal[k][c]));
        }
        worst_count = fmax(worst_count, fabs((double)frame->positions[k][3] - means->count[k]));
    }
    /* Sums of some tens of floats. */
    check_at_most("VAL positions, over the radius",
                  worst_position / (double)frame->stage.geometry.radius, 1e-5);
    check_at_most("VAL normals", worst_normal, 1e-5);
    check_at_most("VAL counts", worst_count, 0);
}

/* C(i) is the nearest VAL wherever that is clear: acos of a float near 1 is right to 4e-4 alone. */
static void check_mapping(const struct frame_of_vals *frame, const struct means *means) {
    int wrong = 0, clear = 0;
    for (int i = 0; i < frame->vpl_count; i++) {
        double margin;
        int k = nearest(frame, &frame->vpls[i], means, &margin);
        clear += margin > 1e-4;
        wrong += margin > 1e-4 && (int)frame->vpls[i].val != k;
    }
    assert_true(clear > frame->vpl_count * 9 / 10);
    assert_int_equal(wrong, 0);
}

static void check_fluxes(const struct frame_of_vals *frame) {
    double vpls = 0, vals = 0;
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < frame->vpl_count; i++)
            vpls += (double)frame->vpls[i].flux[c];
        for (int k = 0; k < frame->val_count; k++)
            vals += (double)frame->fluxes[k][c];
    }
    check_near("flux of all VALs over that of all VPLs", vals / vpls, 1, 1e-5);
}

TEST(clusters) {
    static const char *const settings[] = {
        "vpls=512 vals=30 interleave=1",
        "vpls=100 vals=7 interleave=1 iterations=1 weight-normal=2",
        "vpls=64 vals=64 interleave=1 iterations=2",
        "vpls=256 vals=1 interleave=1",
    };
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        struct frame_of_vals frame;
        printf("  %s\n", settings[i]);
        open_vals(&frame, "scenes/cornell-box.glb", settings[i]);
        struct means means = run_k_means(&frame);
        check_means(&frame, &means);
        check_mapping(&frame, &means);
        check_fluxes(&frame);
        close_vals(&frame);
    }
}

/* --- views ------------------------------------------------------------------------------------ */

/* Of the bounding rectangle of a VAL's VPLs in its plane: the square root of the area. */
static double extent_of(const struct frame_of_vals *frame, int k) {
    const struct map_view *view = &frame->views[k];
    vec3 bitangent;
    glm_vec3_cross((float *)view->axis, (float *)view->tangent, bitangent);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < frame->vpl_count; i++) {
        if (!emits(&frame->vpls[i]) || (int)frame->vpls[i].val != k)
            continue;
        vec3 q;
        glm_vec3_sub(frame->vpls[i].position, (float *)view->center, q);
        double st[2] = {(double)glm_vec3_dot(q, (float *)view->tangent),
                        (double)glm_vec3_dot(q, bitangent)};
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], st[axis]);
            high[axis] = fmax(high[axis], st[axis]);
        }
    }
    return isfinite(low[0]) ? sqrt((high[0] - low[0]) * (high[1] - low[1])) : 0;
}

static double farthest_corner(const struct geometry *geometry, const float from[3]) {
    double sum = 0;
    for (int c = 0; c < 3; c++)
        sum += pow(fmax(fabs((double)(geometry->bounds_min[c] - from[c])),
                        fabs((double)(geometry->bounds_max[c] - from[c]))),
                   2);
    return sqrt(sum);
}

/* The view is from that of the VAL's VPLs which is nearest to their mean, as high as that: where
 * VPLs lie on walls. */
static double off_center(const struct frame_of_vals *frame, int k) {
    struct means mean;
    vec3 expected = {INFINITY}, off;
    double least = INFINITY;
    for (int c = 0; c < 3; c++) {
        mean.position[k][c] = (double)frame->positions[k][c];
        mean.normal[k][c] = (double)frame->normals[k][c];
    }
    for (int i = 0; i < frame->vpl_count; i++) {
        struct vpl vpl = frame->vpls[i];
        double d = criterion(frame, &vpl, &mean, k);
        if (!emits(&vpl) || (int)vpl.val != k || d >= least)
            continue;
        least = d;
        glm_vec3_sub(frame->positions[k], vpl.position, off);
        glm_vec3_copy(vpl.position, expected);
        glm_vec3_muladds(vpl.normal, fmaxf(glm_vec3_dot(off, vpl.normal), 0), expected);
    }
    return (double)glm_vec3_distance(expected, (float *)frame->views[k].center);
}

TEST(views) {
    struct frame_of_vals frame;
    open_vals(&frame, "scenes/cornell-animal.glb", "vpls=512 vals=30 interleave=1");
    double extents = 0, centers = 0, axes = 0, frames = 0, ranges = 0;
    for (int k = 0; k < frame.val_count; k++) {
        const struct map_view *view = &frame.views[k];
        double extent = extent_of(&frame, k);
        extents = fmax(extents, fabs((double)view->extent - extent));
        centers = fmax(centers, off_center(&frame, k));
        axes = fmax(axes, (double)glm_vec3_distance((float *)view->axis, frame.normals[k]));
        frames =
            fmax(frames, fabs((double)glm_vec3_dot((float *)view->axis, (float *)view->tangent)));
        frames = fmax(frames, fabs((double)glm_vec3_norm((float *)view->tangent) - 1));
        ranges = fmax(
            ranges,
            fabs((double)view->z_far / farthest_corner(&frame.stage.geometry, view->center) - 1));
    }
    double radius = (double)frame.stage.geometry.radius;
    check_at_most("extents, over the radius", extents / radius, 1e-5);
    check_at_most("centres, over the radius", centers / radius, 1e-6);
    check_at_most("axes", axes, 0);
    check_at_most("tangents' distance from orthonormal", frames, 1e-5);
    check_at_most("z_far, relative", ranges, 1e-5);
    close_vals(&frame);
}

/* The mean of VPLs on a ball lies within it; the map looks from without. */
TEST(views_from_outside) {
    struct frame_of_vals frame;
    open_vals(&frame, "scenes/failures/center-inside.glb", "vpls=512 vals=4 interleave=1");
    vec3 middle = {0, 1.2f, 0};
    double mean = INFINITY, view = INFINITY;
    for (int k = 0; k < frame.val_count; k++) {
        mean = fmin(mean, (double)glm_vec3_distance(frame.positions[k], middle));
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
