#include "viewer/session.h"

#include "base/error.h"
#include "base/memory.h"
#include "techniques/technique.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static bool is_default(const struct option *option, const struct settings *settings) {
    struct settings defaults;
    options_set_defaults(settings_table, &defaults);
    return option_equal(option, settings, &defaults);
}

char *session_command(const struct session *session) {
    char *text = mem_strdup("manylight render"), value[64];
    append_quoted(&text, "", session->scene);
    append(&text, mem_printf(" --size %dx%d --technique %s", session->width, session->height,
                             technique_names[session->technique]));
    for (const struct option *option = settings_table; option->name; option++)
        if (!is_default(option, &session->settings)) {
            option_format(option, &session->settings, value, sizeof value);
            append(&text, mem_printf(" --set %s=%s", option->name, value));
        }
    if (session->time > 0)
        append(&text, mem_printf(" --time %.9g", session->time));
    append_quoted(&text, "--camera", session->camera);
    append_quoted(&text, "--light", session->light);
    append(&text, mem_strdup(" -o picture.png"));
    return text;
}

/* --- the file --- */

bool session_save(const struct session *session, const char *path) {
    FILE *file = fopen(path, "w");
    if (!file)
        return error_set("cannot write %s: %s", path, strerror(errno));
    char value[64];
    fprintf(file, "# manylight view: settings\ntechnique = %s\ncamera = %s\nlight = %s\n",
            technique_names[session->technique], session->camera, session->light);
    for (const struct option *option = settings_table; option->name; option++)
        if (!is_default(option, &session->settings)) {
            option_format(option, &session->settings, value, sizeof value);
            fprintf(file, "%s = %s\n", option->name, value);
        }
    if (fclose(file) != 0)
        return error_set("cannot write %s: %s", path, strerror(errno));
    return true;
}

static bool read_technique(struct session *session, const char *name) {
    for (int i = 0; technique_names[i]; i++)
        if (strcmp(technique_names[i], name) == 0) {
            session->technique = i;
            return true;
        }
    return error_set("no technique is called '%s'", name);
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
    const struct option *option = option_find(settings_table, line);
    if (strcmp(line, "technique") == 0)
        return read_technique(session, value);
    if (strcmp(line, "camera") == 0)
        return snprintf(session->camera, sizeof session->camera, "%s", value) > 0;
    if (strcmp(line, "light") == 0)
        return snprintf(session->light, sizeof session->light, "%s", value) > 0;
    if (!option)
        return error_set("no setting is called '%s'", line);
    return option_parse(option, &session->settings, value);
}

bool session_load(struct session *session, const char *path) {
    FILE *file = fopen(path, "r");
    if (!file)
        return error_set("cannot read %s: %s", path, strerror(errno));
    struct session read = *session;
    options_set_defaults(settings_table, &read.settings);
    char line[1024];
    bool ok = true;
    for (int number = 1; ok && fgets(line, sizeof line, file); number++)
        ok = read_line(&read, line) || error_prefix("%s:%d", path, number);
    fclose(file);
    if (!ok || !(settings_check(&read.settings) || error_prefix("%s", path)))
        return false;
    *session = read;
    return true;
}
