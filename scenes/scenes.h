/* The scenes: each function fills an empty file. */
#ifndef SCENES_SCENES_H
#define SCENES_SCENES_H

#include "glb.h"

void make_cornell_box(struct glb *glb);
void make_three_lights(struct glb *glb);
void make_cornell_animal(struct glb *glb);
void make_sphere(struct glb *glb);
void make_atrium(struct glb *glb);
void make_metaballs(struct glb *glb);
void make_moving_spot(struct glb *glb);
void make_door(struct glb *glb);
void make_creatures(struct glb *glb);
void make_character(struct glb *glb);
void make_table(struct glb *glb);
void make_gloss(struct glb *glb);
void make_materials(struct glb *glb);
void make_roughness(struct glb *glb);
void make_plant(struct glb *glb);
void make_courtyard(struct glb *glb);
void make_hall(struct glb *glb);
void make_ring(struct glb *glb);
void make_pawns(struct glb *glb);
void make_gem(struct glb *glb);
void make_window(struct glb *glb);
void make_vase(struct glb *glb);

/* scenes/boxes/failures.c */
void make_room(struct glb *glb);
void make_table_legs(struct glb *glb);
void make_contact(struct glb *glb);
void make_wide_light(struct glb *glb);
void make_grazing_receivers(struct glb *glb);
void make_val_plane(struct glb *glb);
void make_center_inside(struct glb *glb);
void make_thin_wall(struct glb *glb);
void make_closed_door(struct glb *glb);
void make_grazing_light(struct glb *glb);
void make_empty_map(struct glb *glb);
void make_needle(struct glb *glb);
void make_corner(struct glb *glb);
void make_black(struct glb *glb);
void make_white(struct glb *glb);
void make_giant_triangle(struct glb *glb);
void make_plain(struct glb *glb);
void make_tiny_triangles(struct glb *glb);
void make_millimetre(struct glb *glb);
void make_kilometre(struct glb *glb);
void make_far_away(struct glb *glb);
void make_ball_lamp(struct glb *glb);

/* The walls, the lamp and the camera of the Cornell box without its blocks; returns the white
 * material. */
int add_cornell_room(struct glb *glb);
void add_cornell_blocks(struct glb *glb);

#endif
