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
    {"room", "nothing: what the others are held against", ROOM, .bounds = {3.7, 2.5, 3, 0, 19}},
    /* Blockers. */
    {"table-legs", "blockers thinner than a texel of a map", OWN("table-legs"),
     .bounds = {3.6, 4.4, 3.5, 0, 19}},
    {"contact", "contact: light under a box", OWN("contact"), .bounds = {4.6, 4.7, 4.3, 0, 22}},
    {"wide-light", "a very large VAL: wide penumbrae, ringing", OWN("wide-light"),
     .settings = "vals=2", .bounds = {6.8, 18, 2.8, 0, 13}},
    {"grazing-receivers", "receivers seen edge-on: bent penumbrae", OWN("grazing-receivers"),
     .bounds = {7.2, 59, 8.4, 0, 129}},
    {"val-plane", "a blocker through a VAL's plane", OWN("val-plane"), .settings = "vals=4",
     .bounds = {12, 25, 5.8, 0, 26}},
    {"center-inside", "VAL centres inside geometry", OWN("center-inside"), .settings = "vals=4",
     .bounds = {2.2, 1.8, 2, 0, 14}},
    {"thin-wall", "paper-thin, seen from both sides: leaks", OWN("thin-wall"),
     .bounds = {3.2, 7.8, 2.4, 0, 24}},
    {"closed-door", "leaks from one room to another", OWN("closed-door"),
     .bounds = {2.9, 2, 2.3, 0, 26}},
    /* Lights. */
    {"grazing-light", "light along a wall: VPLs far apart", OWN("grazing-light"),
     .bounds = {6.9, 36, 6.8, 0, 127}},
    {"empty-map", "light that meets nothing", OWN("empty-map"), .bounds = {0.3, 0.3, 0.3, 0, 0.3}},
    {"one-texel", "all VPLs in one place", OWN("needle"), .bounds = {6.2, 6.1, 6.4, 0, 35}},
    {"corner", "VPLs in a corner: the singularity", OWN("corner"),
     .bounds = {5.8, 63, 5.7, 0, 136}},
    /* Counts. */
    {"one-vpl", "N = 1", ROOM, .settings = "vpls=1,interleave=1,near-samples=1024",
     .bounds = {25, 50, 26, 0, 27}},
    {"one-val", "M = 1", ROOM, .settings = "vals=1", .bounds = {7.6, 9.5, 3, 0, 19}},
    {"vpl-per-val", "M = N", ROOM, .settings = "vpls=256,vals=256",
     .bounds = {3.5, 2.5, 3.1, 0, 19}},
    {"more-vals", "M > N", ROOM, .settings = "vpls=64,vals=100", .bounds = {4.3, 4.2, 4, 0, 20}},
    /* Surfaces. */
    {"black", "albedo 0", OWN("black"), .bounds = {0.3, 0.3, 0.3, 0, 0.3}},
    {"white", "albedo 1", OWN("white"), .bounds = {3.1, 2.1, 2.5, 0, 16}},
    {"giant-triangle", "lengths over the scene's size: a floor of one kilometre",
     OWN("giant-triangle"), .bounds = {5.5, 42, 4.6, 0, 35}},
    {"tiny-triangles", "ten thousand triangles of a few texels", OWN("tiny-triangles"),
     .bounds = {5.9, 11, 5.5, 0, 23}},
    /* Scale. */
    {"millimetre", "the room as a millimetre", OWN("millimetre"), .bounds = {3.6, 2.6, 3, 0, 19}},
    {"kilometre", "the room as a kilometre", OWN("kilometre"), .bounds = {3.6, 2.5, 3, 0, 19}},
    {"far-away", "the room 17 km off the origin", OWN("far-away"), .bounds = {3.7, 2.5, 3, 0, 19}},
    /* Pictures. */
    {"inside-wall", "the camera inside a block", ROOM, .camera = "0 eye=0.2,0.5,-0.4",
     .bounds = {3.2, 1.2, 2.8, 0, 1.1}},
    {"fov-1", "a field of view of 1 degree", ROOM, .camera = "0 eye=0,1.5,120 fov=0.0174533",
     .bounds = {0.6, 1, 0.6, 0, 1}},
    {"fov-170", "a field of view of 170 degrees", ROOM, .camera = "0 eye=0,1.5,1.5 fov=2.9670597",
     .bounds = {3, 0.8, 2.4, 0, 16}},
    {"one-pixel", "a picture of 1 x 1", ROOM, .width = 1, .height = 1,
     .bounds = {0.4, 0.3, 0.4, 0, 3.7}},
    {"strip", "a picture of 16 x 4096", ROOM, .width = 16, .height = 4096,
     .bounds = {2.4, 1.2, 1.4, 0, 2.3}},
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
