/* The scenes: each function fills an empty file. */
#ifndef SCENES_SCENES_H
#define SCENES_SCENES_H

#include "glb.h"

void make_cornell_box(struct glb *glb);
void make_cornell_animal(struct glb *glb);
void make_sphere(struct glb *glb);
void make_atrium(struct glb *glb);
void make_metaballs(struct glb *glb);
void make_moving_spot(struct glb *glb);
void make_door(struct glb *glb);
void make_creatures(struct glb *glb);
void make_character(struct glb *glb);

/* The walls, the lamp and the camera of the Cornell box without its blocks; returns the white
 * material. */
int add_cornell_room(struct glb *glb);
void add_cornell_blocks(struct glb *glb);

#endif
