#include "viewer/files/loader.h"

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>

void document_free(struct document *document) {
    geometry_free(&document->geometry);
    scene_free(&document->scene);
    *document = (struct document){0};
}

static void *load(void *context) {
    struct loader *loader = context;
    struct document *document = &loader->document;
    bool ok = scene_open(&document->scene, &document->geometry, loader->path, &loader->desc);
    if (!ok)
        snprintf(loader->message, sizeof loader->message, "%s", error_get());
    atomic_store(&loader->state, ok ? LOADER_DONE : LOADER_FAILED);
    return NULL;
}

void loader_start(struct loader *loader, const char *path, const struct scene_open_desc *desc) {
    if (atomic_load(&loader->state) != LOADER_IDLE) {
        free(loader->next);
        loader->next = mem_strdup(path);
        return;
    }
    free(loader->path);
    loader->is_abandoned = false;
    loader->path = mem_strdup(path);
    loader->desc = desc ? *desc : (struct scene_open_desc){0};
    atomic_store(&loader->state, LOADER_BUSY);
    if (pthread_create(&loader->thread, NULL, load, loader) != 0) {
        log_warning("%s: no thread can be started to load it", path);
        atomic_store(&loader->state, LOADER_IDLE);
    }
}

enum loader_state loader_poll(struct loader *loader, struct document *document) {
    enum loader_state state = (enum loader_state)atomic_load(&loader->state);
    if (state != LOADER_DONE && state != LOADER_FAILED)
        return state;
    pthread_join(loader->thread, NULL);
    atomic_store(&loader->state, LOADER_IDLE);
    if (loader->is_abandoned) {
        document_free(&loader->document);
        state = LOADER_IDLE;
    } else if (state == LOADER_DONE)
        *document = loader->document;
    else
        error_set("%s", loader->message);
    loader->document = (struct document){0};
    if (loader->next) {
        char *next = loader->next;
        loader->next = NULL;
        loader_start(loader, next, NULL);
        free(next);
    }
    return state;
}

void loader_abandon(struct loader *loader) {
    loader->is_abandoned = true;
    free(loader->next);
    loader->next = NULL;
}

bool loader_is_busy(struct loader *loader) {
    bool loads = atomic_load(&loader->state) != LOADER_IDLE;
    return loader->next || (loads && !loader->is_abandoned);
}

void loader_free(struct loader *loader) {
    if (atomic_load(&loader->state) != LOADER_IDLE) {
        pthread_join(loader->thread, NULL);
        document_free(&loader->document);
    }
    mem_free(loader->path, loader->next);
}
