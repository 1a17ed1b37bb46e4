#include "lab/measure/failures.h"

#include "base/error.h"
#include "base/names.h"

#include <string.h>

/* Every pixel takes every VPL and looks its own visibility up: in a small picture interleaving,
 * blur and blocks would hide all else; blocks of one pixel are a lookup for each VAL, not for each
 * of its VPLs. The frames have them. Edges are at pixel centres, as in the reference. */
#define EVERY_VPL "interleave=1,near-samples=1024,blur-radius=0,samples=1"

const char *const failure_columns[FAILURE_COLUMNS] = {
    "fast:technique=clustered,visibility-block=1," EVERY_VPL,
    "paper:technique=clustered,path=paper,visibility-block=1," EVERY_VPL,
    "instant-radiosity:technique=instant-radiosity," EVERY_VPL,
    "unshadowed:technique=unshadowed," EVERY_VPL,
    "frame:technique=clustered,samples=1",
    "lightcuts:technique=lightcuts,samples=1",
    "cluster-lights:technique=cluster-lights,visibility-block=1,samples=1",
    "imperfect-shadow-maps:technique=imperfect-shadow-maps,samples=1",
    "row-column:technique=row-column,samples=1",
    "imperfect-volume:technique=imperfect-volume,samples=1",
    "implicit-visibility:technique=implicit-visibility,samples=1",
};

#define OWN(name) "scenes/failures/" name ".glb"
#define ROOM OWN("room")

const struct failure_row failure_rows[] = {
    {"room", .scene = ROOM},
    /* Blockers: none; thin, in contact, wide penumbrae, seen edge-on, through a VAL's plane or
     * around its centre, leaking. */
    {"table-legs", .scene = OWN("table-legs")},
    {"contact", .scene = OWN("contact")},
    {"wide-light", .scene = OWN("wide-light"), .settings = "vals=2"},
    {"grazing-receivers", .scene = OWN("grazing-receivers")},
    {"val-plane", .scene = OWN("val-plane"), .settings = "vals=4"},
    {"center-inside", .scene = OWN("center-inside"), .settings = "vals=4"},
    {"thin-wall", .scene = OWN("thin-wall")},
    {"closed-door", .scene = OWN("closed-door")},
    /* Lights. */
    {"grazing-light", .scene = OWN("grazing-light")},
    {"empty-map", .scene = OWN("empty-map")},
    {"one-texel", .scene = OWN("needle")},
    {"corner", .scene = OWN("corner")},
    /* Counts. */
    {"one-vpl", .scene = ROOM, .settings = "vpls=1,interleave=1,near-samples=1024"},
    {"one-val", .scene = ROOM, .settings = "vals=1"},
    {"vpl-per-val", .scene = ROOM, .settings = "vpls=256,vals=256"},
    {"more-vals", .scene = ROOM, .settings = "vpls=64,vals=100"},
    /* Surfaces. */
    {"black", .scene = OWN("black")},
    {"white", .scene = OWN("white")},
    {"giant-triangle", .scene = OWN("giant-triangle")},
    {"plain", .scene = OWN("plain")},
    {"tiny-triangles", .scene = OWN("tiny-triangles")},
    /* Scale. */
    {"millimetre", .scene = OWN("millimetre")},
    {"kilometre", .scene = OWN("kilometre")},
    {"far-away", .scene = OWN("far-away")},
    /* Pictures. */
    {"inside-wall", .scene = ROOM, .camera = "0 eye=0.2,0.5,-0.4"},
    {"fov-1", .scene = ROOM, .camera = "0 eye=0,1.5,120 fov=0.0174533"},
    {"fov-170", .scene = ROOM, .camera = "0 eye=0,1.5,1.5 fov=2.9670597"},
    {"one-pixel", .scene = ROOM, .width = 1, .height = 1},
    {"strip", .scene = ROOM, .width = 16, .height = 4096},
    {.name = NULL},
};

const struct failure_row *failure_row_find(const char *name) {
    struct names names = {0};
    for (const struct failure_row *row = failure_rows; row->name; row++) {
        if (strcmp(row->name, name) == 0)
            return row;
        names_add(&names, ", ", row->name);
    }
    error_set("no failure is called '%s' (there are %s)", name, names.text);
    return NULL;
}
