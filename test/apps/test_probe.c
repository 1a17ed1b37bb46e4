/* manylight probe: illuminance at points against closed forms of CIE 171:2006 and of furnaces, by
 * the path tracer and by frames; what it refuses. */
#include "command_support.h"
#include "gltf_parts.h"

#include "base/file/file.h"

#include <cglm/util.h>

enum { ROWS_MAX = 32 };

/* The table of the last command. */
static double rows[ROWS_MAX][10];
static int row_count;
static char summary[512];

static void read_table(const char *name) {
    char *text = file_read_text(scratch(name)), *line = text;
    assert_non_null(text);
    row_count = 0;
    for (line = strchr(line, '\n') + 1; *line && *line != '#'; line = strchr(line, '\n') + 1) {
        const char *at = line;
        assert_in_range(row_count, 0, ROWS_MAX - 1);
        for (int c = 0; c < 10; c++) {
            char *end;
            rows[row_count][c] = strtod(at, &end);
            at = end + (*end == ',');
        }
        row_count++;
    }
    snprintf(summary, sizeof summary, "%s", line);
    free(text);
}

/* Writes and measures points. */
static void probe(const char *arguments) {
    expect_command(0, "probe", form("-q -o @/table.csv %s", arguments));
    read_table("table.csv");
}

static double total(int row) {
    return rows[row][8];
}

/* A black floor of 12 m about the origin. */
static int write_floor(void **state) {
    (void)state;
    write_parts(
        "floor.glb",
        &PARTS(.materials =
                   "[{pbrMetallicRoughness: {metallicFactor: 0, baseColorFactor: [0, 0, 0, 1]}}]",
               .nodes = "[{mesh: 0, matrix: [12,0,0,0, 0,0,-12,0, 0,12,0,0, -6,0,6,1]}]"));
    return 0;
}

/* --- closed forms --- */

/* Points by both ways, in lamps that are given as text. */
static void probe_ways(int way, const char *points, const char *lamp, const char *more) {
    char line[512];
    snprintf(line, sizeof line,
             "@/floor.glb @/%s --light '%s direction=0,-1,0 intensity=1000,1000,1000' %s", points,
             lamp, way ? "--by frame --bounces 1" : "--bounces 0 --noise .2%");
    snprintf(line + strlen(line), sizeof line - strlen(line), " %s", more);
    probe(line);
}

/* Case 5.2: I h^2 / d^4 of a small Lambertian lamp. */
TEST(small_lamp) {
    write_text(scratch("floor.csv"), "x,y,z,nx,ny,nz\n0,0,0,0,1,0\n.5,0,0,0,2,0\n1,0,0,0,1,0\r\n"
                                     "\n# a comment\n1.5, 0, 0, 0, 1, 0\n1.5,0,1.5,0,1,0\n");
    for (int way = 0; way < 2; way++) {
        probe_ways(way, "floor.csv", "+area size=.02,.02 position=0,3,0", "");
        assert_int_equal(row_count, 5);
        for (int i = 0; i < row_count; i++) {
            double d2 = 9 + rows[i][0] * rows[i][0] + rows[i][2] * rows[i][2];
            check_near("lx", total(i), 1000 * 9 / (d2 * d2), .1);
        }
    }
}

/* Case 5.3: configuration factors of a lamp of 1 m; 683 lm/W is a factor. */
TEST(wide_lamp) {
    static const double expected[] = {32.68, 75.19, 81.32, 69.06, 53.40,
                                      40.00, 61.42, 79.26, 95.67, 105.78};
    write_text(scratch("room.csv"),
               "2,2.75,-4,0,0,1\n2,2.25,-4,0,0,1\n2,1.75,-4,0,0,1\n2,1.25,-4,0,0,1\n"
               "2,.75,-4,0,0,1\n2,.25,-4,0,0,1\n2,0,-3.75,0,1,0\n2,0,-3.25,0,1,0\n"
               "2,0,-2.75,0,1,0\n2,0,-2.25,0,1,0\n");
    for (int way = 0; way < 2; way++) {
        probe_ways(way, "room.csv", "+area size=1,1 position=2,3,-2", way ? "" : "--efficacy 683");
        for (int i = 0; i < row_count; i++)
            check_near("lx over CIE's", total(i) / expected[i] / (way ? 1 : 683), 1, .005);
    }
}

/* Within a sphere of albedo 1/2 lit from its middle, indirect light is the same from everywhere. */
TEST(sphere) {
    static const char *const ways[] = {"--bounces 8 --spp 256", "--by frame --bounces 1"};
    write_text(scratch("sphere.csv"), ".2,.1,.6,0,0,-1\n-.3,.3,-.2,1,1,1\n0,-.5,.2,.3,-1,0\n");
    for (int way = 0; way < 2; way++) {
        const char *line = form("scenes/sphere.glb @/sphere.csv %s", ways[way]);
        probe(line);
        double indirect = GLM_PI * (way ? .5 : 1 - pow(.5, 8));
        for (int i = 0; i < row_count; i++) {
            check_near("indirect", rows[i][7], indirect, (way ? .03 : .01) * indirect);
            check_near("sum", rows[i][6] + rows[i][7], total(i), 1e-4);
            if (way == 0) /* of a sphere of facets */
                check_at_most("beyond 5 standard errors and .05 %",
                              fabs(rows[i][7] - indirect) - 5e-4 * indirect, 5 * rows[i][9]);
        }
        /* The first looks away from the light. */
        check_near("direct behind", rows[0][6], GLM_PI * .6 / pow(.41, 1.5), 1e-3);
    }
}

/* Under an even sky each point of an open floor has pi times its radiance. */
TEST(even_sky) {
    static const char *const ways[] = {"--bounces 0", "--by frame --bounces 1"};
    for (int way = 0; way < 2; way++) {
        const char *line = form("@/floor.glb --environment cie:5 --light sky --unit W/m2 --grid "
                                "-2,0,2,4,0,0,0,0,-4,3x1 %s",
                                ways[way]);
        probe(line);
        for (int i = 0; i < row_count; i++)
            check_near("W/m2", total(i), GLM_PI, .02 * GLM_PI);
        expect_in(summary, "# W/m2, by ");
    }
}

/* --- forms --- */

/* A grid is its points, and a table can be measured again. */
TEST(grid) {
    probe("scenes/cornell-box.glb --grid -2,5,2,4,0,0,0,0,-4,3x2 --spp 16");
    double first[ROWS_MAX][10], sum = 0, least = INFINITY;
    assert_int_equal(row_count, 6);
    memcpy(first, rows, sizeof rows);
    check_vector("first normal",
                 (const float[]){(float)rows[0][3], (float)rows[0][4], (float)rows[0][5]}, 0, 1, 0,
                 1e-6);
    check_near("x of the second", rows[1][0], 0, 1e-6);
    check_near("z of the fourth", rows[3][2], -1, 1e-6);
    for (int i = 0; i < row_count; i++) {
        sum += total(i);
        least = fmin(least, total(i));
    }
    check_near("uniformity", strtod(strstr(summary, "uniformity ") + 11, NULL), least / (sum / 6),
               1e-3);
    expect(0, "cp @/table.csv @/again.csv");
    probe("scenes/cornell-box.glb @/again.csv --spp 16");
    assert_memory_equal(first, rows, sizeof rows);
    expect(0, "% probe scenes/cornell-box.glb @/again.csv --spp 16 -q | cmp - @/table.csv");
}

/* The map has the table's totals, v up. */
TEST(map) {
    probe("scenes/cornell-box.glb --grid -2,5,2,4,0,0,0,0,-4,3x2 --spp 16 --map @/map.exr");
    OWNED(image) map;
    check_ok("map", image_read(&map, scratch("map.exr")));
    assert_int_equal(map.width, 3);
    assert_int_equal(map.height, 2);
    for (int i = 0; i < row_count; i++)
        check_near("over the table's", (double)*image_at(&map, i % 3, 1 - i / 3) / total(i), 1,
                   1e-5);
    expect_command(0, "probe",
                   "scenes/cornell-box.glb --grid -2,5,2,4,0,0,0,0,-4,3x2 --spp 1 -q -o @/a.csv "
                   "--map @/map.png");
}

/* Noise that cannot be reached ends at the most samples, with a note. */
TEST(most_samples) {
    expect_command(
        0, "probe",
        "@/floor.glb --light '+area size=1,1 position=0,1,0 direction=0,-1,0 intensity=1,1,1' "
        "--grid 0,0,0,1,0,0,0,0,-1,1x1 --bounces 0 --noise 1e-9 -o @/most.csv");
    expect_text("1048576 samples each");
    expect_text("above --noise after the most samples");
}

/* --- refusals --- */

TEST(refusals) {
    static const struct {
        const char *points, *says;
    } files[] = {
        {"", "points.csv: it has no point"},
        {"x,y,z,nx,ny,nz\n", "points.csv: it has no point"},
        {"0,0,0,0,1\n", "points.csv: line 1: 5 columns of 6: x,y,z,nx,ny,nz"},
        {"0,0,0,0,1,0\n0,0,nan,0,1,0\n", "line 2: column 3: 'nan' is no number"},
        {"0,0,0,0,1,0\n\n0,0,0,0,0,0\n", "line 3: the normal has no length"},
        {"a,b,c\n", "line 1: column 1: 'a' is no number"},
        {"0,0,0,0,1,1e999\n", "line 1: column 6: '1e999' is no number"},
        {"0,0,0,0,1,0 lux\n", "line 1: column 6: '0 lux' is no number"},
    };
    static const char *const wrong[][2] = {
        {"scenes/sphere.glb", "it wants POINTS.csv or --grid"},
        {"scenes/sphere.glb p.csv --grid 0,0,0,1,0,0,0,0,1,2x2", "one of both"},
        {"scenes/sphere.glb --grid 0,0,0,1,0,0,0,0,1", "grid: '' is no NUxNV"},
        {"scenes/sphere.glb --grid 0,0,0,1,0,0,0,0,1,0x2", "'0x2' is no NUxNV"},
        {"scenes/sphere.glb --grid 0,0,0,1,0,0,2,0,0,2x2", "span no area"},
        {"scenes/sphere.glb --grid 0,0,x,1,0,0,2,0,0,2x2", "grid: number 3 of"},
        {"scenes/sphere.glb p.csv --spp 4 --noise 1%", "exclude each other"},
        {"scenes/sphere.glb p.csv --by frame --spp 4", "--spp is for --by reference"},
        {"scenes/sphere.glb p.csv --technique clustered", "--technique is for --by frame"},
        {"scenes/sphere.glb p.csv --unit W/m2 --efficacy 683", "--efficacy is for --unit lux"},
        {"scenes/sphere.glb p.csv --map p.png", "--map is for --grid"},
        {"scenes/sphere.glb p.csv --by frame --bounces 0", "is for --by reference"},
        {NULL},
    };
    static const char *const failures[][2] = {
        {"scenes/sphere.glb --grid 0,0,0,1,0,0,0,0,-1,2x2 --map p.txt", "p.txt"},
        {"scenes/sphere.glb no-such.csv", "no-such.csv"},
        {"scenes/gem.glb --by frame --set caustics.surface=patches --grid 0,0,0,1,0,0,0,0,1,2x2",
         "sensors do not measure caustics"},
        {NULL},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        write_text(scratch("points.csv"), files[i].points);
        expect_command(1, "probe", "scenes/sphere.glb @/points.csv -o @/none.csv");
        expect_text(files[i].says);
    }
    expect_refusals(2, "probe -o @/none.csv", wrong);
    expect_refusals(1, "probe -o @/none.csv", failures);
    expect(0, "test ! -e @/none.csv");
    expect_command(1, "probe", "scenes/sphere.glb @/floor.csv -o @/floor.csv --spp 1");
}

RUN_TESTS(write_floor, NULL)
