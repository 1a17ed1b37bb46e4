/* What the atrium is built of. Each piece stands at its own origin: x along the arcade, z towards
 * the court, y = 0 at its foot. */
#ifndef SCENES_ATRIUM_PIECES_H
#define SCENES_ATRIUM_PIECES_H

#include "scene/shapes/surface.h"

/* The plan, metres. */
#define PITCH 2.5f         /* between the columns */
#define AISLE 3.0f         /* from the columns to the outer wall */
#define SPRING 3.0f        /* where the lower arches begin */
#define GALLERY 4.6f       /* the gallery's floor */
#define RAIL 0.95f         /* height of the balustrade */
#define UPPER_SPRING 2.45f /* where the upper arches begin, above the gallery */
#define EAVES 8.6f         /* the gallery's ceiling */
#define ARCADE_DEPTH 0.55f
#define UPPER_DEPTH 0.40f

/* Lower storey. A column is SPRING high, from plinth to abacus. */
void add_column_shaft(struct surface *surface);
void add_column_ends(struct surface *surface);
void add_pier(struct surface *surface);
void add_lower_corner(struct surface *surface); /* of the wall above the pier */
void add_lower_arch(struct surface *surface);
void add_lower_archivolt(struct surface *surface);
void add_aisle_vault(struct surface *surface, float half_x, float half_z);
void add_aisle_rib(struct surface *surface); /* across the aisle, z = 0 in its middle */
void add_door_wall(struct surface *surface);
void add_door(struct surface *surface);

/* Upper storey, y = 0 at the gallery's floor. */
void add_pedestal(struct surface *surface);
void add_upper_column(struct surface *surface);
void add_upper_capital(struct surface *surface);
void add_upper_pier(struct surface *surface);
void add_upper_arch(struct surface *surface);
void add_upper_archivolt(struct surface *surface);
void add_balusters(struct surface *surface);
void add_rail(struct surface *surface);

/* Mouldings that run the length of a bay, y = 0 at their lower edge, z = 0 at the wall. */
void add_string_course(struct surface *surface, float length);
void add_cornice(struct surface *surface, float length);
void add_roof(struct surface *surface, float length);

/* A rosette in a frame, seen from +z, y = 0 in its middle. */
void add_rosette(struct surface *surface);
void add_rosette_frame(struct surface *surface);

void add_pot(struct surface *surface);
void add_fountain(struct surface *surface);

#endif
