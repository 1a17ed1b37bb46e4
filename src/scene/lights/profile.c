#include "scene/lights/profile.h"

#include "base/error.h"
#include "base/memory.h"

#include <cglm/util.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ANGLES_MAX = 4096 }; /* of one kind */

static const double candela_max = 1e9;

/* --- reading ---------------------------------------------------------------------------------- */

struct reader {
    const char *at, *between; /* characters between numbers */
    int line;
};

static bool take_number(struct reader *reader, const char *what, double *number) {
    char *end;
    for (; *reader->at && strchr(reader->between, *reader->at); reader->at++)
        reader->line += *reader->at == '\n';
    if (!*reader->at)
        return error_set("line %d: the file ends before %s", reader->line, what);
    *number = strtod(reader->at, &end);
    if (end == reader->at || !isfinite(*number) || (*end && !strchr(reader->between, *end)))
        return error_set("line %d: %s: '%.*s' is no number", reader->line, what,
                         (int)strcspn(reader->at, reader->between), reader->at);
    reader->at = end;
    return true;
}

static bool take_bounded(struct reader *reader, const char *what, double least, double most,
                         double *number) {
    return take_number(reader, what, number) &&
           ((*number >= least && *number <= most) ||
            error_set("line %d: %s: %g is not from %g to %g", reader->line, what, *number, least,
                      most));
}

static bool take_count(struct reader *reader, const char *what, int most, int *count) {
    double number = 0;
    if (!take_bounded(reader, what, 1, most, &number))
        return false;
    *count = (int)number;
    return *count == number ||
           error_set("line %d: %s: %g is no whole number", reader->line, what, number);
}

static bool take_angles(struct reader *reader, const char *what, int count, double *angles) {
    for (int i = 0; i < count; i++) {
        if (!take_bounded(reader, what, -180, 360, &angles[i]))
            return false;
        if (i > 0 && angles[i] <= angles[i - 1])
            return error_set("line %d: %s: %g does not increase", reader->line, what, angles[i]);
    }
    return true;
}

/* One plane more has room. */
static void make_room(struct profile *profile, int planes, int angles) {
    profile->plane_count = planes;
    profile->angle_count = angles;
    profile->planes = mem_alloc((size_t)planes + 1, sizeof *profile->planes);
    profile->angles = mem_alloc((size_t)angles, sizeof *profile->angles);
    profile->candela = mem_alloc(((size_t)planes + 1) * (size_t)angles, sizeof *profile->candela);
}

static bool take_candela(struct reader *reader, struct profile *profile, double factor) {
    for (int i = 0; i < profile->plane_count * profile->angle_count; i++) {
        if (!take_bounded(reader, "candela", 0, candela_max, &profile->candela[i]))
            return false;
        profile->candela[i] *= factor;
    }
    return true;
}

/* Lets C-planes of a whole turn end where they began. */
static void close_turn(struct profile *profile) {
    int last = profile->plane_count - 1, n = profile->angle_count;
    if (profile->type != PROFILE_C || profile->planes[0] != 0 || profile->planes[last] <= 180 ||
        profile->planes[last] >= 360)
        return;
    profile->planes[last + 1] = 360;
    memcpy(profile->candela + (last + 1) * n, profile->candela, (size_t)n * sizeof(double));
    profile->plane_count++;
}

/* --- IES LM-63 -------------------------------------------------------------------------------- */

static bool take_tilt(struct reader *reader) {
    bool included = strncmp(reader->at, "INCLUDE", 7) == 0;
    double number;
    int count;
    reader->at += strcspn(reader->at, "\r\n");
    if (!included)
        return true;
    if (!take_number(reader, "TILT: lamp to luminaire geometry", &number) ||
        !take_count(reader, "TILT: number of angles", ANGLES_MAX, &count))
        return false;
    for (int i = 0; i < 2 * count; i++)
        if (!take_number(reader, "TILT", &number))
            return false;
    return true;
}

static bool check_spans(const struct profile *profile) {
    static const double spans[][3] = {
        {PROFILE_C, 0, 90},   {PROFILE_C, 0, 180}, {PROFILE_C, 90, 270},
        {PROFILE_C, -90, 90}, {PROFILE_C, 0, 360}, {PROFILE_A, 0, 90},
        {PROFILE_A, -90, 90}, {PROFILE_B, 0, 90},  {PROFILE_B, -90, 90},
    };
    double first = profile->planes[0], last = profile->planes[profile->plane_count - 1];
    double low = profile->angles[0], high = profile->angles[profile->angle_count - 1];
    bool good = profile->type == PROFILE_C && profile->plane_count == 1;
    for (size_t i = 0; i < sizeof spans / sizeof *spans; i++)
        good |= profile->type == spans[i][0] && first == spans[i][1] && last == spans[i][2];
    if (!good)
        return error_set("horizontal angles from %g to %g degrees have no symmetry of type %c",
                         first, last, "?CBA"[profile->type]);
    bool is_c = profile->type == PROFILE_C;
    return (profile->angle_count > 1 && low >= (is_c ? 0 : -90) && high <= (is_c ? 180 : 90)) ||
           error_set("vertical angles from %g to %g degrees are not of type %c", low, high,
                     "?CBA"[profile->type]);
}

static bool parse_ies(struct profile *profile, struct reader *reader) {
    double number, factor = 1, scale;
    int planes, angles, type;
    static const char *const sizes[] = {"units", "width", "length", "height"};
    if (!take_tilt(reader) || !take_number(reader, "number of lamps", &number) ||
        !take_number(reader, "lumens per lamp", &number) ||
        !take_bounded(reader, "candela multiplier", 1e-9, candela_max, &factor) ||
        !take_count(reader, "number of vertical angles", ANGLES_MAX, &angles) ||
        !take_count(reader, "number of horizontal angles", ANGLES_MAX, &planes) ||
        !take_count(reader, "photometric type", PROFILE_A, &type))
        return false;
    for (int i = 0; i < 4; i++)
        if (!take_number(reader, sizes[i], &number))
            return false;
    for (int i = 0; i < 2; i++) {
        if (!take_bounded(reader, "ballast factor", 1e-9, candela_max, &scale))
            return false;
        factor *= scale;
    }
    profile->type = (enum profile_type)type;
    make_room(profile, planes, angles);
    if (!take_number(reader, "input watts", &number) ||
        !take_angles(reader, "vertical angles", angles, profile->angles) ||
        !take_angles(reader, "horizontal angles", planes, profile->planes) ||
        !take_candela(reader, profile, factor))
        return false;
    close_turn(profile);
    return check_spans(profile);
}

/* --- EULUMDAT --------------------------------------------------------------------------------- */

static bool skip_lines(struct reader *reader, int count) {
    for (; count > 0; count--, reader->line++) {
        const char *end = strchr(reader->at, '\n');
        if (!end)
            return error_set("line %d: the file ends", reader->line);
        reader->at = end + 1;
    }
    return true;
}

/* The number at the start of a line, and the rest of it. */
static bool take_line(struct reader *reader, const char *what, double least, double most,
                      double *number) {
    int line = reader->line;
    return take_bounded(reader, what, least, most, number) &&
           (reader->line == line || error_set("line %d: %s is missing", line, what)) &&
           skip_lines(reader, 1);
}

/* Which of the C-planes have intensities: the first one, and how many. */
static bool planes_of(int symmetry, int all, int *first, int *count) {
    const int parts[] = {1, all, 2, 2, 4};
    *first = symmetry == 3 ? 3 * all / 4 : 0;
    *count = symmetry == 0 ? all : symmetry == 1 ? 1 : all / parts[symmetry] + 1;
    return all % (symmetry == 3 ? 4 : parts[symmetry]) == 0 ||
           error_set("line 4: %d C-planes do not have the symmetry %d", all, symmetry);
}

static bool parse_planes(struct profile *profile, struct reader *reader, const double header[4],
                         double factor) {
    int all = (int)header[1], first, count;
    double planes[ANGLES_MAX];
    if (!planes_of((int)header[0], all, &first, &count))
        return false;
    make_room(profile, count, (int)header[3]);
    profile->type = PROFILE_C;
    if (!take_angles(reader, "C-planes", all, planes) ||
        !take_angles(reader, "gamma angles", profile->angle_count, profile->angles))
        return false;
    for (int i = 0; i < count; i++)
        profile->planes[i] = planes[(first + i) % all] - (first > 0 && first + i < all ? 360 : 0);
    if (!take_candela(reader, profile, factor))
        return false;
    close_turn(profile);
    return check_spans(profile);
}

static bool parse_eulumdat(struct profile *profile, struct reader *reader) {
    double header[4], conversion, sets, flux, spacing;
    bool good = skip_lines(reader, 2) && take_line(reader, "symmetry", 0, 4, &header[0]) &&
                take_line(reader, "number of C-planes", 1, ANGLES_MAX, &header[1]) &&
                take_line(reader, "distance of C-planes", 0, 360, &spacing) &&
                take_line(reader, "number of gamma angles", 2, ANGLES_MAX, &header[3]) &&
                skip_lines(reader, 17) &&
                take_line(reader, "conversion factor", 1e-9, 1e9, &conversion) &&
                skip_lines(reader, 1) && take_line(reader, "number of lamp sets", 1, 20, &sets) &&
                skip_lines(reader, 2) && take_line(reader, "flux of the lamps", 1e-9, 1e9, &flux) &&
                skip_lines(reader, 3 + 6 * ((int)sets - 1) + 10);
    return good && parse_planes(profile, reader, header, conversion * flux / 1000);
}

/* --- the profile ------------------------------------------------------------------------------ */

/* The text after TILT= at the start of a line, or NULL. */
static const char *find_tilt(const char *text, int *line) {
    *line = 1;
    for (const char *at = text; at; (*line)++) {
        at += strspn(at, " \t");
        if (strncmp(at, "TILT=", 5) == 0)
            return at + 5;
        at = strchr(at, '\n');
        at = at ? at + 1 : NULL;
    }
    return NULL;
}

static bool is_black(const struct profile *profile) {
    for (int i = 0; i < profile->plane_count * profile->angle_count; i++)
        if (profile->candela[i] > 0)
            return false;
    return true;
}

bool profile_parse(struct profile *profile, const char *text) {
    struct reader reader = {.at = text, .line = 1};
    const char *tilt = find_tilt(text, &reader.line);
    reader.between = tilt ? " \t\r\n," : " \t\r\n"; /* EULUMDAT may have decimal commas */
    *profile = (struct profile){0};
    if (tilt)
        reader.at = tilt;
    else
        reader.line = 1;
    if ((tilt ? parse_ies(profile, &reader) : parse_eulumdat(profile, &reader)) &&
        (!is_black(profile) || error_set("it has no light")))
        return true;
    profile_free(profile);
    return tilt ? false : error_prefix("EULUMDAT, as there is no line TILT=");
}

void profile_free(struct profile *profile) {
    mem_free(profile->planes, profile->angles, profile->candela);
    *profile = (struct profile){0};
}

/* The interval of the angle, and where in it; false: outside. */
static bool find_angle(const double *angles, int count, double angle, int *i, double *part) {
    if (angle < angles[0] || angle > angles[count - 1])
        return false;
    int low = 0, high = count - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        *(angles[middle] <= angle ? &low : &high) = middle;
    }
    *i = low;
    *part = count > 1 ? (angle - angles[low]) / (angles[low + 1] - angles[low]) : 0;
    return true;
}

/* The angle of the file's that equals a C-plane by its symmetry. */
static double fold(const struct profile *profile, double plane) {
    double first = profile->planes[0], last = profile->planes[profile->plane_count - 1];
    const double alike[] = {plane, -plane, 180 - plane, plane - 180};
    for (int i = 0; i < 4; i++)
        for (int turn = -360; turn <= 360; turn += 360)
            if (alike[i] + turn >= first && alike[i] + turn <= last)
                return alike[i] + turn;
    return first;
}

static double degrees(double y, double x) {
    return 180 / GLM_PI * atan2(y, x);
}

/* Its angles by the file's type. */
static void angles_of(const struct profile *profile, const double d[3], double *plane,
                      double *angle) {
    if (profile->type == PROFILE_C) {
        *plane = profile->plane_count > 1 ? fold(profile, degrees(d[1], d[0])) : profile->planes[0];
        *angle = degrees(hypot(d[0], d[1]), d[2]);
        return;
    }
    bool is_a = profile->type == PROFILE_A;
    *plane = is_a ? degrees(d[0], d[2]) : degrees(d[0], hypot(d[1], d[2]));
    *angle = is_a ? degrees(d[1], hypot(d[0], d[2])) : degrees(d[1], d[2]);
    *plane = profile->planes[0] == 0 ? fabs(*plane) : *plane;
    *angle = profile->angles[0] == 0 ? fabs(*angle) : *angle;
}

double profile_candela(const struct profile *profile, const double direction[3]) {
    double plane, angle, along, across;
    int i, j, n = profile->angle_count;
    angles_of(profile, direction, &plane, &angle);
    if (!find_angle(profile->planes, profile->plane_count, plane, &j, &across) ||
        !find_angle(profile->angles, n, angle, &i, &along))
        return 0;
    const double *near = profile->candela + j * n + i;
    const double *far = profile->plane_count > 1 ? near + n : near;
    return (1 - across) * ((1 - along) * near[0] + along * near[1]) +
           across * ((1 - along) * far[0] + along * far[1]);
}
