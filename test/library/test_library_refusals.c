/* Bad input through the library's door: a status, and the same words as the program's. */
#define _XOPEN_SOURCE 700
#include "library_support.h"

#define BOX "scenes/cornell-box.glb"
#define SCENE(...) PART(scene_desc, __VA_ARGS__)

/* The program ends with "manylight render: MESSAGE", and more of wrong usage. */
static void check_words(enum manylight_status status, enum manylight_status wanted,
                        const char *line) {
    printf("    status %d: %s\n", status, manylight_error());
    assert_int_equal(status, wanted);
    run_line(line);
    const char *words = form(": %s\n", manylight_error());
    expect_text(words);
}

static void check_broken_file(const char *path) {
    struct manylight_scene *scene;
    const char *line = form("%% render %s -o @/x.exr", path);
    check_words(manylight_scene_open(SCENE(.path = path), &scene), MANYLIGHT_BAD_SCENE, line);
    assert_null(scene);
}

TEST(broken_scenes) {
    struct manylight_scene *scene;
    static const char cut[] = "glTF\2\0\0\0";
    write_text(scratch("text.glb"), "no scene");
    expect(0, "head -c 3000 " BOX " > @/cut.glb");
    check_broken_file(scratch("text.glb"));
    check_broken_file(scratch("cut.glb"));
    check_words(manylight_scene_open(SCENE(.path = "nowhere.glb"), &scene), MANYLIGHT_BAD_SCENE,
                "% render nowhere.glb -o @/x.exr");
    check_words(manylight_scene_open(SCENE(.path = BOX, .light = "sun"), &scene),
                MANYLIGHT_BAD_SCENE, "% render " BOX " --light sun -o @/x.exr");
    check_words(manylight_scene_open(SCENE(.path = BOX, .environment = "none.hdr"), &scene),
                MANYLIGHT_BAD_SCENE, "% render " BOX " --environment none.hdr -o @/x.exr");
    check_failed(manylight_scene_open(SCENE(.memory = cut, .memory_bytes = 8), &scene),
                 MANYLIGHT_BAD_SCENE, "memory: truncated: 8 bytes are no GLB file");
    check_failed(manylight_scene_open(SCENE(.memory = "", .memory_bytes = 0), &scene),
                 MANYLIGHT_BAD_SCENE, "memory: the file is empty");
}

/* A scene of arrays, each with one fault. */
static const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                   odd_corners[] = {0, 0, 0, 1, NAN, 0, 0, 1, 0};
static const uint32_t indices[] = {0, 1, 7};
#define MESH(...) .meshes = PART(mesh, .vertex_count = 3, __VA_ARGS__), .mesh_count = 1
#define MATERIAL(...)                                                                              \
    MESH(.positions = corners), .materials = PART(material, __VA_ARGS__), .material_count = 1
#define LIGHT(...) MESH(.positions = corners), .lights = PART(light, __VA_ARGS__), .light_count = 1
#define CAMERA(...)                                                                                \
    MESH(.positions = corners), .cameras = PART(camera, __VA_ARGS__), .camera_count = 1
static const struct {
    const struct manylight_scene_desc *desc;
    const char *words;
} broken[] = {
    {SCENE(MESH(.positions = corners, .indices = indices, .index_count = 3)), "arrays: mesh 0"},
    {SCENE(MESH(.positions = corners, .indices = indices, .index_count = 2)),
     "arrays: mesh 0: 2 indices make no whole triangles"},
    {SCENE(MESH(.positions = odd_corners)),
     "arrays: mesh 0: the position of vertex 1 is not finite"},
    {SCENE(MESH(.positions = NULL)), "mesh 0: positions is NULL"},
    {SCENE(MESH(.positions = corners, .material = 3)),
     "arrays: mesh 0: material: 3 is not from 0 to 0"},
    {SCENE(MATERIAL(.emission = {0, INFINITY})), "material 0: emission: inf is not finite"},
    {SCENE(MATERIAL(.base_color = {255, 0, 0, 1})),
     "material 0: base_color: 255 is not from 0 to 1"},
    {SCENE(MATERIAL(.picture = "not a picture", .picture_bytes = 13)),
     "material 0: picture: its bytes are neither PNG nor JPEG"},
    {SCENE(MATERIAL(.picture = "\x89PNG, cut off", .picture_bytes = 13)), "material 0: picture: "},
    {SCENE(LIGHT(.intensity = {NAN})), "light 0: intensity: nan is not finite"},
    {SCENE(LIGHT(.type = MANYLIGHT_AREA)), "light 0: extent: the width is 0"},
    {SCENE(LIGHT(.inner_angle = 1)), "light 0: inner_angle: 1 is not from 0 to 0.7854"},
    {SCENE(LIGHT(.up = {0, 1, 0})), "light 0: up is along direction"},
    {SCENE(CAMERA(.forward = {0, 1, 0}, .up = {0, 2, 0})), "camera 0: up is along forward"},
    {SCENE(CAMERA(.near_plane = -1)), "camera 0: near_plane: -1 is below 0"},
    {SCENE(CAMERA(.right = {1.5F})), "camera 0: right is not that of forward and up"},
};

TEST(broken_arrays) {
    struct manylight_scene *scene;
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++)
        check_failed(manylight_scene_open(broken[i].desc, &scene), MANYLIGHT_BAD_SCENE,
                     broken[i].words);
    check_failed(manylight_scene_open(
                     SCENE(.meshes = &(struct manylight_mesh){.size = 0}, .mesh_count = 1), &scene),
                 MANYLIGHT_BAD_ARGUMENT, "manylight_mesh: its size is 0");
    check_failed(manylight_scene_open(SCENE(MESH(.positions = corners), .light_count = 2), &scene),
                 MANYLIGHT_BAD_ARGUMENT, "a list of 2 parts is NULL");
}

TEST(scene_descriptors) {
    struct manylight_scene *scene;
    struct {
        struct manylight_scene_desc desc;
        int more;
    } newer = {.desc = {.size = sizeof newer, .path = BOX}, .more = 1};
    check_failed(manylight_scene_open(&(struct manylight_scene_desc){.path = BOX}, &scene),
                 MANYLIGHT_BAD_ARGUMENT, "manylight_scene_desc: its size is 0");
    check_failed(manylight_scene_open(&newer.desc, &scene), MANYLIGHT_BAD_ARGUMENT,
                 "it is of a newer header");
    newer.more = 0;
    check_call("a newer header, not used", manylight_scene_open(&newer.desc, &scene));
    manylight_scene_free(scene);
    newer.desc.size = offsetof(struct manylight_scene_desc, root);
    newer.desc.root = "no-folder";
    check_call("an older header, without root", manylight_scene_open(&newer.desc, &scene));
    manylight_scene_free(scene);
    check_failed(manylight_scene_open(SCENE(.path = NULL), &scene), MANYLIGHT_BAD_ARGUMENT,
                 "a scene needs a path, memory or meshes");
    check_failed(manylight_scene_open(SCENE(.path = "-"), &scene), MANYLIGHT_BAD_ARGUMENT,
                 "it is a pipe");
    check_failed(manylight_scene_open(SCENE(.path = BOX, .root = "no-folder"), &scene),
                 MANYLIGHT_BAD_SCENE, "no-folder: ");
    check_failed(manylight_scene_open(SCENE(.path = BOX, .scene = "hall"), &scene),
                 MANYLIGHT_BAD_SCENE, BOX ": no scene 'hall' (there is: 0");
    check_failed(manylight_scene_open(SCENE(.path = BOX, .variant = "red"), &scene),
                 MANYLIGHT_BAD_SCENE, BOX ": no variant 'red' (there is: none)");
}

static const struct {
    const char *arguments, *words; /* words NULL: the program's */
    struct manylight_renderer_desc desc;
    enum manylight_status status;
} settings[] = {
    {"--set velvet=1", NULL, {.settings = "velvet=1"}, MANYLIGHT_BAD_SETTING},
    {"--set vpls=many", NULL, {.settings = "vpls=many"}, MANYLIGHT_BAD_SETTING},
    {"--technique magic", NULL, {.technique = "magic"}, MANYLIGHT_BAD_SETTING},
    {"--direct magic", NULL, {.direct = "magic"}, MANYLIGHT_BAD_SETTING},
    {"--size 0x5", NULL, {.height = 5}, MANYLIGHT_BAD_ARGUMENT},
    {"--size 20000x5", NULL, {.width = 20000, .height = 5}, MANYLIGHT_BAD_ARGUMENT},
    {"--camera 9", NULL, {.camera = "9"}, MANYLIGHT_BAD_ARGUMENT},
    {"",
     "no quality is called 'best' (there is: draft normal high final)",
     {.quality = "best"},
     MANYLIGHT_BAD_SETTING},
    {"", "passes: -1 is not from 0 to 1e+06", {.passes = -1}, MANYLIGHT_BAD_ARGUMENT},
};

TEST(settings) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_renderer *renderer;
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        struct manylight_renderer_desc desc = settings[i].desc;
        desc.size = sizeof desc;
        enum manylight_status status = manylight_renderer_create(device, scene, &desc, &renderer);
        assert_null(renderer);
        const char *line = form("%% render " BOX " -o @/x.exr %s", settings[i].arguments);
        if (settings[i].words)
            check_failed(status, settings[i].status, settings[i].words);
        else
            check_words(status, settings[i].status, line);
    }
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* A change that is refused leaves the renderer what it was. */
TEST(refused_change) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_renderer *renderer = open_drawing(device, scene, NULL);
    struct manylight_image *before, *after, *none;
    struct manylight_renderer_desc desc = {.size = sizeof desc, .settings = "vpls=never"};
    check_call("render", manylight_render(renderer, NULL));
    check_call("read", manylight_read(renderer, NULL, &before));
    check_failed(manylight_renderer_change(renderer, &desc), MANYLIGHT_BAD_SETTING, "vpls");
    check_call("render", manylight_render(renderer, NULL));
    check_call("read", manylight_read(renderer, NULL, &after));
    assert_true(same_images(before, after));
    check_failed(manylight_read(renderer, "velvet", &none), MANYLIGHT_BAD_ARGUMENT,
                 "no layer 'velvet' to add");
    assert_null(none);
    manylight_image_free(before);
    manylight_image_free(after);
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* Cameras that no view may have. */
static const struct {
    struct manylight_camera *camera;
    const char *words;
} cameras[] = {
    {PART(camera, .eye = {NAN}), "camera: eye: nan is not finite"},
    {PART(camera, .forward = {.2F, 0, -1}, .right = {1}, .up = {0, 1, 0}),
     "camera: right, up and forward are not at right angles"},
    {PART(camera, .fov_y = 60), "camera: fov_y (radians): 60 is not from 0 to 3.142"},
    {PART(camera, .forward = {0, 1, 0}), "camera: up is along forward"},
};

TEST(views) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_renderer *renderer = open_drawing(device, scene, NULL);
    struct manylight_image *image;
    char text[16];
    check_words(manylight_render(renderer, PART(view, .camera = "9")), MANYLIGHT_BAD_ARGUMENT,
                "% render " BOX " -o @/x.exr --camera 9");
    check_words(manylight_render(renderer, PART(view, .light = "sun")), MANYLIGHT_BAD_ARGUMENT,
                "% render " BOX " -o @/x.exr --light sun");
    check_failed(manylight_render(renderer, PART(view, .time = -1)), MANYLIGHT_BAD_ARGUMENT,
                 "time: -1");
    for (size_t i = 0; i < sizeof cameras / sizeof *cameras; i++)
        check_failed(manylight_render(renderer, PART(view, .placed = cameras[i].camera)),
                     MANYLIGHT_BAD_ARGUMENT, cameras[i].words);
    check_call("render", manylight_render(renderer, NULL));
    check_failed(manylight_render(renderer, &(struct manylight_view){.size = 0}),
                 MANYLIGHT_BAD_ARGUMENT, "its size is 0");
    check_failed(manylight_read(renderer, NULL, &image), MANYLIGHT_BAD_ARGUMENT, "no frame");
    check_failed(manylight_renderer_setting(renderer, NULL, text, sizeof text),
                 MANYLIGHT_BAD_ARGUMENT, "name is NULL");
    manylight_renderer_free(renderer);
    manylight_scene_free(scene);
    manylight_device_free(device);
}

/* Machines of tests have OpenGL on the CPU alone, or besides. */
TEST(devices) {
    struct manylight_device *device;
    struct manylight_device_info info = {.size = sizeof info};
    struct manylight_device_desc desc = {.size = sizeof desc, .device = "99", .allow_software = 1};
    check_words(manylight_device_create(&desc, &device), MANYLIGHT_NO_DEVICE,
                "% render " BOX " -o @/x.exr --device 99");
    assert_null(device);
    desc.device = "a good one";
    check_words(manylight_device_create(&desc, &device), MANYLIGHT_NO_DEVICE,
                "% render " BOX " -o @/x.exr --device 'a good one'");
    desc = (struct manylight_device_desc){.size = sizeof desc};
    enum manylight_status status = manylight_device_create(&desc, &device);
    if (status == MANYLIGHT_OK) {
        check_call("info", manylight_device_info(device, &info));
        assert_false(info.software);
        manylight_device_free(device);
    } else {
        check_failed(status, MANYLIGHT_NO_DEVICE,
                     "no hardware (allow_software is off): no OpenGL 4.5 core ");
        desc.device = "hardware";
        check_words(manylight_device_create(&desc, &device), MANYLIGHT_NO_DEVICE,
                    "% render " BOX " -o @/x.exr --device hardware");
    }
    struct manylight_host host = {.size = sizeof host};
    desc.host = &host;
    check_failed(manylight_device_create(&desc, &device), MANYLIGHT_BAD_ARGUMENT,
                 "get_proc is NULL");
}

/* The program's --device takes software that is named; the library asks for allow_software. */
TEST(software_not_allowed) {
    char text[4096], number[8] = "";
    struct manylight_device *device;
    struct manylight_device_desc desc = {.size = sizeof desc, .device = number};
    manylight_list_devices(text, sizeof text);
    const char *software = strstr(text, " (software)");
    if (!software) {
        printf("    skipped: no software device\n");
        skip();
    }
    snprintf(number, sizeof number, "%d", software[-1] - '0');
    check_failed(manylight_device_create(&desc, &device), MANYLIGHT_NO_DEVICE,
                 "(software): it is software, which allow_software takes");
}

TEST(too_much_memory) {
    struct manylight_device *device = open_device();
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_renderer *renderer;
    struct manylight_image *image;
    const float pixel = 0;
    const struct manylight_renderer_desc desc = {.size = sizeof desc,
                                                 .settings = "volume.size=512",
                                                 .technique = "imperfect-volume",
                                                 .width = 8,
                                                 .height = 8};
    check_words(manylight_renderer_create(device, scene, &desc, &renderer), MANYLIGHT_NO_MEMORY,
                "% render " BOX
                " -o @/x.exr --size 8x8 --technique imperfect-volume --set volume.size=512");
    assert_null(renderer);
    check_failed(
        manylight_image_create(1 << 20, 1 << 20, "R G B", &pixel, &image), MANYLIGHT_NO_MEMORY,
        "a picture of 1048576x1048576 with 3 channels: 12288.00 GiB of memory are wanted, and ");
    manylight_scene_free(scene);
    manylight_device_free(device);
}

TEST(reference) {
    struct manylight_scene *scene = open_scene(BOX);
    struct manylight_image *image;
    check_words(
        manylight_reference(scene, PART(reference_desc, .samples = 4, .noise = .1F), &image),
        MANYLIGHT_BAD_ARGUMENT, "% reference " BOX " -o @/x.exr --spp 4 --noise .1");
    check_failed(manylight_reference(scene, PART(reference_desc, .noise = -1), &image),
                 MANYLIGHT_BAD_ARGUMENT, "noise: -1 is not from 0 to 1");
    check_failed(manylight_reference(scene, PART(reference_desc, .bounces = 2000), &image),
                 MANYLIGHT_BAD_ARGUMENT, "bounces: 2000 is not from 0 to 1000");
    check_words(manylight_reference(scene, PART(reference_desc, .settings = "vpls=4"), &image),
                MANYLIGHT_BAD_SETTING, "% reference " BOX " -o @/x.exr --set vpls=4");
    check_words(manylight_reference(
                    scene, PART(reference_desc, .smooth = 1, .materials = "diffuse"), &image),
                MANYLIGHT_BAD_ARGUMENT,
                "% reference " BOX " -o @/x.exr --smooth --materials diffuse");
    assert_null(image);
    manylight_scene_free(scene);
}

RUN_TESTS(NULL, NULL)
