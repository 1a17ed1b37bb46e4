/* The panel hides what has no effect: that it has none is held here, bit for bit, and that what is
 * shown beside it has one. */
#include "render_support.h"

#define CHEAP                                                                                      \
    "vpls=64 vals=4 map.size=32 rsm-size=64 direct.shadow-size=128 interleave=4 adaptive=2 "

#define AREAS "area-lights=16 cluster-lights.near=16 "
#define POINTS "map-points=64 imperfect-shadow-maps.size=16 "

#define VOXELS "volume.size=16 volume.rays=16 "

static struct stage stage;
static struct renderer renderer; /* follows from picture to picture */

/* Some other value of the setting than it has. */
static void set_otherwise(const struct setting *setting, struct settings *settings) {
    const struct option *option = setting->option;
    struct settings before = *settings;
    char text[64];
    double now = setting_number(setting, settings);
    const double tries[] = {now * 2 + 1, option->maximum, option->minimum};
    for (int i = 0; i < 3 && setting_equal(setting, settings, &before); i++) {
        if (option->type == OPTION_FLAG)
            snprintf(text, sizeof text, "%s", now != 0 ? "off" : "on");
        else if (option->type == OPTION_CHOICE)
            snprintf(text, sizeof text, "%s", option->choices[now == 0]);
        else
            snprintf(text, sizeof text, "%g",
                     option->type == OPTION_INT ? (double)(int)tries[i] : tries[i]);
        setting_parse(setting, settings, text);
    }
    assert_false(setting_equal(setting, settings, &before));
}

/* Whether another value of the setting makes another picture. */
static bool changes(const char *name, const char *technique, const char *settings) {
    struct renderer_desc desc = desc_of(&stage, technique, settings, 64, 64);
    struct setting setting;
    check_ok(name, settings_find(&desc.settings, name, &setting));
    OWNED(image) before = follow_layers(&renderer, &desc);
    set_otherwise(&setting, &desc.settings);
    OWNED(image) after = follow_layers(&renderer, &desc);
    bool same = same_pixels(&before, &after);
    return !same;
}

static bool is_shown(const char *name, const char *technique, const char *settings) {
    struct renderer_desc desc = desc_of(&stage, technique, settings, 64, 64);
    struct setting setting;
    check_ok(name, settings_find(&desc.settings, name, &setting));
    return setting_matters(&setting, &desc.settings, desc.technique);
}

static const struct {
    const char *technique, *settings;
} cases[] = {
    {"clustered", CHEAP},
    {"clustered", CHEAP "visibility=cssm clamp=value lights.bounces=2"},
    {"clustered", CHEAP "visibility=pcss clamp=disk blur.radius=0 caster.long=0"},
    {"clustered", CHEAP "visibility=hard adaptive=0"},
    {"instant-radiosity", CHEAP},
    {"instant-radiosity", CHEAP "traced=on"},
    {"lightcuts", CHEAP "adaptive=0"},
    {"cluster-lights", CHEAP AREAS},
    {"cluster-lights", CHEAP AREAS "cluster-lights.near=0 shadows=none adaptive=0"},
    {"cluster-lights", CHEAP AREAS "form=disk"},
    {"imperfect-shadow-maps", CHEAP POINTS},
    {"row-column", CHEAP "rows=4 columns=16"},
    {"imperfect-volume", CHEAP VOXELS},
    {"imperfect-volume", CHEAP VOXELS "volume=ao"},
    {"implicit-visibility", CHEAP "elements=200 radiosity.bins=6"},
};

enum { HIDDEN_MAX = 128 };

static int list_hidden(const struct renderer_desc *desc, struct setting hidden[HIDDEN_MAX]) {
    int count = 0;
    for (const struct settings_part *const *part = desc->technique->parts; *part; part++)
        for (const struct option *option = (*part)->table; option->name; option++) {
            struct setting setting = {*part, option};
            if (setting_matters(&setting, &desc->settings, desc->technique))
                continue;
            assert_true(count < HIDDEN_MAX);
            hidden[count++] = setting;
        }
    return count;
}

/* All at once; which of them it was is asked only where the picture changes. */
static void check_hidden(const char *technique, const char *settings) {
    struct renderer_desc desc = desc_of(&stage, technique, settings, 64, 64);
    struct setting hidden[HIDDEN_MAX];
    int count = list_hidden(&desc, hidden);
    struct image before = follow_layers(&renderer, &desc);
    for (int i = 0; i < count; i++)
        set_otherwise(&hidden[i], &desc.settings);
    struct image after = follow_layers(&renderer, &desc);
    bool same = same_pixels(&before, &after);
    images_free(&before, &after);
    printf("    %2d settings hidden of %s %s\n", count, technique, settings);
    for (int i = 0; !same && i < count; i++) {
        char name[SETTING_NAME_SIZE];
        setting_name(&hidden[i], name);
        printf("        %s %s\n", name, changes(name, technique, settings) ? "changes it" : "");
    }
    assert_true(same);
}

TEST(hidden) {
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_hidden(cases[i].technique, cases[i].settings);
}

TEST(shown) {
    static const char *const rows[][3] = {
        {"lookup.terms", "clustered", CHEAP "visibility=cssm"},
        {"gather.near-samples", "clustered", CHEAP},
        {"blur.distance", "clustered", CHEAP},
        {"clustered.bounce-vals", "clustered", CHEAP "lights.bounces=2"},
        {"cluster-lights.near", "cluster-lights", CHEAP AREAS},
        {"gather.adaptive", "cluster-lights", CHEAP AREAS "adaptive=0"},
        {"clustered.vals", "cluster-lights", CHEAP AREAS},
        {"clustered.iterations", "cluster-lights", CHEAP AREAS "shadows=none iterations=1"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bool effect = changes(rows[i][0], rows[i][1], rows[i][2]);
        printf("    %-24s of %s %s\n", rows[i][0], rows[i][1],
               effect ? "has an effect" : "has none");
        assert_true(is_shown(rows[i][0], rows[i][1], rows[i][2]));
        assert_true(effect);
    }
}

/* Rows under Advanced have plain names, no two alike under one heading. */
static void check_labels(const struct settings *settings) {
    const char *before[64];
    const struct settings_part *part = NULL;
    int count = 0, all = 0;
    for (struct setting setting = {0}; settings_next(settings, &setting); all++) {
        char name[SETTING_NAME_SIZE];
        setting_name(&setting, name);
        count = setting.part == part ? count : 0;
        part = setting.part;
        assert_true(count < 64);
        before[count] = setting.option->label;
        if (!before[count])
            fail_msg("%s has no .label in its row", name);
        if (strlen(before[count]) > 17)
            fail_msg("the label '%s' of %s has over 17 characters", before[count], name);
        for (int i = 0; i < count; i++)
            if (strcmp(before[i], before[count]) == 0)
                fail_msg("two settings of '%s' have the label '%s'", part->owner, before[i]);
        count++;
    }
    printf("    %d settings have labels\n", all);
    assert_true(all > 40); /* the loop has met the settings */
}

TEST(labels) {
    struct settings settings;
    renderer_settings_init(&settings);
    check_labels(&settings);
}

/* What rows need are settings and values that there are. */
TEST(needs) {
    struct settings settings;
    int count = 0;
    renderer_settings_init(&settings);
    for (struct setting setting = {0}; settings_next(&settings, &setting);)
        for (struct need need = {.word.at = setting.option->needs}; need_next(&need); count++) {
            struct setting other;
            bool of_techniques = strcmp(need.name, "technique") == 0;
            assert_true(strchr("=!>", need.sign));
            if (!of_techniques) {
                char name[SETTING_NAME_SIZE];
                check_ok(need.name, settings_find(&settings, need.name, &other));
                setting_name(&other, name);
                assert_string_equal(name, need.name);
            }
            for (char *value = strtok(need.values, "|"); value; value = strtok(NULL, "|"))
                check_ok(value, of_techniques ? technique_find(value) != NULL
                                              : setting_parse(&other, &settings, value));
        }
    printf("    %d needs\n", count);
    assert_true(count > 20);
}

static int open_all(void **state) {
    int status = open_group_context(state);
    stage = open_stage("scenes/cornell-animal.glb");
    return status;
}

static int close_all(void **state) {
    renderer_free(&renderer);
    stage_free(&stage);
    return close_group_context(state);
}

RUN_TESTS(open_all, close_all)
