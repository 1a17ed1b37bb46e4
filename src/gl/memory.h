/* Counts the GPU memory of all textures and buffers of the process, by label. */
#ifndef GL_MEMORY_H
#define GL_MEMORY_H

#include <stddef.h>
#include <stdio.h>

/* Adds bytes to a label; a negative number subtracts. Call it from any thread with a context. */
void gpu_memory_add(const char *label, ptrdiff_t bytes);

/* Returns the bytes of all live textures and buffers, computed from their formats. */
size_t gpu_memory_total(void);

/* Returns the number of live textures and buffers. */
int gpu_memory_object_count(void);

/* Prints in MiB the eight largest labels, the sum of the others, and the total, a line each. */
void gpu_memory_print(FILE *out);

#endif
