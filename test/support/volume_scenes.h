/* Surfaces made by hand as glTF files, and what a volume says of them. */
#ifndef TEST_VOLUME_SCENES_H
#define TEST_VOLUME_SCENES_H

#include "base/unit.h"
#include "gltf_parts.h"
#include "render_support.h"

#include "passes/frame.h"
#include "passes/visibility/shadow_map.h"
#include "techniques/volume.h"

enum { SHAPE_VERTICES = 20000 };

struct shape {
    int vertex_count, index_count;
    float position[SHAPE_VERTICES][3], normal[SHAPE_VERTICES][3];
    uint32_t indices[6 * SHAPE_VERTICES];
};

static inline struct shape *new_shape(void) {
    return mem_alloc(1, sizeof(struct shape));
}

static inline vec3s at(float x, float y, float z) {
    return (vec3s){{x, y, z}};
}

static inline uint32_t add_vertex(struct shape *shape, vec3s position, vec3s normal) {
    int i = shape->vertex_count++;
    assert_true(i < SHAPE_VERTICES);
    memcpy(shape->position[i], position.raw, sizeof position.raw);
    memcpy(shape->normal[i], normal.raw, sizeof normal.raw);
    return (uint32_t)i;
}

static inline void add_square(struct shape *shape, const uint32_t corners[4]) {
    const uint32_t *c = corners;
    memcpy(&shape->indices[shape->index_count], (uint32_t[]){c[0], c[1], c[2], c[0], c[2], c[3]},
           6 * sizeof *c);
    shape->index_count += 6;
}

/* Seen from where u x v points. */
static inline void add_rectangle(struct shape *shape, vec3s corner, vec3s u, vec3s v) {
    vec3s normal = vec3s_unit_cross(u, v), uv = glms_vec3_add(u, v);
    const uint32_t corners[4] = {add_vertex(shape, corner, normal),
                                 add_vertex(shape, glms_vec3_add(corner, u), normal),
                                 add_vertex(shape, glms_vec3_add(corner, uv), normal),
                                 add_vertex(shape, glms_vec3_add(corner, v), normal)};
    add_square(shape, corners);
}

/* The inside of a box. */
static inline void add_room(struct shape *shape, vec3s low, vec3s high) {
    vec3s x = at(high.x - low.x, 0, 0), y = at(0, high.y - low.y, 0), z = at(0, 0, high.z - low.z);
    add_rectangle(shape, low, z, x);
    add_rectangle(shape, low, x, y);
    add_rectangle(shape, low, y, z);
    add_rectangle(shape, high, glms_vec3_negate(x), glms_vec3_negate(z));
    add_rectangle(shape, high, glms_vec3_negate(y), glms_vec3_negate(x));
    add_rectangle(shape, high, glms_vec3_negate(z), glms_vec3_negate(y));
}

/* The lower part of a unit sphere, seen from within, up to the height z in [-1, 1]. */
static inline void add_bowl(struct shape *shape, double height) {
    enum { RINGS = 48, SIDES = 96 };
    double end = acos(-height);
    uint32_t first = (uint32_t)shape->vertex_count;
    for (int j = 0; j <= RINGS; j++)
        for (int i = 0; i <= SIDES; i++) {
            double theta = end * j / RINGS, phi = 2 * GLM_PI * i / SIDES;
            vec3s p = at((float)(sin(theta) * cos(phi)), (float)-cos(theta),
                         (float)(sin(theta) * sin(phi)));
            add_vertex(shape, p, glms_vec3_negate(p));
        }
    for (uint32_t j = 0; j < RINGS; j++)
        for (uint32_t i = 0; i < SIDES; i++) {
            uint32_t a = first + j * (SIDES + 1) + i, b = a + SIDES + 1;
            add_square(shape, (uint32_t[]){a, a + 1, b + 1, b});
        }
}

static inline void turn_inside_out(struct shape *shape) {
    for (int i = 0; i < shape->vertex_count; i++)
        for (int c = 0; c < 3; c++)
            shape->normal[i][c] *= -1;
    for (int i = 0; i < shape->index_count; i += 3) {
        uint32_t index = shape->indices[i];
        shape->indices[i] = shape->indices[i + 1];
        shape->indices[i + 1] = index;
    }
}

static inline void turn_shape(struct shape *shape, float angle, vec3s axis) {
    for (int i = 0; i < shape->vertex_count; i++) {
        vec3s p = glms_vec3_rotate(to_vec3s(shape->position[i]), angle, axis);
        vec3s n = glms_vec3_rotate(to_vec3s(shape->normal[i]), angle, axis);
        memcpy(shape->position[i], p.raw, sizeof p.raw);
        memcpy(shape->normal[i], n.raw, sizeof n.raw);
    }
}

/* Writes and opens it, in white of that albedo, with a light of 1 W/sr at a place; frees
 * the shape. */
static inline void open_shape(struct stage *stage, struct shape *shape, double albedo,
                              bool two_sided, vec3s light) {
    size_t vectors = (size_t)shape->vertex_count * 12, indices = (size_t)shape->index_count * 4;
    const char *path = scratch("shape.gltf"), *data = scratch("shape.bin");
    FILE *file = fopen(data, "wb");
    assert_non_null(file);
    assert_true(fwrite(shape->position, 1, vectors, file) == vectors &&
                fwrite(shape->normal, 1, vectors, file) == vectors &&
                fwrite(shape->indices, 1, indices, file) == indices && fclose(file) == 0);
    const char *text = form(
        "{asset:{version:'2.0'},extensionsUsed:[KHR_lights_punctual],extensions:{KHR_lights_"
        "punctual:{lights:[{type:point,intensity:1}]}},buffers:[{byteLength:%zu,uri:'shape."
        "bin'}],bufferViews:[{buffer:0,byteLength:%zu},{buffer:0,byteOffset:%zu,byteLength:%"
        "zu},{buffer:0,byteOffset:%zu,byteLength:%zu}],accessors:[{bufferView:0,componentType:"
        "5126,count:%d,type:VEC3},{bufferView:1,componentType:5126,count:%d,type:VEC3},{"
        "bufferView:2,componentType:5125,count:%d,type:SCALAR}],materials:[{doubleSided:%s,"
        "pbrMetallicRoughness:{metallicFactor:0,baseColorFactor:[%g,%g,%g,1]}}],meshes:[{"
        "primitives:[{attributes:{POSITION:0,NORMAL:1},indices:2,material:0}]}],nodes:[{mesh:"
        "0},{translation:[%g,%g,%g],extensions:{KHR_lights_punctual:{light:0}}}]}",
        2 * vectors + indices, vectors, vectors, vectors, 2 * vectors, indices, shape->vertex_count,
        shape->vertex_count, shape->index_count, two_sided ? "true" : "false", albedo, albedo,
        albedo, (double)light.x, (double)light.y, (double)light.z);
    write_json(path, text);
    *stage = open_stage(path);
    free(shape);
}

/* Orthographic, along a direction onto a place, so wide. */
static inline void look(struct stage *stage, vec3s target, vec3s forward, vec3s up, float extent) {
    vec3s right = vec3s_unit_cross(forward, up), above = vec3s_unit_cross(right, forward);
    vec3s eye = glms_vec3_muladds(forward, -4 * stage->geometry.radius, target);
    stage->camera = (struct camera){.orthographic = true, .y_extent = extent / 2};
    memcpy(stage->camera.eye, eye.raw, sizeof eye.raw);
    memcpy(stage->camera.forward, vec3s_unit(forward).raw, sizeof eye.raw);
    memcpy(stage->camera.right, right.raw, sizeof right.raw);
    memcpy(stage->camera.up, above.raw, sizeof above.raw);
}

/* What a picture's pixels see, and the texture of the volume there: RGBA, rows from the bottom. */
struct seen {
    struct renderer renderer;
    struct image layers;
    float (*texels)[4];
    int size;
};

static inline void free_seen(struct seen *seen) {
    renderer_free(&seen->renderer);
    image_free(&seen->layers);
    free(seen->texels);
}

static inline void read_texels(struct seen *seen, const struct texture *texture) {
    int count = seen->size * seen->size;
    seen->texels = mem_alloc((size_t)count, sizeof *seen->texels);
    gl.GetTextureImage(texture->id, 0, GL_RGBA, GL_FLOAT, count * (int)sizeof *seen->texels,
                       seen->texels);
}

/* Ambient occlusion, beside the picture of another technique. */
static inline void see_occlusion(struct seen *seen, const struct stage *stage, const char *settings,
                                 int size) {
    struct renderer_desc desc = desc_of(stage, "imperfect-volume", settings, size, size);
    struct ambient_occlusion ao;
    seen->size = size;
    open_renderer(&seen->renderer, desc);
    check_ok("layers", renderer_read_layers(&seen->renderer, &seen->layers));
    struct frame frame = renderer_frame(&seen->renderer);
    check_ok("ambient occlusion",
             ambient_occlusion_init(
                 &ao, &(struct ambient_occlusion_desc){&seen->renderer.desc.settings, &stage->scene,
                                                       &stage->geometry, size, size}));
    ambient_occlusion_render(&ao, &frame, &seen->renderer.gbuffer);
    read_texels(seen, &ao.light.reconstruct.irradiance.texture);
    ambient_occlusion_free(&ao);
}

/* The place of a pixel, rows from the top; false where it sees nothing. */
static inline bool seen_place(const struct seen *seen, int x, int y, float place[3]) {
    float z = image_at(&seen->layers, x, y)[image_find_channel(&seen->layers, "Z")];
    if (!(z > 0 && isfinite(z)))
        return false;
    pixel_position(&seen->renderer, &seen->layers, x, y, place);
    return true;
}

static inline const float *seen_texel(const struct seen *seen, int x, int y) {
    return seen->texels[(seen->size - 1 - y) * seen->size + x];
}

/* Where a truth knows nothing it is NAN. */
struct spread {
    double rmse, least, most, mean;
    int count, unknown; /* pixels for which no voxel knew */
};

static inline struct spread spread_about(const struct seen *seen,
                                         double (*truth)(const float place[3], void *context),
                                         void *context) {
    struct spread spread = {.least = INFINITY, .most = -INFINITY};
    double sum = 0;
    for (int y = 0; y < seen->size; y++)
        for (int x = 0; x < seen->size; x++) {
            float place[3];
            if (!seen_place(seen, x, y, place))
                continue;
            double expected = truth(place, context);
            const float *texel = seen_texel(seen, x, y);
            if (isnan(expected))
                continue;
            spread.count++;
            spread.unknown += texel[3] == 0;
            sum += pow((double)texel[0] - expected, 2);
            spread.mean += (double)texel[0];
            spread.least = fmin(spread.least, (double)texel[0]);
            spread.most = fmax(spread.most, (double)texel[0]);
        }
    spread.rmse = sqrt(sum / spread.count);
    spread.mean /= spread.count;
    return spread;
}

/* A volume's light beside a renderer that has drawn a frame of the same settings. */
struct lit {
    struct renderer renderer;
    struct shadow_map_pass shadows;
    struct volume_light light;
    struct frame frame;
};

static inline void light_volume(struct lit *lit) {
    shadow_map_pass_render(&lit->shadows, &lit->frame);
    volume_light_render(&lit->light, &lit->frame, lit->shadows.maps, lit->frame.irradiance_scale);
}

static inline void open_lit(struct lit *lit, const struct stage *stage, const char *settings,
                            int bounces) {
    struct renderer_desc desc = desc_of(stage, "imperfect-volume", settings, 32, 32);
    open_renderer(&lit->renderer, desc);
    lit->frame = renderer_frame(&lit->renderer);
    check_ok("shadow maps", shadow_map_pass_init(
                                &lit->shadows, &(struct shadow_map_desc){512, lit->frame.layout}));
    check_ok("volume",
             volume_light_init(&lit->light,
                               &FILLED(volume_light_desc, .settings = &lit->renderer.desc.settings,
                                       .geometry = &stage->geometry, .width = 32, .height = 32,
                                       .scene = &stage->scene, .channels = VOLUME_RADIANCE,
                                       .bounces = bounces)));
    light_volume(lit);
}

static inline void close_lit(struct lit *lit) {
    volume_light_free(&lit->light);
    shadow_map_pass_free(&lit->shadows);
    renderer_free(&lit->renderer);
}

/* Texels of one of the volume's textures, for free(). */
static inline float (*read_atlas(const struct texture *texture, int *count))[4] {
    *count = texture->desc.width * texture->desc.height;
    float(*texels)[4] = mem_alloc((size_t)*count, sizeof *texels);
    gl.GetTextureImage(texture->id, 0, GL_RGBA, GL_FLOAT, *count * (int)sizeof *texels, texels);
    return texels;
}

#endif
