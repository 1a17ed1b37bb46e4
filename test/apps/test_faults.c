/* Each call of the program's own that can fail is made to fail once (test/faults): memory, files,
 * threads, objects and programs of OpenGL. It must go on to the very same files, or end with 1, one
 * message and no half file. Prints how many of each kind were tried.
 *
 * All that can fail is tried with MANYLIGHT_FAULTS=0/1, or in parts: 0/12, 1/12 ... 11/12, each of
 * some minutes; else every file and thread, and some of the rest, which all end alike. */
#define _GNU_SOURCE
#include "support.h"

#include "base/file/file.h"

#ifdef __SANITIZE_ADDRESS__
enum { HAS_OWN_MALLOC = 1 };
#else
enum { HAS_OWN_MALLOC = 0 };
#endif

enum { OUTPUTS_MAX = 2, KINDS_MAX = 64 };

/* In both @ is the folder that is written to. */
struct victim {
    const char *command;
    const char *outputs[OUTPUTS_MAX];
};

static const struct victim render = {
    "render scenes/cornell-box.glb --size 32x24 --set vpls=64 --set map-size=32 --set vals=4 "
    "--set rsm-size=64 --set shadow-size=128 -o @/a.exr -o @/a.png",
    {"@/a.exr", "@/a.png"}};
static const struct victim reference = {
    "reference scenes/cornell-box.glb --size 16x12 --spp 4 -o @/a.exr", {"@/a.exr"}};
static const struct victim compare = {"compare @/../small.png @/../small.png -o @/a.png",
                                      {"@/a.png"}};
static const struct victim bench = {
    "bench times scenes/cornell-box.glb --size 32x24 --frames 1 --set vpls=64 --set map-size=32 "
    "--set vals=4 --csv @/a.csv",
    {"@/a.csv"}};

struct kind {
    char name[40];
    int seen, tried, went_on;
};

/* One program that is broken again and again. */
struct trial {
    const struct victim *victim;
    char folder[300], log[300];
    struct file_bytes whole[OUTPUTS_MAX];
    struct kind kinds[KINDS_MAX];
    int kind_count;
};

static char said[1 << 14];

static void put_folder(char *to, size_t size, const char *text, const char *folder) {
    size_t used = 0;
    for (; *text && used + 1 < size; text++)
        if (*text == '@')
            used += (size_t)snprintf(to + used, size - used, "%s", folder);
        else
            to[used++] = *text;
    to[used < size ? used : size - 1] = '\0';
}

/* The n-th call fails; 0: none does. */
static int run(const struct trial *trial, int n) {
    char command[4096], arguments[1200];
    put_folder(arguments, sizeof arguments, trial->victim->command, trial->folder);
    snprintf(command, sizeof command,
             "rm -rf %s %s; mkdir %s; ulimit -t 60; FAULT=%d FAULT_LOG=%s "
             "LD_PRELOAD=%s/test/faults.so exec %s %s",
             trial->folder, trial->log, trial->folder, n, trial->log, getenv("MANYLIGHT_BUILD"),
             binary_path(), arguments);
    return run_command(command, said, sizeof said);
}

static struct kind *kind_named(struct trial *trial, const char *name) {
    for (int i = 0; i < trial->kind_count; i++)
        if (strcmp(trial->kinds[i].name, name) == 0)
            return &trial->kinds[i];
    assert_true(trial->kind_count < KINDS_MAX);
    struct kind *kind = &trial->kinds[trial->kind_count++];
    snprintf(kind->name, sizeof kind->name, "%s", name);
    return kind;
}

/* Those that all end in the same few lines of code are tried now and then, and bench's, which are
 * much the same as render's. */
static bool is_tried(const struct victim *victim, struct kind *kind) {
    bool memory = strstr(kind->name, "alloc") || strstr(kind->name, "new");
    bool graphics = strncmp(kind->name, "gl", 2) == 0;
    int step = (memory ? 80 : graphics ? 8 : 1) * (victim == &bench ? 4 : 1), part = 0;
    const char *parts = getenv("MANYLIGHT_FAULTS");
    if (parts && sscanf(parts, "%d/%d", &part, &step) != 2)
        fail_msg("MANYLIGHT_FAULTS=%s is no part like 0/12", parts);
    return kind->seen++ % step == part;
}

/* Whole, or, where it may be, missing. */
static bool output_is_good(const struct trial *trial, int i, bool may_be_missing) {
    char path[400];
    struct file_bytes bytes;
    put_folder(path, sizeof path, trial->victim->outputs[i], trial->folder);
    if (!file_read(&bytes, path))
        return may_be_missing;
    bool same = bytes.size == trial->whole[i].size &&
                memcmp(bytes.data, trial->whole[i].data, bytes.size) == 0;
    free(bytes.data);
    return same;
}

static int output_count(const struct victim *victim) {
    int count = 0;
    while (count < OUTPUTS_MAX && victim->outputs[count])
        count++;
    return count;
}

/* bench's files tell times, which differ. */
static bool files_are_good(const struct trial *trial, bool failed) {
    int count = output_count(trial->victim);
    bool good = count_files(trial->folder) <= count;
    for (int i = 0; good && trial->victim != &bench && i < count; i++)
        good = output_is_good(trial, i, failed);
    return good;
}

/* What bench calls depends on the times that it takes, now and then: a place may not come. */
static void break_call(struct trial *trial, int n, struct kind *kind) {
    struct file_bytes log;
    int status = run(trial, n);
    bool failed = status == 1, fired = file_read(&log, trial->log);
    free(log.data);
    kind->tried += fired;
    kind->went_on += fired && status == 0;
    if ((!fired && trial->victim != &bench) || status < 0 || status > 1 ||
        !files_are_good(trial, failed) || (failed && !strstr(said, "manylight")))
        fail_msg("%s, %s at %d: status %d, %s, files %s: %s", trial->victim->command, kind->name, n,
                 status, fired ? "failed" : "never called",
                 files_are_good(trial, failed) ? "good" : "bad", said);
}

static void keep_whole(struct trial *trial) {
    for (int i = 0; i < output_count(trial->victim); i++) {
        char path[400];
        put_folder(path, sizeof path, trial->victim->outputs[i], trial->folder);
        check_ok(path, file_read(&trial->whole[i], path));
    }
}

static void print_kinds(const struct trial *trial) {
    for (const struct kind *kind = trial->kinds; kind < trial->kinds + trial->kind_count; kind++)
        printf("    %-32s %3d calls, %3d made to fail, %3d went on\n", kind->name, kind->seen,
               kind->tried, kind->went_on);
}

static void break_all(const struct victim *victim) {
    const char *faults = form("%s/test/faults.so", getenv("MANYLIGHT_BUILD"));
    need_file(faults);
    if (HAS_OWN_MALLOC)
        skip();
    struct trial trial = {.victim = victim};
    snprintf(trial.folder, sizeof trial.folder, "%s", scratch("faults"));
    snprintf(trial.log, sizeof trial.log, "%s", scratch("faults.log"));
    if (run(&trial, 0) != 0)
        fail_msg("%s", said);
    keep_whole(&trial);
    char *calls = file_read_text(trial.log), *rest = NULL;
    assert_non_null(calls);
    for (char *line = strtok_r(calls, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        struct kind *kind = kind_named(&trial, strchr(line, ' ') + 1);
        if (is_tried(victim, kind))
            break_call(&trial, atoi(line), kind);
    }
    print_kinds(&trial);
    free(calls);
    for (int i = 0; i < OUTPUTS_MAX; i++)
        free(trial.whole[i].data);
}

TEST(render) {
    break_all(&render);
}

TEST(reference) {
    break_all(&reference);
}

TEST(compare) {
    enum { SIDE = 32 };
    unsigned char rgba[SIDE * SIDE * 4];
    for (int i = 0; i < SIDE * SIDE * 4; i++)
        rgba[i] = (unsigned char)(i * 7);
    check_ok("small.png", bitmap_write(&(struct bitmap){SIDE, SIDE, rgba}, scratch("small.png")));
    break_all(&compare);
}

TEST(bench) {
    break_all(&bench);
}

RUN_TESTS(NULL, NULL)
