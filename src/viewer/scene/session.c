#define _XOPEN_SOURCE 700
#include "viewer/scene/session.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/shell.h"
#include "renderer/renderer.h"
#include "scene/caustics.h"
#include "scene/material.h"
#include "scene/medium.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a session has beside settings and placings. */
static const struct option session_table[] = {
    {"layer", 0, OPTION_CHOICE, offsetof(struct session, layer), .choices = shown_layer_names},
    {"passes", 0, OPTION_INT, offsetof(struct session, passes), 0, 0, 1e6, .help = NULL},
    {"time", 0, OPTION_FLOAT, offsetof(struct session, time), 0, 0, 1e6, .help = NULL},
    {NULL},
};

/* Of its sky, where it has one. */
static const struct option sky_table[] = {
    {"environment-turn", 0, OPTION_FLOAT, offsetof(struct session, sky_turn), 0, -360, 360,
     .help = NULL},
    {"environment-strength", 0, OPTION_FLOAT, offsetof(struct session, sky_strength), 1, 1e-9, 1e9,
     .help = NULL},
    {NULL},
};

void session_free(struct session *session) {
    mem_free(session->lights, session->sky);
    session->lights = session->sky = NULL;
}

struct session session_copy(const struct session *session) {
    struct session copy = *session;
    copy.scene = NULL;
    copy.sky = session->sky ? mem_strdup(session->sky) : NULL;
    copy.lights = mem_strdup(session->lights);
    return copy;
}

int session_bounces(const struct session *session) {
    return (int)settings_number(&session->settings, "lights.bounces");
}

bool session_same_sky(const struct session *a, const struct session *b) {
    return a->sky_turn == b->sky_turn && a->sky_strength == b->sky_strength && !a->sky == !b->sky &&
           (!a->sky || strcmp(a->sky, b->sky) == 0);
}

void session_set_sky(struct session *session, const struct environment *sky) {
    session->sky = sky ? mem_strdup(sky->path) : NULL;
    session->sky_turn = sky ? sky->turn : 0;
    session->sky_strength = sky ? sky->strength : 1;
}

/* Glass and mirrors; a reference depends on no other settings of caustics. */
static bool same_surfaces(const struct settings *a, const struct settings *b) {
    const struct caustics_settings *own = settings_of(struct caustics_settings, a, &caustics_part),
                                   *other =
                                       settings_of(struct caustics_settings, b, &caustics_part);
    return (own->surface == CAUSTICS_OFF) == (other->surface == CAUSTICS_OFF) &&
           own->volume == other->volume && settings_same(a, b, &material_part);
}

bool session_same_view(const struct session *a, const struct session *b) {
    return strcmp(a->clip, b->clip) == 0 && a->time == b->time &&
           session_bounces(a) == session_bounces(b) && strcmp(a->camera, b->camera) == 0 &&
           strcmp(a->lights, b->lights) == 0 && session_same_sky(a, b) &&
           settings_same(&a->settings, &b->settings, &medium_part) &&
           same_surfaces(&a->settings, &b->settings);
}

/* Steps through the settings that are not at their defaults. */
static bool next_changed(const struct settings *settings, struct setting *setting) {
    struct settings usual;
    renderer_settings_init(&usual);
    while (settings_next(settings, setting))
        if (!setting_equal(setting, settings, &usual))
            return true;
    return false;
}

/* --- the command line --- */

static void append(char **text, char *more) {
    char *longer = mem_printf("%s%s", *text, more);
    mem_free(*text, more);
    *text = longer;
}

static void append_quoted(char **text, const char *option, const char *word) {
    char *quoted = shell_quote(word);
    append(text, mem_printf(" %s%s%s", option, *option ? " " : "", quoted));
    free(quoted);
}

/* Those that are not at their defaults. */
static void append_options(char **text, const struct option *table, const struct session *session) {
    struct session usual = *session;
    char value[64];
    options_set_defaults(table, &usual);
    for (const struct option *option = table; option->name; option++)
        if (!option_equal(option, session, &usual)) {
            option_format(option, session, value, sizeof value);
            append(text, mem_printf(" --%s %s", option->name, value));
        }
}

char *session_command(const struct session *session) {
    char *program = shell_own_program(), *text = mem_printf("%s render", program), value[64];
    free(program);
    append_quoted(&text, "", session->scene);
    append(&text, mem_printf(" --size %dx%d", session->width, session->height));
    append_options(&text, session_table, session);
    if (session->technique != technique_default)
        append(&text, mem_printf(" --technique %s", session->technique->name));
    if (session->direct)
        append(&text, mem_printf(" --direct %s", session->direct->name));
    for (struct setting setting = {0}; next_changed(&session->settings, &setting);) {
        char name[SETTING_NAME_SIZE];
        setting_name(&setting, name);
        setting_format(&setting, &session->settings, value, sizeof value);
        append(&text, mem_printf(" --set %s=%s", name, value));
    }
    if (*session->shown_scene)
        append_quoted(&text, "--scene", session->shown_scene);
    if (*session->variant)
        append_quoted(&text, "--variant", session->variant);
    append_quoted(&text, "--camera", session->camera);
    append_quoted(&text, "--light", session->lights);
    if (*session->clip)
        append_quoted(&text, "--clip", session->clip);
    if (session->sky) {
        append_quoted(&text, "--environment", session->sky);
        append_options(&text, sky_table, session);
    }
    append(&text, mem_strdup(" -o picture.png"));
    return text;
}

/* --- the file --- */

static void write_value(FILE *file, const struct option *option, const void *values) {
    char value[64];
    option_format(option, values, value, sizeof value);
    fprintf(file, "%s = %s\n", option->name, value);
}

static void write_setting(FILE *file, const struct setting *setting,
                          const struct settings *settings) {
    char name[SETTING_NAME_SIZE], value[64];
    setting_name(setting, name);
    setting_format(setting, settings, value, sizeof value);
    fprintf(file, "%s = %s\n", name, value);
}

bool session_save(const struct session *session, const char *path) {
    struct output_text text;
    if (session->scene && !output_file_is_not(path, session->scene))
        return false;
    output_text_init(&text);
    fprintf(text.stream,
            "# manylight view: settings\ntechnique = %s\ncamera = %s\nlight = %s\nclip = %s\n",
            session->technique->name, session->camera, session->lights,
            *session->clip ? session->clip : "all");
    if (session->direct)
        fprintf(text.stream, "direct = %s\n", session->direct->name);
    char *sky = session->sky ? realpath(session->sky, NULL) : NULL;
    fprintf(text.stream, "environment = %s\n", sky ? sky : session->sky ? session->sky : "none");
    free(sky);
    for (int i = 0; i < SESSION_VIEWS; i++)
        if (*session->views[i])
            fprintf(text.stream, "view%d = %s\n", i + 1, session->views[i]);
    for (const struct option *option = session_table; option->name; option++)
        write_value(text.stream, option, session);
    for (const struct option *option = sky_table; session->sky && option->name; option++)
        write_value(text.stream, option, session);
    for (struct setting setting = {0}; next_changed(&session->settings, &setting);)
        write_setting(text.stream, &setting, &session->settings);
    return output_text_end(&text, path);
}

/* "view1" to "view9"; -1 = another key. */
static int view_of(const char *key) {
    bool is_view = strncmp(key, "view", 4) == 0 && key[4] >= '1' && key[4] < '1' + SESSION_VIEWS &&
                   key[5] == '\0';
    return is_view ? key[4] - '1' : -1;
}

static bool read_sky(struct session *session, const char *value) {
    free(session->sky);
    session->sky = strcmp(value, "none") == 0 ? NULL : mem_strdup(value);
    return true;
}

/* sky: whether the file says of one. */
static bool read_line(struct session *session, char *line, bool *sky) {
    char *equals = strstr(line, " = ");
    line[strcspn(line, "\r\n")] = '\0';
    if (line[0] == '#' || line[0] == '\0')
        return true;
    if (!equals)
        return error_set("'%s' is not 'key = value'", line);
    *equals = '\0';
    const char *value = equals + 3;
    const struct option *option = option_find(session_table, line);
    option = option ? option : option_find(sky_table, line);
    if (option)
        return option_parse(option, session, value);
    int view = view_of(line);
    if (view >= 0)
        return snprintf(session->views[view], sizeof session->views[view], "%s", value) > 0;
    if (strcmp(line, "environment") == 0)
        return *sky = read_sky(session, value);
    if (strcmp(line, "camera") == 0)
        return snprintf(session->camera, sizeof session->camera, "%s", value) > 0;
    if (strcmp(line, "clip") == 0)
        return snprintf(session->clip, sizeof session->clip, "%s",
                        strcmp(value, "all") == 0 ? "" : value) >= 0;
    if (strcmp(line, "light") == 0) {
        free(session->lights);
        session->lights = mem_strdup(value);
        return true;
    }
    if (strcmp(line, "technique") == 0) {
        const struct technique *technique = technique_find(value);
        session->technique = technique ? technique : session->technique;
        return technique;
    }
    if (strcmp(line, "direct") == 0) {
        session->direct = direct_find(value);
        return session->direct;
    }
    struct setting setting;
    return settings_find(&session->settings, line, &setting) &&
           setting_parse(&setting, &session->settings, value);
}

bool session_load(struct session *session, const char *path) {
    FILE *file = fopen(path, "r");
    if (!file)
        return error_set("cannot read %s: %s", path, strerror(errno));
    struct session read = session_copy(session);
    read.scene = session->scene;
    memset(read.views, 0, sizeof read.views);
    memset(read.clip, 0, sizeof read.clip);
    options_set_defaults(session_table, &read);
    options_set_defaults(sky_table, &read);
    read.technique = technique_default;
    read.direct = NULL;
    renderer_settings_init(&read.settings);
    char *line = NULL;
    size_t room = 0;
    bool ok = true, has_sky = false;
    for (int number = 1; ok && getline(&line, &room, file) >= 0; number++)
        ok = read_line(&read, line, &has_sky) || error_prefix("%s:%d", path, number);
    free(line);
    fclose(file);
    if (!has_sky) { /* the scene's stays as it is */
        read.sky_turn = session->sky_turn;
        read.sky_strength = session->sky_strength;
    }
    session_free(ok ? session : &read);
    if (ok)
        *session = read;
    return ok;
}
