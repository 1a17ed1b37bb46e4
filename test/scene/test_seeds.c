/* The files and texts that fuzzing starts from and those in which it has found something: each is
 * taken or refused again, under whatever sanitizer the tests run. */
#define _DEFAULT_SOURCE
#include "support.h"

#include "base/file/file.h"
#include "fuzz/fuzz.h"

#include <dirent.h>

/* Whole, and cut to half. */
static void feed(void (*fuzz)(const uint8_t *, size_t), const char *path) {
    struct file_bytes bytes;
    check_ok(path, file_read(&bytes, path));
    for (size_t parts = 1; parts <= 2; parts++) {
        error_set("no refusal");
        fuzz(bytes.data, bytes.size / parts);
        printf("    1/%zu %-40s %s\n", parts, path, error_get());
    }
    free(bytes.data);
}

static void feed_folder(void (*fuzz)(const uint8_t *, size_t), const char *folder) {
    struct dirent **entries;
    int count = scandir(folder, &entries, NULL, alphasort), fed = 0;
    for (int i = 0; i < count; i++) {
        const char *path = form("%s/%s", folder, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.')
            feed(fuzz, path), fed++;
        free(entries[i]);
    }
    free(entries);
    assert_true(fed > 0);
}

TEST(scenes) {
    feed_folder(fuzz_scene, "test/fuzz/seeds/scene");
}

TEST(pictures) {
    feed_folder(fuzz_picture, "test/fuzz/seeds/picture");
}

TEST(texts) {
    feed_folder(fuzz_text, "test/fuzz/seeds/text");
}

RUN_TESTS(NULL, NULL)
