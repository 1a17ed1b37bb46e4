/* What tests of the library share: calls that must succeed, and pictures as the program
 * makes them. */
#ifndef TEST_LIBRARY_SUPPORT_H
#define TEST_LIBRARY_SUPPORT_H

#include "command_support.h"

#include "base/image.h"
#include "library/manylight.h"

/* A struct of the library's header, by its name without manylight_ and its members. */
#define PART(type, ...)                                                                            \
    (&(struct manylight_##type){.size = sizeof(struct manylight_##type), __VA_ARGS__})

/* Fails unless the call succeeded; prints the library's error. */
void check_call(const char *what, enum manylight_status status);

/* Fails unless the call failed so, with a message that has the text. */
void check_failed(enum manylight_status status, enum manylight_status wanted, const char *text);

struct manylight_device *open_device(void);
struct manylight_scene *open_scene(const char *path);

/* Small pictures of 48x40 unless desc tells another size. */
struct manylight_renderer *open_drawing(struct manylight_device *device,
                                        struct manylight_scene *scene,
                                        const struct manylight_renderer_desc *desc);

/* A picture of a renderer of its own. */
struct manylight_image *draw_once(struct manylight_device *device, struct manylight_scene *scene,
                                  const struct manylight_renderer_desc *desc,
                                  const struct manylight_view *view);

/* Whether both have the same channels and bits. */
bool same_images(const struct manylight_image *a, const struct manylight_image *b);

/* Fails unless the image, written as a file, has the bits of the file. */
void check_same_as_file(struct manylight_image *image, const char *path);

#endif
