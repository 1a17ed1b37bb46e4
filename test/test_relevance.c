/* The panel hides what has no effect: that it has none is held here, bit for bit, and that what is
 * shown beside it has one. */
#include "render_support.h"

#include "viewer/relevance.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHEAP "vpls=64 vals=4 map.size=32 rsm-size=64 direct.shadow-size=128 interleave=4 detail=2 "

static struct stage stage;

/* Some other value of the setting than it has. */
static void set_otherwise(const struct setting *setting, struct settings *settings) {
    const struct option *option = setting->option;
    struct settings before = *settings;
    char text[64];
    double now = option_number(option, settings_of(settings, setting->part));
    const double tries[] = {now * 2 + 1, option->maximum, option->minimum};
    for (int i = 0; i < 3 && setting_equal(setting, settings, &before); i++) {
        if (option->type == OPTION_FLAG)
            snprintf(text, sizeof text, "%s", now != 0 ? "off" : "on");
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
    struct image before = render_layers(&desc);
    set_otherwise(&setting, &desc.settings);
    struct image after = render_layers(&desc);
    bool same = same_pixels(&before, &after);
    image_free(&before);
    image_free(&after);
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
    {"clustered", CHEAP "visibility=hard detail=0"},
    {"instant-radiosity", CHEAP},
    {"lightcuts", CHEAP "detail=0"},
};

static bool is_row_before(const struct relevance *row) {
    for (const struct relevance *other = relevances; other < row; other++)
        if (strcmp(other->name, row->name) == 0)
            return true;
    return false;
}

static void test_hidden(void **state) {
    (void)state;
    for (const struct relevance *row = relevances; row->name; row++)
        for (size_t i = 0; i < sizeof cases / sizeof *cases && !is_row_before(row); i++)
            if (!is_shown(row->name, cases[i].technique, cases[i].settings) &&
                changes(row->name, cases[i].technique, cases[i].settings))
                fail_msg("%s is hidden of %s %s, and changes the picture", row->name,
                         cases[i].technique, cases[i].settings);
}

static void test_shown(void **state) {
    (void)state;
    static const char *const rows[][2] = {
        {"lookup.terms", CHEAP "visibility=cssm"},
        {"lookup.gain", CHEAP "visibility=cssm"},
        {"lookup.taps", CHEAP "visibility=pcss"},
        {"lookup.taps", CHEAP},
        {"gather.near-samples", CHEAP},
        {"gather.clamp-value", CHEAP "clamp=value"},
        {"gather.detail-share", CHEAP},
        {"blur.distance", CHEAP},
        {"clustered.bounce-vals", CHEAP "lights.bounces=2"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bool effect = changes(rows[i][0], "clustered", rows[i][1]);
        printf("    %-24s %s\n", rows[i][0], effect ? "has an effect" : "has none");
        assert_true(is_shown(rows[i][0], "clustered", rows[i][1]));
        assert_true(effect);
    }
}

static int open_all(void **state) {
    int status = open_group_context(state);
    open_stage(&stage, "scenes/cornell-animal.glb");
    return status;
}

static int close_all(void **state) {
    stage_free(&stage);
    return close_group_context(state);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_hidden), cmocka_unit_test(test_shown)};
    return cmocka_run_group_tests(tests, open_all, close_all);
}
