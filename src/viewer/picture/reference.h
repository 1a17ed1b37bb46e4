/* A picture from a file, shown as the renderer shows its own. */
#ifndef VIEWER_REFERENCE_H
#define VIEWER_REFERENCE_H

#include "base/image.h"
#include "gl/buffer.h"
#include "gl/texture.h"
#include "renderer/settings.h"

struct reference {
    struct image picture; /* all its channels; no pixels: nothing is loaded */
    struct image layer;   /* the one that is shown: linear R G B */
    char layer_name[16];
    GLuint program, framebuffer;
    struct texture radiance, display;
    struct buffer params;
};

/* Reads a file in place of the one before. Error: the file, or GPU memory; the one before stays. */
bool reference_load(struct reference *reference, const char *path);

/* Takes a picture, which is then the reference's, in place of the one before. Error: GPU memory. */
bool reference_take(struct reference *reference, struct image *picture);

/* Accepts zeroed ones. */
void reference_free(struct reference *reference);

/* Shows a layer ("", "direct", "indirect"; the first where the file has no other) into
 * reference->display. */
bool reference_show(struct reference *reference, const char *layer,
                    const struct settings *settings);

#endif
