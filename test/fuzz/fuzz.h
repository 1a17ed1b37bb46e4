/* What reads files and texts of strangers, fed with any bytes: each must take them or refuse them
 * with a message, and never crash, hang or leak. The last also hold what is told beside them, and
 * abort where it does not hold.
 *
 * `make fuzz` makes up bytes (driver.c); test/scene/test_seeds.c runs those that are kept, below
 * seeds/. */
#ifndef TEST_FUZZ_FUZZ_H
#define TEST_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

/* A .gltf or .glb file, opened as the renderer does. */
void fuzz_scene(const uint8_t *bytes, size_t size);

/* A picture file: the first byte picks its format, or a texture that a scene holds. */
void fuzz_picture(const uint8_t *bytes, size_t size);

/* The first byte picks settings, a session, a camera, lights or a command line. Settings and lights
 * that were taken are the same after they are told and read again. */
void fuzz_text(const uint8_t *bytes, size_t size);

/* A file of these bytes, in memory: its path, until the next one. */
const char *fuzz_file(const void *bytes, size_t size);

#endif
