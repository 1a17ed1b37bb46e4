/* Frames in the time that they may take: the choice of levels by simulated machines, which is a
 * pure function of frames' times, and what the levels are. */
#include "command_support.h"
#include "render_support.h"

#include "base/option.h"
#include "quality/time_budget.h"

enum { LAST = TIME_BUDGET_LEVELS - 1, SEARCH = 10, FRAMES = 200 };

/* What a frame of a level takes on a machine, ms; in a clip at that frame. */
typedef double machine(int level, int frame);

static double even(int level, int frame) {
    (void)frame;
    return 2 * exp(.06 * level);
}

static double steep(int level, int frame) {
    (void)frame;
    return .2 * exp(.12 * level);
}

static double linear(int level, int frame) {
    (void)frame;
    return 5 + .6 * level;
}

/* A grade among even numbers. */
static double stepped(int level, int frame) {
    return even(level, frame) * (level >= 40 ? 1.35 : 1) * (level >= 30 ? 1.3 : 1);
}

/* Cheap levels cost all alike, dear ones soar. */
static double bent(int level, int frame) {
    (void)frame;
    return 8 + exp(.09 * (level - 20));
}

/* The scene fills up, and empties again. */
static double growing(int level, int frame) {
    return even(level, frame) * (1.5 - .5 * cos(6.283 * frame / FRAMES));
}

/* A second scene, twice as dear. */
static double cut(int level, int frame) {
    return even(level, frame) * (frame < FRAMES / 2 ? 1 : 2);
}

struct run {
    int found;          /* after so many frames none of the search was off by more than a tenth */
    double mean, worst; /* of time over target, and furthest off it, after the search */
    int levels, last;   /* how often the level changed after the search, and the last one */
    double within, longer; /* shares of frames within a tenth, and of those a tenth above */
};

/* Uniform in [0, 1), the same each time. */
static double chance(unsigned *state) {
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static struct run play(machine *takes, double target, double noise, int search, bool print) {
    struct time_budget budget;
    struct run run = {0};
    unsigned state = 1;
    int frames = 0;
    time_budget_init(&budget, target);
    for (int i = 0; i < FRAMES; i++) {
        double other = chance(&state) < .04 && noise > 0 ? 1.8 : 1; /* something else ran */
        double ms = takes(budget.level, i) * (1 + noise * (2 * chance(&state) - 1)) * other;
        double of_target = ms / target;
        if (print && i < search)
            printf(" %d:%.2f", budget.level, of_target);
        if (i < search && fabs(of_target - 1) > .1)
            run.found = i + 1;
        bool changed = time_budget_add(&budget, ms);
        if (i < search)
            continue;
        frames++;
        run.levels += changed;
        run.mean += of_target;
        run.worst = fmax(run.worst, fabs(of_target - 1));
        run.within += fabs(of_target - 1) <= .1;
        run.longer += of_target > 1.1;
    }
    run.last = budget.level;
    run.mean /= frames;
    run.within /= frames;
    run.longer /= frames;
    if (print)
        printf(" -> level %d, mean %.3f, within a tenth %.2f, %d changes\n", run.last, run.mean,
               run.within, run.levels);
    return run;
}

/* Machines that do not err are met within ten frames, and stay. */
TEST(search) {
    static const struct {
        const char *name;
        machine *takes;
    } machines[] = {{"even", even}, {"steep", steep}, {"linear", linear}, {"bent", bent}};
    for (size_t m = 0; m < sizeof machines / sizeof *machines; m++)
        for (int level = 2; level < LAST; level += 9) {
            double target = machines[m].takes(level, 0) * 1.03;
            printf("    %s, %.1f ms:", machines[m].name, target);
            struct run run = play(machines[m].takes, target, 0, SEARCH, true);
            assert_int_equal(run.levels, 0);
            check_at_most("off the target", run.worst, .1);
        }
}

/* What is out of reach takes the last level there is; a gap is stayed below, but for a look now and
 * then. */
TEST(ends) {
    assert_int_equal(play(even, 1, 0, SEARCH, true).last, 0);
    assert_int_equal(play(even, 1e4, 0, SEARCH, true).last, LAST);
    double low = stepped(39, 0), high = stepped(40, 0);
    struct run run = play(stepped, sqrt(low * high), 0, SEARCH, true);
    assert_int_equal(run.last, 39);
    check_at_most("frames above a gap", run.longer, .06);
}

/* Frames' times err, and some are disturbed: the mean holds. */
TEST(noise) {
    for (int level = 8; level < LAST; level += 20) {
        struct run calm = play(even, even(level, 0), .05, SEARCH, true);
        check_near("mean, times within 5 %", calm.mean, 1, .07);
        check_at_most("frames off by more than a tenth", 1 - calm.within, .15);
        struct run rough = play(even, even(level, 0), .15, SEARCH, true);
        check_near("mean, times within 15 %", rough.mean, 1, .1);
    }
}

/* The time goes with the scene, and the level follows. */
TEST(clip) {
    struct run slow = play(growing, 20, .03, SEARCH, true);
    check_at_most("a scene that fills: frames off by more than a tenth", 1 - slow.within, .25);
    struct run sudden = play(cut, 20, 0, SEARCH, true);
    check_at_most("another scene: frames off by more than a tenth", 1 - sudden.within, .08);
}

/* Dearer levels have no fewer VPLs of a pixel, and all go together. */
TEST(levels) {
    double before = 0;
    for (int level = 0; level <= LAST; level++) {
        char *text = time_budget_settings(level);
        const char *given = text;
        struct settings settings;
        renderer_settings_init(&settings);
        check_ok(text, renderer_settings_assign(&settings, technique_default, &given, 1) &&
                           technique_check(technique_default, &settings));
        double side = settings_number(&settings, "interleave");
        double now = settings_number(&settings, "vpls") / (side * side);
        check_at_most("VPLs of a pixel", before, now);
        before = now;
        free(text);
    }
}

static void run_box(int status, const char *arguments, const char *says) {
    expect_command(status, "render scenes/cornell-box.glb -o @/budget-##.png --size 40x40",
                   arguments);
    expect_text(says);
}

/* In a shell. Nobody's frames take a minute at the last level, or nothing at the first. */
TEST(program) {
    run_box(0, "--frames 0..1 --budget 60000ms --stats --set vpls=64,vals=3,adaptive=0,samples=1",
            "chosen by --budget 60000ms: level 40 of 40");
    run_box(0, "--frames 0 --budget .001 --stats --set vals=3",
            "chosen by --budget 0.001ms: level 0 of 40");
    run_box(2, "--frames 0 --budget 16s", "budget: '16s' is not a number from 0 to 1e+06");
    run_box(2, "--frames 0 --budget 16 --quality draft", "--budget excludes --quality");
    run_box(2, "--frames 0 --budget 16 --set vals=3,path=traced", "--budget excludes path=");
}

RUN_TESTS(NULL, NULL)
