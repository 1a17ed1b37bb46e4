/* Sequences that are interrupted, killed, or rendered by two processes at once: every file that has
 * its name is whole, nothing else is left, and what comes after equals one run. */
#define _GNU_SOURCE
#include "command_support.h"

#include "base/clock.h"
#include "base/file/file.h"
#include "base/file/output_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { FRAMES = 12 };

static void make_folder(const char *folder) {
    const char *command = form("rm -rf '%s' && mkdir '%s'", folder, folder);
    assert_int_equal(run_command(command, output, sizeof output), 0);
}

static void wait_ms(long ms) {
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000}, NULL);
}

/* --- the program ------------------------------------------------------------------------------ */

/* Starts a sequence into the folder; its messages go to FOLDER.log. */
static pid_t start(const char *folder, const char *more) {
    char *command =
        form("exec %s render scenes/metaballs.glb --size 64x48 --set vpls=64 --set map-size=32 "
             "--set rsm-size=64 --set shadow-size=128 --frames 0..%d -o %s/f.##.png %s "
             "</dev/null >>%s.log 2>&1",
             binary_path(), FRAMES - 1, folder, more, folder);
    char *arguments[] = {"sh", "-c", command, NULL};
    pid_t process;
    fflush(NULL);
    assert_int_equal(posix_spawn(&process, "/bin/sh", NULL, NULL, arguments, environ), 0);
    return process;
}

/* As a shell has it. */
static int end_of(pid_t process) {
    int status;
    assert_int_equal(waitpid(process, &status, 0), process);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static char *frame_path(const char *folder, int frame) {
    return mem_printf("%s/f.%02d.png", folder, frame);
}

/* Until the frame is there, or the process has ended: then false. */
static bool wait_for(pid_t process, const char *folder, int frame) {
    char *path = frame_path(folder, frame);
    bool there = false, ended = false;
    for (siginfo_t info = {0}; !there && !ended; wait_ms(5)) {
        there = access(path, F_OK) == 0;
        waitid(P_PID, (id_t)process, &info, WEXITED | WNOHANG | WNOWAIT);
        ended = info.si_pid == process;
    }
    free(path);
    return there;
}

/* All that is there is whole and a frame. */
static int count_whole(const char *folder) {
    DIR *directory = opendir(folder);
    assert_non_null(directory);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(directory));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        char *path = mem_printf("%s/%s", folder, entry->d_name);
        check_ok(path, image_is_whole(path));
        free(path);
        count++;
    }
    closedir(directory);
    return count;
}

static void check_same(const char *folder, const char *expected) {
    for (int frame = 0; frame < FRAMES; frame++) {
        char *paths[] = {frame_path(folder, frame), frame_path(expected, frame)};
        struct file_bytes bytes[2];
        for (int i = 0; i < 2; i++)
            check_ok(paths[i], file_read(&bytes[i], paths[i]));
        if (bytes[0].size != bytes[1].size ||
            memcmp(bytes[0].data, bytes[1].data, bytes[0].size) != 0)
            fail_msg("%s is not %s", paths[0], paths[1]);
        for (int i = 0; i < 2; i++) {
            mem_free(bytes[i].data, paths[i]);
        }
    }
}

static char whole[512]; /* the folder of one run, of no accident */

/* False where there is no OpenGL. */
static bool make_whole(void) {
    if (!*whole) {
        snprintf(whole, sizeof whole, "%s", scratch("kill-whole"));
        make_folder(whole);
        end_of(start(whole, ""));
    }
    return count_whole(whole) == FRAMES;
}

static void check_message(const char *folder, const char *text) {
    char *path = mem_printf("%s.log", folder), *log = file_read_text(path);
    assert_non_null(log);
    printf("    %s", log);
    assert_non_null(strstr(log, text));
    free(log);
    remove(path);
    free(path);
}

TEST(interrupts) {
    static const int signals[] = {SIGINT, SIGTERM};
    const char *folder = scratch("interrupted");
    if (!make_whole())
        skip();
    for (int i = 0; i < 2; i++) {
        make_folder(folder);
        /* Many more frames than are waited for: the signal is to come before their end, however
         * slow this process is to send it. */
        pid_t process = start(folder, "--frames 0..99");
        assert_true(wait_for(process, folder, 1));
        kill(process, signals[i]);
        assert_int_equal(end_of(process), 128 + signals[i]);
        int count = count_whole(folder);
        printf("    %s after %d frames\n", strsignal(signals[i]), count);
        assert_true(count >= 2 && count <= 99);
        check_message(folder, "manylight render: stopped ");
        assert_int_equal(end_of(start(folder, "--skip-existing")), 0);
        check_same(folder, whole);
        check_message(folder, " were there");
    }
}

/* A frame of minutes is not awaited: nothing of it is written. */
TEST(long_frame) {
    const char *folder = scratch("long");
    if (!make_whole())
        skip();
    make_folder(folder);
    pid_t process = start(folder, "--technique instant-radiosity --size 400x400 --set vpls=65536");
    wait_ms(1500);
    kill(process, SIGINT);
    double sent = clock_ms();
    assert_int_equal(end_of(process), 128 + SIGINT);
    printf("    ended after %.1f s\n", (clock_ms() - sent) / 1e3);
    assert_int_equal(count_whole(folder), 0);
    check_message(folder, "manylight render: stopped ");
}

/* The caller ignores the signal, as nohup does: so does the program. */
TEST(ignored) {
    const char *folder = scratch("ignored");
    if (!make_whole())
        skip();
    make_folder(folder);
    signal(SIGINT, SIG_IGN);
    pid_t process = start(folder, "");
    signal(SIGINT, SIG_DFL);
    assert_true(wait_for(process, folder, 0));
    kill(process, SIGINT);
    assert_int_equal(end_of(process), 0);
    check_same(folder, whole);
}

/* Killed at any time, taken up again and again until all is there. */
TEST(kills) {
    const char *folder = scratch("killed");
    int kills = 0, count = 0;
    if (!make_whole())
        skip();
    make_folder(folder);
    while (count < FRAMES) {
        pid_t process = start(folder, "--skip-existing");
        if (!wait_for(process, folder, count))
            break;
        wait_ms(kills * 7 % 30);
        kill(process, SIGKILL);
        kills += end_of(process) == 128 + SIGKILL;
        count = count_whole(folder);
    }
    printf("    killed %d times\n", kills);
    assert_true(kills >= 3);
    check_same(folder, whole);
}

TEST(two_processes) {
    const char *folder = scratch("shared");
    if (!make_whole())
        skip();
    make_folder(folder);
    pid_t processes[] = {start(folder, ""), start(folder, ""), start(folder, "--skip-existing")};
    for (int i = 0; i < 3; i++)
        assert_int_equal(end_of(processes[i]), 0);
    assert_int_equal(count_whole(folder), FRAMES);
    check_same(folder, whole);
}

/* --- the writer ------------------------------------------------------------------------------- */

enum { SIZE = 1 << 20, WRITERS = 3 };

/* Writes the file over and over, each time full of another letter. */
static void write_on(const char *path) {
    char *bytes = mem_alloc(SIZE, 1);
    for (int i = getpid();; i++) {
        memset(bytes, 'a' + i % 26, SIZE);
        if (!output_file_write(path, bytes, SIZE))
            _exit(1);
    }
}

static void check_one_letter(const char *path) {
    struct file_bytes bytes;
    check_ok("read", file_read(&bytes, path));
    assert_int_equal(bytes.size, SIZE);
    for (int i = 0; i < SIZE; i++)
        if (bytes.data[i] != bytes.data[0])
            fail_msg("%s has '%c' and '%c'", path, bytes.data[0], bytes.data[i]);
    free(bytes.data);
}

/* Three writers of one file, killed in the midst: it is of one of them, and whole. */
TEST(killed_writers) {
    const char *folder = scratch("writers");
    int rounds = 60;
    make_folder(folder);
    const char *path = form("%s/letters", folder);
    void *first = memset(mem_alloc(SIZE, 1), 'z', SIZE);
    check_ok("first", output_file_write(path, first, SIZE));
    free(first);
    for (int round = 0; round < rounds; round++) {
        pid_t writers[WRITERS];
        fflush(NULL);
        for (int i = 0; i < WRITERS; i++)
            if ((writers[i] = fork()) == 0)
                write_on(path);
        wait_ms(10 + round * 7 % 40);
        check_one_letter(path);
        for (int i = 0; i < WRITERS; i++)
            kill(writers[i], SIGKILL);
        for (int i = 0; i < WRITERS; i++)
            assert_int_equal(end_of(writers[i]), 128 + SIGKILL);
        check_one_letter(path);
    }
    printf("    %d writers killed\n", rounds * WRITERS);
}

int main(void) {
    /* A shell that runs this in the background has them ignored, and so would all that
     * starts here. */
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    return run_file(__FILE__, NULL, NULL);
}
