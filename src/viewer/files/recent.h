/* The files that were opened last, kept between starts. */
#ifndef VIEWER_RECENT_H
#define VIEWER_RECENT_H

enum { RECENT_MAX = 8 };

struct recent {
    char *paths[RECENT_MAX]; /* the newest first */
    int count;
};

/* Reads the list; those that are gone are left out. There may be none. */
void recent_read(struct recent *recent);

/* Puts a file first, and keeps the list. What cannot be kept is nobody's harm. */
void recent_add(struct recent *recent, const char *path);

/* Accepts zeroed ones. */
void recent_free(struct recent *recent);

#endif
