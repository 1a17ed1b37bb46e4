/* Shows messages in the window: errors, warnings and notes, from any thread. */
#ifndef VIEWER_MESSAGES_H
#define VIEWER_MESSAGES_H

#include "viewer/window/ui.h"

#include <pthread.h>

enum { MESSAGES_MAX = 24, MESSAGES_SHOWN = 6, MESSAGE_SIZE = 512 };

struct message {
    enum ui_tone tone; /* UI_ERROR, UI_WARNING, UI_NORMAL */
    double time;       /* as window_time */
    double lasts;      /* seconds */
    char text[MESSAGE_SIZE];
};

struct messages {
    pthread_mutex_t lock;
    struct message items[MESSAGES_MAX]; /* oldest first */
    int count;
};

/* Prepares the list and listens to the log. Only one list may exist at a time. */
void messages_init(struct messages *messages);
void messages_free(struct messages *messages);

void messages_add(struct messages *messages, enum ui_tone tone, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Adds a message about a written file, which stays long enough to be read or typed. */
void messages_add_result(struct messages *messages, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Removes errors, because the user has left what they were about. */
void messages_forget_errors(struct messages *messages);

/* Copies the messages to show, oldest first: the newest of the last seconds; errors and results
 * stay longer. Returns their number. */
int messages_recent(struct messages *messages, struct message recent[MESSAGES_SHOWN]);

#endif
