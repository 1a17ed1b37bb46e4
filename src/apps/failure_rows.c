#include "apps/failure_rows.h"

#include "base/error.h"

#include <stdio.h>
#include <string.h>

/* Every pixel takes every VPL and looks its own visibility up: in a small picture interleaving,
 * blur and blocks would hide all else; blocks of one pixel are a lookup for each VAL, not for each
 * of its VPLs. The frame has them. Edges are at pixel centres, as in the reference. */
#define EVERY_VPL "interleave=1,near-samples=1024,blur-radius=0,samples=1"

const char *const failure_techniques[FAILURE_TECHNIQUES] = {
    "fast:technique=clustered,visibility-block=1," EVERY_VPL,
    "paper:technique=clustered,path=paper,visibility-block=1," EVERY_VPL,
    "instant-radiosity:technique=instant-radiosity," EVERY_VPL,
    "unshadowed:technique=unshadowed," EVERY_VPL,
    "frame:technique=clustered,samples=1",
};

#define OWN(name) "scenes/failures/" name ".glb"
#define ROOM OWN("room")

const struct failure_row failure_rows[] = {
    {"room", "nothing: what the others are held against", ROOM, .bounds = {4, 3, 4, 0, 20}},
    /* Blockers. */
    {"table-legs", "blockers thinner than a texel of a map", OWN("table-legs"),
     .bounds = {4, 5, 4, 0, 21}},
    {"contact", "contact: light under a box", OWN("contact"), .bounds = {5, 5, 5, 0, 25}},
    {"wide-light", "a very large VAL: wide penumbrae, ringing", OWN("wide-light"),
     .settings = "vals=2", .bounds = {8, 18, 4, 0, 12}},
    {"grazing-receivers", "receivers seen edge-on: bent penumbrae", OWN("grazing-receivers"),
     .bounds = {13, 60, 14, 0, 117}},
    {"val-plane", "a blocker through a VAL's plane", OWN("val-plane"), .settings = "vals=4",
     .bounds = {15, 26, 9, 0, 30}},
    {"center-inside", "VAL centres inside geometry", OWN("center-inside"), .settings = "vals=4",
     .bounds = {3, 3, 3, 0, 14}},
    {"thin-wall", "paper-thin, seen from both sides: leaks", OWN("thin-wall"),
     .bounds = {4, 9, 3, 0, 24}},
    {"closed-door", "leaks from one room to another", OWN("closed-door"),
     .bounds = {4, 3, 3, 0, 26}},
    /* Lights. */
    {"grazing-light", "light along a wall: VPLs far apart", OWN("grazing-light"),
     .bounds = {18, 37, 18, 0, 133}},
    {"empty-map", "light that meets nothing", OWN("empty-map"), .bounds = {0.3, 0.3, 0.3, 0, 0.3}},
    {"one-texel", "all VPLs in one place", OWN("needle"), .bounds = {7, 7, 7, 0, 35}},
    {"corner", "VPLs in a corner: the singularity", OWN("corner"), .bounds = {14, 63, 14, 0, 142}},
    /* Counts. */
    {"one-vpl", "N = 1", ROOM, .settings = "vpls=1,interleave=1,near-samples=1024",
     .bounds = {32, 50, 32, 0, 33}},
    {"one-val", "M = 1", ROOM, .settings = "vals=1", .bounds = {9, 10, 4, 0, 21}},
    {"vpl-per-val", "M = N", ROOM, .settings = "vpls=256,vals=256", .bounds = {4, 3, 4, 0, 20}},
    {"more-vals", "M > N", ROOM, .settings = "vpls=64,vals=100", .bounds = {5, 5, 5, 0, 21}},
    /* Surfaces. */
    {"black", "albedo 0", OWN("black"), .bounds = {0.3, 0.3, 0.3, 0, 0.3}},
    {"white", "albedo 1", OWN("white"), .bounds = {4, 3, 3, 0, 17}},
    {"giant-triangle", "lengths over the scene's size: a floor of one kilometre",
     OWN("giant-triangle"), .bounds = {6, 42, 5, 0, 40}},
    {"tiny-triangles", "ten thousand triangles of a few texels", OWN("tiny-triangles"),
     .bounds = {7, 11, 6, 0, 33}},
    /* Scale. */
    {"millimetre", "the room as a millimetre", OWN("millimetre"), .bounds = {4, 3, 4, 0, 20}},
    {"kilometre", "the room as a kilometre", OWN("kilometre"), .bounds = {4, 3, 4, 0, 20}},
    {"far-away", "the room 17 km off the origin", OWN("far-away"), .bounds = {4, 3, 4, 0, 20}},
    /* Pictures. */
    {"inside-wall", "the camera inside a block", ROOM, .camera = "0 eye=0.2,0.5,-0.4",
     .bounds = {4, 2, 4, 0, 1}},
    {"fov-1", "a field of view of 1 degree", ROOM, .camera = "0 eye=0,1.5,120 fov=0.0174533",
     .bounds = {0.9, 1.4, 0.9, 0, 1.3}},
    {"fov-170", "a field of view of 170 degrees", ROOM, .camera = "0 eye=0,1.5,1.5 fov=2.9670597",
     .bounds = {4, 1.1, 3, 0, 17}},
    {"one-pixel", "a picture of 1 x 1", ROOM, .width = 1, .height = 1,
     .bounds = {0.7, 0.7, 0.7, 0, 4}},
    {"strip", "a picture of 16 x 4096", ROOM, .width = 16, .height = 4096,
     .bounds = {3, 1.5, 1.7, 0, 3}},
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
