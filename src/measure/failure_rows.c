#include "measure/failures.h"

#include "base/error.h"
#include "base/text.h"

#include <stdlib.h>
#include <string.h>

/* Every pixel takes every VPL and looks its own visibility up: in a small picture interleaving,
 * blur and blocks would hide all else; blocks of one pixel are a lookup for each VAL, not for each
 * of its VPLs. The frame has them. Edges are at pixel centres, as in the reference. */
#define EVERY_VPL "interleave=1,near-samples=1024,blur-radius=0,samples=1"

const struct failure_column failure_columns[FAILURE_COLUMNS] = {
    {"fast", "clustered", "visibility-block=1," EVERY_VPL},
    {"paper", "clustered", "path=paper,visibility-block=1," EVERY_VPL},
    {"instant-radiosity", "instant-radiosity", EVERY_VPL},
    {"unshadowed", "unshadowed", EVERY_VPL},
    {"frame", "clustered", "samples=1"},
};

#define OWN(name) "scenes/failures/" name ".glb"
#define ROOM OWN("room")

const struct failure_row failure_rows[] = {
    {"room", "nothing: what the others are held against", .scene = ROOM},
    /* Blockers. */
    {"table-legs", "blockers thinner than a texel of a map", .scene = OWN("table-legs")},
    {"contact", "contact: light under a box", .scene = OWN("contact")},
    {"wide-light", "a very large VAL: wide penumbrae, ringing", .scene = OWN("wide-light"),
     .settings = "vals=2"},
    {"grazing-receivers", "receivers seen edge-on: bent penumbrae",
     .scene = OWN("grazing-receivers")},
    {"val-plane", "a blocker through a VAL's plane", .scene = OWN("val-plane"),
     .settings = "vals=4"},
    {"center-inside", "VAL centres inside geometry", .scene = OWN("center-inside"),
     .settings = "vals=4"},
    {"thin-wall", "paper-thin, seen from both sides: leaks", .scene = OWN("thin-wall")},
    {"closed-door", "leaks from one room to another", .scene = OWN("closed-door")},
    /* Lights. */
    {"grazing-light", "light along a wall: VPLs far apart", .scene = OWN("grazing-light")},
    {"empty-map", "light that meets nothing", .scene = OWN("empty-map")},
    {"one-texel", "all VPLs in one place", .scene = OWN("needle")},
    {"corner", "VPLs in a corner: the singularity", .scene = OWN("corner")},
    /* Counts. */
    {"one-vpl", "N = 1", .scene = ROOM, .settings = "vpls=1,interleave=1,near-samples=1024"},
    {"one-val", "M = 1", .scene = ROOM, .settings = "vals=1"},
    {"vpl-per-val", "M = N", .scene = ROOM, .settings = "vpls=256,vals=256"},
    {"more-vals", "M > N", .scene = ROOM, .settings = "vpls=64,vals=100"},
    /* Surfaces. */
    {"black", "albedo 0", .scene = OWN("black")},
    {"white", "albedo 1", .scene = OWN("white")},
    {"giant-triangle", "lengths over the scene's size: a floor of one kilometre",
     .scene = OWN("giant-triangle")},
    {"tiny-triangles", "ten thousand triangles of a few texels", .scene = OWN("tiny-triangles")},
    /* Scale. */
    {"millimetre", "the room as a millimetre", .scene = OWN("millimetre")},
    {"kilometre", "the room as a kilometre", .scene = OWN("kilometre")},
    {"far-away", "the room 17 km off the origin", .scene = OWN("far-away")},
    /* Pictures. */
    {"inside-wall", "the camera inside a block", .scene = ROOM, .camera = "0 eye=0.2,0.5,-0.4"},
    {"fov-1", "a field of view of 1 degree", .scene = ROOM,
     .camera = "0 eye=0,1.5,120 fov=0.0174533"},
    {"fov-170", "a field of view of 170 degrees", .scene = ROOM,
     .camera = "0 eye=0,1.5,1.5 fov=2.9670597"},
    {"one-pixel", "a picture of 1 x 1", .scene = ROOM, .width = 1, .height = 1},
    {"strip", "a picture of 16 x 4096", .scene = ROOM, .width = 16, .height = 4096},
    {.name = NULL},
};

const struct failure_row *failure_row_find(const char *name) {
    struct text names = {0};
    for (const struct failure_row *row = failure_rows; row->name; row++) {
        if (strcmp(row->name, name) == 0) {
            free(names.data);
            return row;
        }
        text_print(&names, " %s", row->name);
    }
    error_set("no failure is called '%s' (there is:%s)", name, names.data);
    free(names.data);
    return NULL;
}
