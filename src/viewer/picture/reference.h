/* Shows a picture from a file as the renderer shows its own. */
#ifndef VIEWER_REFERENCE_H
#define VIEWER_REFERENCE_H

#include "base/image.h"
#include "gl/buffer.h"
#include "gl/texture.h"
#include "renderer/settings.h"

struct reference {
    struct image picture; /* all channels; without pixels: nothing is loaded */
    struct image layer;   /* the shown layer: linear R G B */
    char layer_name[16];
    GLuint program, framebuffer;
    struct texture radiance, display;
    struct buffer params;
};

/* Reads a file in place of the picture before. Error: of the file, or no GPU memory; the picture
 * before stays. */
bool reference_load(struct reference *reference, const char *path);

/* Takes ownership of a picture, in place of the one before. Error: no GPU memory. */
bool reference_take(struct reference *reference, struct image *picture);

/* Frees everything. Accepts a zeroed reference. */
void reference_free(struct reference *reference);

/* Draws a layer to reference->display: "", "direct" or "indirect"; the first layer if the file
 * lacks it. */
bool reference_show(struct reference *reference, const char *layer,
                    const struct settings *settings);

#endif
