/* A surface element with its links, to be looked at: what read_element of struct technique finds. */
#ifndef TECHNIQUES_ELEMENT_VIEW_H
#define TECHNIQUES_ELEMENT_VIEW_H

/* Faces of the unfolded cube: a cross of four in a row, and one above and one below the second. The element's normal leads
 * through the one above, or comes near it. */
enum element_face {
    ELEMENT_LEFT,
    ELEMENT_FRONT,
    ELEMENT_RIGHT,
    ELEMENT_REAR,
    ELEMENT_ABOVE,
    ELEMENT_BELOW,
    ELEMENT_FACES,
};

enum element_bin_kind {
    ELEMENT_BIN_HIDDEN, /* below the element's horizon */
    ELEMENT_BIN_OPEN,   /* without a partner */
    ELEMENT_BIN_BACK,   /* its partner is seen from behind: dark */
    ELEMENT_BIN_LINKED,
};

struct element_bin {
    enum element_bin_kind kind;
    float cosine;      /* over the bin, sr */
    int level;         /* of the partner in the tree: 0 an element, 1 a node of up to four, ... */
    float partner[3];  /* its position, m */
    float radiance[3]; /* that the last bounce took from it, W/(sr m2) */
};

struct element_view {
    int side;                         /* bins along an edge of a face; 0: there is no element */
    float position[3], irradiance[3]; /* m; indirect, W/m2 */
    struct element_bin *bins; /* face by face; of each row by row from above, from left to right */
};

/* Accepts a zeroed one. */
void element_view_free(struct element_view *view);

#endif
