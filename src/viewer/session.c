#define _POSIX_C_SOURCE 200809L
#include "viewer/session.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "renderer/renderer.h"
#include "scene/environment.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a session has beside settings and placings. */
static const struct option session_table[] = {
    {"layer", 0, OPTION_CHOICE, offsetof(struct session, layer), .choices = shown_layer_names},
    {"clip", 0, OPTION_INT, offsetof(struct session, clip), 0, 0, 1e6, .help = NULL},
    {"passes", 0, OPTION_INT, offsetof(struct session, passes), 0, 0, 1e6, .help = NULL},
    {"time", 0, OPTION_FLOAT, offsetof(struct session, time), 0, 0, 1e6, .help = NULL},
    {NULL},
};

void session_free(struct session *session) {
    free(session->lights);
    session->lights = NULL;
}

struct session session_copy(const struct session *session) {
    struct session copy = *session;
    copy.scene = NULL;
    copy.environment = NULL;
    copy.lights = mem_strdup(session->lights);
    return copy;
}

int session_bounces(const struct session *session) {
    return (int)settings_number(&session->settings, "lights.bounces");
}

bool session_same_view(const struct session *a, const struct session *b) {
    return a->clip == b->clip && a->time == b->time && session_bounces(a) == session_bounces(b) &&
           strcmp(a->camera, b->camera) == 0 && strcmp(a->lights, b->lights) == 0;
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
    free(*text);
    free(more);
    *text = longer;
}

/* In single quotes where a shell would take it apart; a single quote closes, escapes and opens. */
static char *quote(const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+=./,:@%";
    if (*word && word[strspn(word, plain)] == '\0')
        return mem_strdup(word);
    char *quoted = mem_strdup("'");
    for (const char *c = word; *c; c++)
        append(&quoted, *c == '\'' ? mem_strdup("'\\''") : mem_printf("%c", *c));
    append(&quoted, mem_strdup("'"));
    return quoted;
}

static void append_quoted(char **text, const char *option, const char *word) {
    char *quoted = quote(word);
    append(text, mem_printf(" %s%s%s", option, *option ? " " : "", quoted));
    free(quoted);
}

static void append_environment(char **text, const struct environment *environment) {
    append_quoted(text, "--environment", environment->path);
    if (environment->turn != 0)
        append(text, mem_printf(" --environment-turn %.9g", (double)environment->turn));
    if (environment->strength != 1)
        append(text, mem_printf(" --environment-strength %.9g", (double)environment->strength));
}

char *session_command(const struct session *session) {
    char *text = mem_strdup("manylight render"), value[64];
    append_quoted(&text, "", session->scene);
    append(&text, mem_printf(" --size %dx%d", session->width, session->height));
    struct session usual = *session;
    options_set_defaults(session_table, &usual);
    for (const struct option *option = session_table; option->name; option++)
        if (!option_equal(option, session, &usual)) {
            option_format(option, session, value, sizeof value);
            append(&text, mem_printf(" --%s %s", option->name, value));
        }
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
    append_quoted(&text, "--camera", session->camera);
    append_quoted(&text, "--light", session->lights);
    if (session->environment)
        append_environment(&text, session->environment);
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
    fprintf(text.stream, "# manylight view: settings\ntechnique = %s\ncamera = %s\nlight = %s\n",
            session->technique->name, session->camera, session->lights);
    if (session->direct)
        fprintf(text.stream, "direct = %s\n", session->direct->name);
    for (int i = 0; i < SESSION_VIEWS; i++)
        if (*session->views[i])
            fprintf(text.stream, "view%d = %s\n", i + 1, session->views[i]);
    for (const struct option *option = session_table; option->name; option++)
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

static bool read_line(struct session *session, char *line) {
    char *equals = strstr(line, " = ");
    line[strcspn(line, "\r\n")] = '\0';
    if (line[0] == '#' || line[0] == '\0')
        return true;
    if (!equals)
        return error_set("'%s' is not 'key = value'", line);
    *equals = '\0';
    const char *value = equals + 3;
    const struct option *option = option_find(session_table, line);
    if (option)
        return option_parse(option, session, value);
    int view = view_of(line);
    if (view >= 0)
        return snprintf(session->views[view], sizeof session->views[view], "%s", value) > 0;
    if (strcmp(line, "camera") == 0)
        return snprintf(session->camera, sizeof session->camera, "%s", value) > 0;
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
    struct session read = *session;
    read.lights = mem_strdup(session->lights);
    memset(read.views, 0, sizeof read.views);
    options_set_defaults(session_table, &read);
    read.technique = technique_default;
    read.direct = NULL;
    renderer_settings_init(&read.settings);
    char *line = NULL;
    size_t room = 0;
    bool ok = true;
    for (int number = 1; ok && getline(&line, &room, file) >= 0; number++)
        ok = read_line(&read, line) || error_prefix("%s:%d", path, number);
    free(line);
    fclose(file);
    session_free(ok ? session : &read);
    if (ok)
        *session = read;
    return ok;
}
