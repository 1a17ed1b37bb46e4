/* Pixels with few like neighbours: which are adaptive, what they gather, and how they
 * are blurred. */
#include "render_support.h"

#include "passes/frame.h"
#include "passes/gather/blur.h"
#include "passes/gather/adaptive.h"

enum { SIZE = 64, RADIUS = 2, BLUR = 4, LISTS = 4 };

/* A frame, and the lists of a G-buffer. */
struct adaptive_bench {
    struct stage stage;
    struct renderer renderer;
    struct adaptive_pass adaptive;
    GLuint texels[SIZE * SIZE], counts[LISTS * LISTS * LIST_KINDS];
};

static void open_bench(struct adaptive_bench *bench, const char *scene, const char *settings,
                       float share) {
    bench->stage = open_stage(scene);
    open_renderer(&bench->renderer, desc_of(&bench->stage, "unshadowed", settings, SIZE, SIZE));
    check_ok("adaptive",
             adaptive_pass_init(&bench->adaptive,
                                &FILLED(adaptive_desc, .width = SIZE, .height = SIZE,
                                        .interleave = LISTS, .radius = RADIUS, .distance = .1f,
                                        .cosine = .995f, .sharp_cosine = .98f, .share = share)));
}

static void list_pixels(struct adaptive_bench *bench, const struct gbuffer *gbuffer) {
    struct frame frame = renderer_frame(&bench->renderer);
    adaptive_pass_render(&bench->adaptive, &frame, gbuffer);
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    gl.GetTextureImage(bench->adaptive.lists.texels.id, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                       sizeof bench->texels, bench->texels);
    buffer_read(&bench->adaptive.lists.counts, 0, sizeof bench->counts, bench->counts);
}

static void close_bench(struct adaptive_bench *bench) {
    adaptive_pass_free(&bench->adaptive);
    renderer_free(&bench->renderer);
    stage_free(&bench->stage);
}

/* Octahedral codes of normals beside +z: across, and eight degrees away, whose cosine is .99. */
static const float across = 1, turned = .5616f;

/* A plane before the camera: on the left of one normal, on the right in stripes as wide as the
 * neighbours are away, of one and another. */
static void make_stripes_of(struct gbuffer *gbuffer, float code) {
    check_ok(
        "G-buffer",
        gbuffer_init(gbuffer, &(struct gbuffer_desc){
                                  .label = "stripes", .width = SIZE, .height = SIZE, .layers = 1}));
    static float depths[SIZE * SIZE], normals[SIZE * SIZE][2];
    for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE;
        depths[i] = .5f;
        normals[i][0] = x >= SIZE / 2 && x / RADIUS % 2 ? code : .5f;
        normals[i][1] = .5f;
    }
    gl.TextureSubImage3D(gbuffer->depth.id, 0, 0, 0, 0, SIZE, SIZE, 1, GL_DEPTH_COMPONENT, GL_FLOAT,
                         depths);
    gl.TextureSubImage3D(gbuffer->normal.id, 0, 0, 0, 0, SIZE, SIZE, 1, GL_RG, GL_FLOAT, normals);
}

static void make_stripes(struct gbuffer *gbuffer) {
    make_stripes_of(gbuffer, across);
}

/* Stripes are adaptive, the plane is not, nor its straight edge; a list has each pixel once. */
TEST(lists) {
    struct adaptive_bench bench;
    struct gbuffer gbuffer;
    open_bench(&bench, "scenes/cornell-box.glb", "vpls=1 interleave=1", .5f);
    make_stripes(&gbuffer);
    list_pixels(&bench, &gbuffer);
    int smooth_adaptive = 0, stripes_left = 0, adaptive = 0, misplaced = 0, counted = 0;
    static GLuint pixels[2 * SIZE * SIZE];
    gl.GetTextureImage(bench.adaptive.lists.pixels.id, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                       sizeof pixels, pixels);
    for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE, y = i / SIZE;
        GLuint code = bench.texels[i] & 1 ? bench.texels[i] : 0;
        smooth_adaptive += code && x < SIZE / 2;
        stripes_left += !code && x >= SIZE / 2 + RADIUS && x < SIZE - RADIUS;
        adaptive += code != 0;
        if (code)
            misplaced += pixels[(code >> 16 & 0x7fff) * SIZE + (code >> 1 & 0x7fff)] !=
                         (GLuint)(x | y << 16);
    }
    for (int i = 0; i < LISTS * LISTS * LIST_KINDS; i++)
        counted += (int)bench.counts[i];
    printf("    adaptive %d, on the plane %d, not of the stripes %d, misplaced %d\n", adaptive,
           smooth_adaptive, stripes_left, misplaced);
    assert_int_equal(smooth_adaptive, 0);
    assert_int_equal(stripes_left, 0);
    assert_int_equal(misplaced, 0);
    assert_int_equal(counted, adaptive);
    gbuffer_free(&gbuffer);
    close_bench(&bench);
}

/* Beside the plane's straight edge two neighbours are like, in stripes none. */
static void check_levels(float code, GLuint level_of_stripes) {
    struct adaptive_bench bench;
    struct gbuffer gbuffer;
    open_bench(&bench, "scenes/cornell-box.glb", "vpls=1 interleave=1", .75f);
    make_stripes_of(&gbuffer, code);
    list_pixels(&bench, &gbuffer);
    int beside = 0, wrong = 0, smooth_adaptive = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE;
        GLuint code = bench.texels[i] & 1 ? bench.texels[i] : 0;
        bool edge = x >= SIZE / 2 && x < SIZE / 2 + RADIUS; /* the first stripe is as the plane */
        bool stripe = x >= SIZE / 2 + RADIUS && x < SIZE - RADIUS;
        beside += edge;
        smooth_adaptive += code && x < SIZE / 2;
        wrong += (edge || stripe) &&
                 (!code || code >> 31 != (edge ? PIXEL_LEVEL_EDGE : level_of_stripes));
    }
    printf("    beside the edge %d, of another level %d, on the plane %d\n", beside, wrong,
           smooth_adaptive);
    assert_int_equal(wrong, 0);
    assert_int_equal(smooth_adaptive, 0);
    gbuffer_free(&gbuffer);
    close_bench(&bench);
}

/* Gentle relief is adaptive as edges are. */
TEST(levels) {
    check_levels(across, PIXEL_LEVEL_DETAIL);
    check_levels(turned, PIXEL_LEVEL_EDGE);
}

static void fill(struct irradiance *irradiance, int height, int interleave, float value) {
    const float color[4] = {value, value, value, 1};
    check_ok("irradiance",
             irradiance_init(irradiance, "constant", GL_RGBA32F, SIZE, height, interleave));
    gl.ClearTexImage(irradiance->texture.id, 0, GL_RGBA, GL_FLOAT, color);
}

/* As the frame has it. */
static const struct blur_desc blur_of_lists = {
    .width = SIZE,
    .height = SIZE,
    .radius = BLUR,
    .distance = .1f,
    .cosine = .995f,
    .adaptive = true,
    .level_radius = {2, 1},
    .level_weight = {4, 16},
};

static void read_blurred(struct adaptive_bench *bench, const struct blur_desc *desc,
                         const struct gbuffer *gbuffer, const struct blur_inputs *inputs,
                         float blurred[SIZE * SIZE]) {
    struct frame frame = renderer_frame(&bench->renderer);
    struct blur_pass pass;
    check_ok("blur", blur_pass_init(&pass, desc));
    blur_pass_render(&pass, &frame, gbuffer, inputs);
    gl.GetTextureImage(pass.blurred.texture.id, 0, GL_RED, GL_FLOAT, SIZE * SIZE * sizeof *blurred,
                       blurred);
    blur_pass_free(&pass);
}

/* Of a square picture, whose lists have its width. */
static int lists_height(void) {
    int size[2] = {SIZE, SIZE};
    pixel_lists_size(size, LISTS);
    return size[1];
}

/* Weights sum to one, whatever is adaptive, along lines and in squares. */
TEST(blur_conserves) {
    struct adaptive_bench bench;
    struct gbuffer gbuffer;
    struct irradiance source, adaptive;
    open_bench(&bench, "scenes/cornell-box.glb", "vpls=1 interleave=1", .5f);
    make_stripes(&gbuffer);
    list_pixels(&bench, &gbuffer);
    fill(&source, SIZE, 8, .75f);
    fill(&adaptive, lists_height(), LISTS, .75f);
    for (int square = 0; square < 2; square++) {
        static float blurred[SIZE * SIZE];
        struct blur_desc desc = blur_of_lists;
        desc.square = square;
        read_blurred(&bench, &desc, &gbuffer,
                     &(struct blur_inputs){&source, &bench.adaptive.lists, &adaptive}, blurred);
        double worst = 0;
        for (int i = 0; i < SIZE * SIZE; i++)
            worst = fmax(worst, fabs((double)blurred[i] - .75));
        check_at_most("a blurred constant", worst, 1e-3);
    }
    irradiance_free(&source);
    irradiance_free(&adaptive);
    gbuffer_free(&gbuffer);
    close_bench(&bench);
}

/* A plane with an island that has no block's centre, and around one centre another normal. */
static void make_island(struct gbuffer *gbuffer, int block, int normal_of[SIZE * SIZE]) {
    check_ok(
        "G-buffer",
        gbuffer_init(gbuffer, &(struct gbuffer_desc){
                                  .label = "island", .width = SIZE, .height = SIZE, .layers = 1}));
    static float depths[SIZE * SIZE], normals[SIZE * SIZE][2];
    for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE, y = i / SIZE, center = block + block / 2;
        bool island =
            x > center + 2 && x < center + block - 1 && y > center + 2 && y < center + block - 1;
        bool around = abs(x - center) < 2 && abs(y - center) < 2;
        normal_of[i] = island ? 2 : around;
        depths[i] = .5f;
        normals[i][0] = around ? 1 : .5f; /* +x, else +z or +y */
        normals[i][1] = island ? 1 : .5f;
    }
    gl.TextureSubImage3D(gbuffer->depth.id, 0, 0, 0, 0, SIZE, SIZE, 1, GL_DEPTH_COMPONENT, GL_FLOAT,
                         depths);
    gl.TextureSubImage3D(gbuffer->normal.id, 0, 0, 0, 0, SIZE, SIZE, 1, GL_RG, GL_FLOAT, normals);
}

static int away_of(GLuint code) {
    return code > 1 ? (int)code - 4 : (int)code;
}

/* With blocks that share visibility a pixel that no block speaks for is adaptive, whatever lies
 * around it; all others are told one whose centre has their normal. */
TEST(blocks) {
    enum { BLOCK = 16 };
    struct adaptive_bench bench;
    struct gbuffer gbuffer;
    static int normal_of[SIZE * SIZE];
    open_bench(&bench, "scenes/cornell-box.glb", "vpls=1 interleave=1", .25f);
    struct adaptive_desc desc = bench.adaptive.desc;
    make_island(&gbuffer, BLOCK, normal_of);
    int adaptive[2] = {0}, left = 0, wrong = 0, others = 0;
    for (int blocks = 0; blocks < 2; blocks++) {
        adaptive_pass_free(&bench.adaptive);
        desc.block = blocks ? BLOCK : 0;
        check_ok("adaptive", adaptive_pass_init(&bench.adaptive, &desc));
        list_pixels(&bench, &gbuffer);
        for (int i = 0; i < SIZE * SIZE; i++)
            adaptive[blocks] += (bench.texels[i] & 1) != 0;
    }
    for (int i = 0; i < SIZE * SIZE; i++) {
        GLuint code = bench.texels[i];
        bool in_tiles = !(code & 1);
        int dx = away_of(code >> 1 & 3), dy = away_of(code >> 3 & 3);
        int x = (i % SIZE / BLOCK + dx) * BLOCK + BLOCK / 2,
            y = (i / SIZE / BLOCK + dy) * BLOCK + BLOCK / 2;
        left += in_tiles && normal_of[i] == 2;
        wrong += in_tiles && (x < 0 || y < 0 || x >= SIZE || y >= SIZE ||
                              normal_of[y * SIZE + x] != normal_of[i]);
        others += in_tiles && (dx || dy);
    }
    printf("    adaptive %d, without blocks %d; of the island not adaptive %d; told a wrong block "
           "%d, a "
           "neighbour's %d\n",
           adaptive[1], adaptive[0], left, wrong, others);
    assert_true(adaptive[1] > adaptive[0]);
    assert_int_equal(left, 0);
    assert_int_equal(wrong, 0);
    assert_true(others > BLOCK);
    gbuffer_free(&gbuffer);
    close_bench(&bench);
}

/* What is adaptive with n = 1 takes all VPLs and no blur, as all pixels without interleaving do. */
TEST(adaptive_sums) {
    struct adaptive_bench bench;
    open_bench(&bench, "scenes/cornell-animal.glb", "vpls=256 interleave=8 adaptive=1", 1);
    list_pixels(&bench, &bench.renderer.gbuffer);
    struct image mixed, plain = render_stage(&bench.stage, "unshadowed",
                                             "vpls=256 interleave=1 blur-radius=0", SIZE);
    check_ok("layers", renderer_read_layers(&bench.renderer, &mixed));
    int red = image_find_channel(&plain, "indirect.R"), adaptive = 0, away = 0;
    double worst = 0, mean = layer_mean(&plain, "indirect");
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            double expected = (double)image_at(&plain, x, y)[red];
            double off = fabs((double)image_at(&mixed, x, y)[red] - expected) / (expected + mean);
            bool is_adaptive = (bench.texels[(SIZE - 1 - y) * SIZE + x] & 1) != 0;
            adaptive += is_adaptive;
            away += !is_adaptive && off > .002;
            worst = is_adaptive ? fmax(worst, off) : worst;
        }
    printf("    adaptive %d, others that differ %d\n", adaptive, away);
    assert_true(adaptive > 100 && away > 100);
    check_at_most("worst adaptive pixel's distance from the sum over all VPLs", worst, .002);
    images_free(&mixed, &plain);
    close_bench(&bench);
}

/* Of VPLs that go together one asks for the visibility of all: each pixel has noise, their mean is
 * that of pixels whose VPLs each ask. */
TEST(one_asks_for_all) {
    struct adaptive_bench bench;
    open_bench(&bench, "scenes/cornell-animal.glb", "interleave=8 adaptive=1", 1);
    list_pixels(&bench, &bench.renderer.gbuffer);
    struct image each = render_stage(&bench.stage, "clustered", "interleave=1 blur-radius=0", SIZE);
    struct image together =
        render_stage(&bench.stage, "clustered", "interleave=8 adaptive=1", SIZE);
    int red = image_find_channel(&each, "indirect.R"), differ = 0, adaptive = 0;
    double sum_each = 0, sum_together = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            if (!(bench.texels[(SIZE - 1 - y) * SIZE + x] & 1))
                continue;
            double a = (double)image_at(&each, x, y)[red],
                   b = (double)image_at(&together, x, y)[red];
            adaptive++;
            differ += fabs(a - b) > .002 * a;
            sum_each += a;
            sum_together += b;
        }
    printf("    adaptive %d, of which with noise %d\n", adaptive, differ);
    assert_true(adaptive > 100 && differ > 50);
    check_near("their mean, over that of pixels whose VPLs each ask", sum_together / sum_each, 1,
               .005);
    images_free(&each, &together);
    close_bench(&bench);
}

/* Pixels of large pictures take fewer lights: of 4 and 5 times as many in one of 400x400, 1 in one
 * of 800x800. */
TEST(times_of_large_pictures) {
    static const struct {
        int size;
        bool same;
    } rows[] = {{400, false}, {800, true}};
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    for (int i = 0; i < 2; i++) {
        struct image four =
            render_stage(&stage, "unshadowed", "vpls=256 adaptive-factor=4", rows[i].size);
        struct image five =
            render_stage(&stage, "unshadowed", "vpls=256 adaptive-factor=5", rows[i].size);
        size_t size = (size_t)four.width * (size_t)four.height * (size_t)four.channel_count *
                      sizeof *four.pixels;
        bool same = memcmp(four.pixels, five.pixels, size) == 0;
        printf("    %dx%d: pictures of 4 and 5 times are %s\n", rows[i].size, rows[i].size,
               same ? "the same" : "others");
        assert_int_equal(same, rows[i].same);
        images_free(&four, &five);
    }
}

RUN_TESTS(open_group_context, close_group_context)
