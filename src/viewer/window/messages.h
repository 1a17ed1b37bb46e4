/* Messages for the user in the window: errors, warnings and notes, from any thread. */
#ifndef VIEWER_MESSAGES_H
#define VIEWER_MESSAGES_H

#include "viewer/window/ui.h"

#include <pthread.h>

enum { MESSAGES_MAX = 24, MESSAGES_SHOWN = 6, MESSAGE_SIZE = 512 };

struct message {
    enum ui_tone tone; /* UI_ERROR, UI_WARNING, UI_NORMAL */
    double time;       /* of window_time */
    double lasts;      /* seconds */
    char text[MESSAGE_SIZE];
};

struct messages {
    pthread_mutex_t lock;
    struct message items[MESSAGES_MAX]; /* oldest first */
    int count;
};

/* Also listens to the log. One at a time. */
void messages_init(struct messages *messages);
void messages_free(struct messages *messages);

void messages_add(struct messages *messages, enum ui_tone tone, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* What was written where, which stays long enough to be read or typed. */
void messages_add_result(struct messages *messages, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Errors go: they were of what the user has left. */
void messages_forget_errors(struct messages *messages);

/* Those that are to be seen: the newest ones of the last seconds (errors stay longer, and results),
 * oldest first; how many. */
int messages_recent(struct messages *messages, struct message recent[MESSAGES_SHOWN]);

#endif
