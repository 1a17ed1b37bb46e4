#include "apps/failure_rows.h"

#include "base/error.h"

#include <stdio.h>
#include <string.h>

const char *const failure_techniques[FAILURE_TECHNIQUES] = {"fast", "paper", "instant-radiosity",
                                                            "unshadowed"};

#define OWN(name) "scenes/failures/" name ".glb"
#define ROOM OWN("room")

const struct failure_row failure_rows[] = {
    {"room", "nothing: what the others are held against", ROOM, .bounds = {0}},
    /* Blockers. */
    {"table-legs", "blockers thinner than a texel of a map", OWN("table-legs"), .bounds = {0}},
    {"contact", "contact: light under a box", OWN("contact"), .bounds = {0}},
    {"wide-light", "a very large VAL: wide penumbrae, ringing", OWN("wide-light"),
     .settings = "vals=2", .bounds = {0}},
    {"grazing-receivers", "receivers seen edge-on: bent penumbrae", OWN("grazing-receivers"),
     .bounds = {0}},
    {"val-plane", "a blocker through a VAL's plane", OWN("val-plane"), .settings = "vals=4",
     .bounds = {0}},
    {"center-inside", "VAL centres inside geometry", OWN("center-inside"), .settings = "vals=4",
     .bounds = {0}},
    {"thin-wall", "paper-thin, seen from both sides: leaks", OWN("thin-wall"), .bounds = {0}},
    {"closed-door", "leaks from one room to another", OWN("closed-door"), .bounds = {0}},
    /* Lights. */
    {"grazing-light", "light along a wall: VPLs far apart", OWN("grazing-light"), .bounds = {0}},
    {"empty-map", "light that meets nothing", OWN("empty-map"), .bounds = {0}},
    {"one-texel", "all VPLs in one place", OWN("needle"), .bounds = {0}},
    {"corner", "VPLs in a corner: the singularity", OWN("corner"), .bounds = {0}},
    /* Counts. */
    {"one-vpl", "N = 1", ROOM, .settings = "vpls=1,interleave=1", .bounds = {0}},
    {"one-val", "M = 1", ROOM, .settings = "vals=1", .bounds = {0}},
    {"vpl-per-val", "M = N", ROOM, .settings = "vpls=256,vals=256", .bounds = {0}},
    {"more-vals", "M > N", ROOM, .settings = "vpls=64,vals=100", .bounds = {0}},
    /* Surfaces. */
    {"black", "albedo 0", OWN("black"), .bounds = {0}},
    {"white", "albedo 1", OWN("white"), .bounds = {0}},
    {"giant-triangle", "lengths over the scene's size: a floor of one kilometre",
     OWN("giant-triangle"), .bounds = {0}},
    {"tiny-triangles", "ten thousand triangles of a few texels", OWN("tiny-triangles"),
     .bounds = {0}},
    /* Scale. */
    {"millimetre", "the room as a millimetre", OWN("millimetre"), .bounds = {0}},
    {"kilometre", "the room as a kilometre", OWN("kilometre"), .bounds = {0}},
    {"far-away", "the room 17 km off the origin", OWN("far-away"), .bounds = {0}},
    /* Pictures. */
    {"inside-wall", "the camera inside a block", ROOM, .camera = "0 eye=0.2,0.5,-0.4",
     .bounds = {0}},
    {"fov-1", "a field of view of 1 degree", ROOM, .camera = "0 eye=0,1.5,120 fov=0.0174533",
     .bounds = {0}},
    {"fov-170", "a field of view of 170 degrees", ROOM, .camera = "0 eye=0,1.5,1.5 fov=2.9670597",
     .bounds = {0}},
    {"one-pixel", "a picture of 1 x 1", ROOM, .width = 1, .height = 1, .bounds = {0}},
    {"strip", "a picture of 16 x 4096", ROOM, .width = 16, .height = 4096, .bounds = {0}},
};
const int failure_row_count = sizeof failure_rows / sizeof *failure_rows;

const struct failure_row *failure_row_find(const char *name) {
    char names[1024] = "";
    size_t used = 0;
    for (int i = 0; i < failure_row_count; i++) {
        if (strcmp(failure_rows[i].name, name) == 0)
            return &failure_rows[i];
        used += (size_t)snprintf(names + used, sizeof names - used, " %s", failure_rows[i].name);
    }
    error_set("no failure is called '%s' (there is:%s)", name, names);
    return NULL;
}
