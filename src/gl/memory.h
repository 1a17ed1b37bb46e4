/* The ledger of GPU memory: what each texture and buffer of the process holds, by label. */
#ifndef GL_MEMORY_H
#define GL_MEMORY_H

#include <stddef.h>
#include <stdio.h>

/* Books bytes (negative: gives back) under a label; from any thread that has a context. */
void gpu_memory_add(const char *label, ptrdiff_t bytes);

/* Bytes of all live textures and buffers, as computed from their formats. */
size_t gpu_memory_total(void);

/* Live textures and buffers. */
int gpu_memory_object_count(void);

/* A line for each of the eight largest labels, one for all others, and the total, in MiB. */
void gpu_memory_print(FILE *out);

#endif
