/* Files that are written whole or not at all: the only way to write one.
 *
 * The content is made in memory. Its bytes go into a file without a name (or with a name of its own
 * beside the target, where the file system knows no other), are synced and read back, and only then
 * take the target's name. Whatever fails, and whenever the process is killed, the target is what it
 * was or what it should be; a kill in the midst of replacing it may leave the other one beside it, as
 * .manylight-PID-N.part.
 *
 * The path "-" is standard output, which gets the bytes as they are: a reader that ends before all are written
 * is an error, and has a part of them.
 */
#ifndef BASE_FILE_OUTPUT_FILE_H
#define BASE_FILE_OUTPUT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Whether the path is "-". */
bool output_file_is_stdout(const char *path);

/* Whether a file can be written there, and is none of the inputs (NULL is no file), which would be
 * lost; call it before long work. Error: names the path and the reason: a folder, a folder that is
 * missing or read-only, a name too long, an input; a terminal, of "-". */
bool output_file_check(const char *path, const char *const *inputs, int count);

/* An error where the two are one file. */
bool output_file_is_not(const char *path, const char *input);

/* Replaces what is there. A device or a pipe is written to as it is. Error: names the path. */
bool output_file_write(const char *path, const void *bytes, size_t size);

/* Writes all bytes to a file that is open. False: errno tells why. */
bool output_file_put(int file, const void *bytes, size_t size);

/* A file that another program fills, which gets its descriptor. It has no name where the file system knows such files.
 * Zeroed: none. */
struct output_part {
    int file; /* to be read and written */
    char *name, *path;
};

/* Error: names the path and the reason; it is no regular file. */
bool output_part_begin(struct output_part *part, const char *path);

/* The file takes the path, as output_file_write has it, or goes where ok is false. */
bool output_part_end(struct output_part *part, bool ok);

/* Shows what was printed to stdout so far. Where it cannot be, output_file_close_stdout tells why. */
void output_file_flush_stdout(void);

/* Error: something that was printed to stdout is lost. */
bool output_file_close_stdout(void);

/* Text that is printed to a stream in memory, on its way to a file. free accepts a zeroed one. */
struct output_text {
    FILE *stream;
    char *data;
    size_t size;
};

void output_text_init(struct output_text *text);
void output_text_free(struct output_text *text);

/* Writes all that was printed so far: may be called again when there is more. */
bool output_text_write(struct output_text *text, const char *path);

/* Writes it and frees the text, whatever happens. */
bool output_text_end(struct output_text *text, const char *path);

/* A new folder whose files are written beside its place, and which comes there whole: output_folder_begin returns the
 * folder to write to, to be given to output_folder_end, which frees it, and removes it with its files where ok is false.
 * NULL, and an error: the path exists, or no folder can be made there. */
char *output_folder_begin(const char *path);
bool output_folder_end(char *folder, const char *path, bool ok);

#endif
