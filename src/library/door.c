#define _GNU_SOURCE /* newlocale */
#include "library/door.h"

#include "base/error.h"

#include <locale.h>
#include <stdio.h>

static _Thread_local struct {
    char text[2048];
    enum manylight_status status;
} last;

static _Thread_local enum manylight_status blamed;

static _Thread_local struct {
    manylight_log *log;
    void *user;
} listener;

static locale_t c_locale;
static pthread_once_t once = PTHREAD_ONCE_INIT;

static void make_locale(void) {
    c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

static void tell(const struct log_sink *sink, enum log_kind kind, const char *message) {
    static const enum manylight_log_level levels[] = {[LOG_IS_DETAIL] = MANYLIGHT_DETAIL,
                                                      [LOG_IS_NOTE] = MANYLIGHT_NOTE,
                                                      [LOG_IS_WARNING] = MANYLIGHT_WARNING};
    struct door *door = (struct door *)(void *)sink;
    if (!door->log)
        return;
    pthread_mutex_lock(&door->telling);
    door->log(door->user, levels[kind], message);
    pthread_mutex_unlock(&door->telling);
}

void door_enter(struct door *door) {
    pthread_once(&once, make_locale);
    *door = (struct door){.sink.tell = tell,
                          .sink_before = log_get_sink(),
                          .log = listener.log,
                          .user = listener.user,
                          .blamed_before = blamed};
    pthread_mutex_init(&door->telling, NULL);
    blamed = MANYLIGHT_OK;
    log_set_sink(&door->sink);
    door->locale_before = uselocale(c_locale);
    fegetenv(&door->rounding_before);
    fesetenv(FE_DFL_ENV);
}

enum manylight_status door_leave(struct door *door, bool ok, enum manylight_status failure) {
    enum manylight_status status = blamed                                ? blamed
                                   : error_get_kind() == ERROR_OF_MEMORY ? MANYLIGHT_NO_MEMORY
                                                                         : failure;
    if (!ok) {
        snprintf(last.text, sizeof last.text, "%s", error_get());
        last.status = status;
    }
    fesetenv(&door->rounding_before);
    uselocale((locale_t)door->locale_before);
    log_set_sink(door->sink_before);
    blamed = door->blamed_before;
    pthread_mutex_destroy(&door->telling);
    return ok ? MANYLIGHT_OK : status;
}

bool door_blame(enum manylight_status status) {
    if (!blamed)
        blamed = status;
    return false;
}

enum manylight_status door_blamed(void) {
    return blamed;
}

const char *manylight_error(void) {
    return last.text;
}

enum manylight_status manylight_error_status(void) {
    return last.status;
}

void manylight_log_to(manylight_log *log, void *user) {
    listener.log = log;
    listener.user = user;
}
