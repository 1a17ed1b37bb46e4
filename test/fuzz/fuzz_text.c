#include "fuzz/fuzz.h"

#include "base/memory.h"
#include "scene/placing.h"
#include "viewer/scene/session.h"

#include <stdlib.h>
#include <string.h>

/* A camera and lights of each kind, which texts are about. */
static const char stage_text[] =
    "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"KHR_lights_punctual\"],\"extensions\":{"
    "\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"spot\",\"name\":\"lamp\",\"spot\":{}},"
    "{\"type\":\"point\",\"extras\":{\"radius\":0.1}},{\"type\":\"directional\"}]}},"
    "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":1,\"znear\":0.1}}],"
    "\"nodes\":[{\"camera\":0},{\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}},"
    "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":1}}},"
    "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":2}}}],"
    "\"scenes\":[{\"nodes\":[0,1,2,3]}],\"scene\":0}";

static const struct scene *stage(void) {
    static struct scene scene;
    if (!scene.path && !scene_load(&scene, fuzz_file(stage_text, sizeof stage_text - 1)))
        abort();
    return &scene;
}

static void require(bool holds) {
    if (!holds)
        abort();
}

static void fuzz_settings(const char *text) {
    struct settings settings, again;
    renderer_settings_init(&settings);
    if (!renderer_settings_assign(&settings, technique_default, &text, 1))
        return;
    renderer_settings_init(&again);
    for (struct setting setting = {0}; settings_next(&settings, &setting);) {
        char told[64];
        setting_format(&setting, &settings, told, sizeof told);
        require(setting_parse(&setting, &again, told) &&
                setting_equal(&setting, &settings, &again));
    }
}

static void fuzz_session(const char *text) {
    struct session session = {.scene = "a scene's.glb",
                              .width = 64,
                              .height = 48,
                              .technique = technique_default,
                              .camera = "0",
                              .lights = mem_strdup("0")};
    renderer_settings_init(&session.settings);
    if (session_load(&session, fuzz_file(text, strlen(text))))
        free(session_command(&session));
    session_free(&session);
}

static void fuzz_camera(const char *text) {
    struct camera camera, again;
    char told[PLACING_TEXT_SIZE];
    int n;
    if (!camera_from_text(&camera, stage(), text, 0, &n))
        return;
    camera_to_text(&camera, stage(), n, 0, told);
    require(camera_from_text(&again, stage(), told, 0, &n));
}

static void fuzz_lights(const char *text) {
    struct emitters emitters = {0}, again = {0};
    if (!emitters_from_text(&emitters, stage(), text, 0))
        return;
    char *told = emitters_to_text(&emitters, stage(), 0);
    require(emitters_from_text(&again, stage(), told, 0) && again.count == emitters.count);
    free(told);
    emitters_free(&emitters);
    emitters_free(&again);
}

struct values {
    bool flag;
    int number, choice, size[2];
    float real;
    const char *text;
    struct text_list list;
};

static void fuzz_arguments(char *text) {
    static const char *const choices[] = {"one", "two", NULL};
    static const struct option table[] = {
        {"flag", 'f', OPTION_FLAG, offsetof(struct values, flag), .help = ""},
        {"number", 'n', OPTION_INT, offsetof(struct values, number), 1, 0, 9, .help = ""},
        {"real", 'r', OPTION_FLOAT, offsetof(struct values, real), .5, 0, 1, .help = ""},
        {"choice", 'c', OPTION_CHOICE, offsetof(struct values, choice), .choices = choices,
         .help = ""},
        {"text", 't', OPTION_TEXT, offsetof(struct values, text), .help = ""},
        {"list", 'l', OPTION_LIST, offsetof(struct values, list), .help = ""},
        {"size", 's', OPTION_SIZE, offsetof(struct values, size), 8, 1, 64, .help = ""},
        {NULL},
    };
    char *words[100] = {"manylight"};
    int count = 1;
    for (char *word = strtok(text, "\n"); word && count < 100; word = strtok(NULL, "\n"))
        words[count++] = word;
    struct values values;
    const char *positional[3];
    int positional_count;
    options_set_defaults(table, &values);
    if (options_parse_arguments(table, &values, count, words, positional, 3, &positional_count,
                                NULL))
        require(positional_count <= 3 && values.number >= 0 && values.number <= 9 &&
                values.real >= 0 && values.real <= 1 && values.size[0] >= 1 &&
                values.size[1] <= 64);
}

void fuzz_text(const uint8_t *bytes, size_t size) {
    if (size == 0)
        return;
    char *text = mem_alloc(size, 1);
    memcpy(text, bytes + 1, size - 1);
    switch (bytes[0] % 5) {
    case 0:
        fuzz_settings(text);
        break;
    case 1:
        fuzz_session(text);
        break;
    case 2:
        fuzz_camera(text);
        break;
    case 3:
        fuzz_lights(text);
        break;
    case 4:
        fuzz_arguments(text);
        break;
    }
    free(text);
}
