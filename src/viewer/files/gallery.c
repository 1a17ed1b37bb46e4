#define _DEFAULT_SOURCE
#include "viewer/files/gallery.h"

#include "base/file/file.h"
#include "base/file/folder.h"
#include "base/file/image_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "quality/picture.h"
#include "scene/animation.h"
#include "scene/hash.h"
#include "viewer/scene/develop.h"

#include <dirent.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --- what there is --- */

/* Another file of that name, another picture. NULL: the user has no folder for it. */
static char *picture_path(const char *path) {
    struct file_stamp stamp = file_stamp_of(path);
    char *folder = folder_of_user("XDG_CACHE_HOME", ".cache"), *picture = NULL;
    if (folder && stamp.is_file) {
        uint64_t hash = 0;
        hash_bytes(&hash, path, strlen(path));
        hash_bytes(&hash, &stamp.seconds, sizeof stamp.seconds);
        hash_bytes(&hash, &stamp.size, sizeof stamp.size);
        picture = mem_printf("%s/small-%016llx.png", folder, (unsigned long long)hash);
    }
    free(folder);
    return picture;
}

static void add(struct gallery *gallery, const char *path) {
    char *whole = gallery->count < GALLERY_MAX ? realpath(path, NULL) : NULL;
    if (whole)
        gallery->items[gallery->count++] =
            (struct gallery_item){.path = whole, .picture = picture_path(whole)};
}

static int is_scene(const struct dirent *entry) {
    const char *dot = strrchr(entry->d_name, '.');
    return dot && strcmp(dot, ".glb") == 0;
}

static bool add_folder(struct gallery *gallery, const char *folder) {
    struct dirent **entries;
    int count = scandir(folder, &entries, is_scene, alphasort);
    for (int i = 0; i < count; i++) {
        char *path = mem_printf("%s/%s", folder, entries[i]->d_name);
        add(gallery, path);
        mem_free(path, entries[i]);
    }
    if (count >= 0)
        free(entries);
    return count > 0;
}

/* Of the first folder that has some. */
void gallery_add_own(struct gallery *gallery) {
    bool found = false;
    char *folder;
    for (int n = 0; !found && (folder = folder_of_program(n)); n++) {
        char *scenes = mem_printf("%sscenes", folder);
        found = add_folder(gallery, scenes);
        mem_free(scenes, folder);
    }
}

/* --- making pictures: on the thread --- */

static bool go_on(void *user, const struct path_tracer_progress *progress) {
    struct gallery *gallery = user;
    (void)progress;
    return !atomic_load(&gallery->cancelled);
}

/* As the scene begins; where nothing is seen then, as behind a door that is shut, in the middle of
 * its clip. */
static bool trace(struct gallery *gallery, const char *path, struct image *image) {
    struct stage stage;
    struct path_tracer_desc desc = {
        .width = GALLERY_WIDTH,
        .height = GALLERY_HEIGHT,
        .bounces = 1,
        .samples = 8,
        .denoise = true,
        .threads = 1,
        .progress = go_on,
        .user = gallery,
    };
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    desc.medium = stage.scene.medium;
    bool ok = picture_trace_paths(&stage, &desc, image, NULL);
    double duration = scene_duration(&stage.scene);
    if (ok && duration > 0 && develop_is_black(image)) {
        image_free(image);
        ok = stage_pose(&stage, duration / 2) && picture_trace_paths(&stage, &desc, image, NULL);
    }
    stage_free(&stage);
    return ok;
}

static bool make_picture(struct gallery *gallery, const struct gallery_item *item) {
    struct image image = {0};
    struct bitmap bitmap;
    if (access(item->picture, R_OK) == 0)
        return true;
    if (!folder_make_for(item->picture) || !trace(gallery, item->path, &image))
        return false;
    develop_picture(&image, develop_exposure(&image), &bitmap);
    bool ok = bitmap_write(&bitmap, item->picture);
    bitmap_free(&bitmap);
    image_free(&image);
    return ok;
}

static void *make_all(void *context) {
    struct gallery *gallery = context;
    log_tell_of_thread(false);
    for (int i = 0; i < gallery->count && !atomic_load(&gallery->cancelled); i++) {
        struct gallery_item *item = &gallery->items[i];
        bool ok = item->picture && make_picture(gallery, item);
        atomic_store(&item->ready, ok ? 1 : -1);
        gallery->wake();
    }
    return NULL;
}

void gallery_start(struct gallery *gallery, void (*wake)(void)) {
    gallery->wake = wake;
    gallery->has_thread = pthread_create(&gallery->thread, NULL, make_all, gallery) == 0;
}

/* --- showing them --- */

/* Whether it is of one colour: what a camera sees within a sphere shows nothing. */
static bool is_even(const struct bitmap *bitmap) {
    int least = 255, most = 0;
    for (size_t i = 0; i < 4 * (size_t)bitmap->width * (size_t)bitmap->height; i++) {
        int value = i % 4 < 3 ? bitmap->rgba[i] : bitmap->rgba[0];
        least = value < least ? value : least;
        most = value > most ? value : most;
    }
    return most - least < 24;
}

static bool show(struct gallery_item *item) {
    struct file_bytes bytes;
    struct bitmap bitmap = {0};
    bool ok = file_read(&bytes, item->picture) && bitmap_decode(&bitmap, bytes.data, bytes.size) &&
              !is_even(&bitmap) && texture_init_bitmap(&item->texture, "small picture", &bitmap);
    free(bytes.data);
    bitmap_free(&bitmap);
    return ok;
}

static bool is_new(struct gallery_item *item) {
    return atomic_load(&item->ready) == 1 && !item->has_texture;
}

bool gallery_has_news(struct gallery *gallery) {
    for (int i = 0; i < gallery->count; i++)
        if (is_new(&gallery->items[i]))
            return true;
    return false;
}

void gallery_follow(struct gallery *gallery) {
    for (int i = 0; i < gallery->count; i++) {
        struct gallery_item *item = &gallery->items[i];
        if (!is_new(item))
            continue;
        item->has_texture = show(item);
        if (!item->has_texture)
            atomic_store(&item->ready, -1);
    }
}

void gallery_free(struct gallery *gallery) {
    if (gallery->has_thread) {
        atomic_store(&gallery->cancelled, true);
        pthread_join(gallery->thread, NULL);
    }
    for (int i = 0; i < gallery->count; i++) {
        struct gallery_item *item = &gallery->items[i];
        texture_free(&item->texture);
        mem_free(item->path, item->picture);
    }
    memset(gallery, 0, sizeof *gallery);
}
