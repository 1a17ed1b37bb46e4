/* How long the phases of a start take, for notes: sums of this thread. */
#ifndef BASE_PHASES_H
#define BASE_PHASES_H

enum phase {
    PHASE_SCENE,    /* files are read and laid out */
    PHASE_CONTEXT,  /* OpenGL opens */
    PHASE_PROGRAMS, /* shaders are compiled and linked, as far as the driver does so at once */
    PHASE_SIMPLIFY, /* casters of shadow maps */
    PHASE_TREE,     /* of triangles, for rays */
    PHASE_PICTURE,  /* the first is drawn and written */
    PHASE_COUNT
};

/* Adds the time since then, by base/clock.h. */
void phase_add(enum phase phase, double since_ms);

/* "scene 12 ms, ..." of all phases; free() frees. */
char *phases_text(void);

#endif
