/* Writes files whole or not at all; the only way to write a file.
 *
 * The content is made in memory. Its bytes go to a file without a name, are synced and read back,
 * and only then take the name of the target. If anything fails or the process is killed, the target
 * is either the old or the new file. A kill during the replacement may leave .manylight-PID-N.part
 * beside it. File systems without unnamed files get such a named file from the start.
 *
 * The path "-" is standard output, which receives the bytes directly. A reader that closes early is
 * an error; it has received a part. */
#ifndef BASE_FILE_OUTPUT_FILE_H
#define BASE_FILE_OUTPUT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* True if the path is "-". */
bool output_file_is_stdout(const char *path);

/* Checks that the file can be written and is none of the inputs, which would be lost (NULL: no
 * file). Call it before long work. Error: names path and reason: a folder, a missing or read-only
 * folder, a name too long, an input, or a terminal for "-". */
bool output_file_check(const char *path, const char *const *inputs, int count);

/* Checks that path and input are two files. Error: they are the same. */
bool output_file_is_not(const char *path, const char *input);

/* Replaces the file. A device or a pipe is written directly. Error: names the path. */
bool output_file_write(const char *path, const void *bytes, size_t size);

/* Writes all bytes to an open file. False: errno has the reason. */
bool output_file_put(int file, const void *bytes, size_t size);

/* A file that another program fills through its descriptor. It is unnamed if the file system can.
 * Zeroed: none. */
struct output_part {
    int file; /* descriptor to read and write */
    char *name, *path;
};

/* Opens the part file. Error: names path and reason; also if the target is no regular file. */
bool output_part_begin(struct output_part *part, const char *path);

/* Gives the file its path as output_file_write does, or removes it if ok is false. */
bool output_part_end(struct output_part *part, bool ok);

/* Flushes stdout. output_file_close_stdout reports the first failure. */
void output_file_flush_stdout(void);

/* Closes stdout. Error: output was lost. */
bool output_file_close_stdout(void);

/* Text printed to a stream in memory before it goes to a file. */
struct output_text {
    FILE *stream;
    char *data;
    size_t size;
};

void output_text_init(struct output_text *text);
/* Writes the text and frees it in any case. */
bool output_text_end(struct output_text *text, const char *path);

/* Makes a folder that appears whole: begin returns a temporary folder beside the path, for the
 * files. end moves it to the path, or removes it with its files if ok is false, and frees the name.
 * Error, and NULL: the path exists, or no folder can be made. */
char *output_folder_begin(const char *path);
bool output_folder_end(char *folder, const char *path, bool ok);

#endif
