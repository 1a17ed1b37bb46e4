/* Sums of the times of the start's phases on this thread, for notes. */
#ifndef BASE_PHASES_H
#define BASE_PHASES_H

enum phase {
    PHASE_SCENE,    /* files are read, triangles laid out */
    PHASE_CONTEXT,  /* opening OpenGL */
    PHASE_PROGRAMS, /* compiling and linking shaders, as far as the driver does so at once */
    PHASE_SIMPLIFY, /* simplifying casters of shadow maps */
    PHASE_TREE,     /* building BVHs for rays */
    PHASE_PICTURE,  /* drawing and writing the first picture */
    PHASE_COUNT
};

/* Adds the time from `since_ms`, a value of clock_ms, to the phase. */
void phase_add(enum phase phase, double since_ms);

/* Returns "scene 12 ms, ..." with all phases. The caller frees it. */
char *phases_text(void);

#endif
