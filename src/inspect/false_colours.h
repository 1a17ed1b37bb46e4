/* Measures light at each pixel of a frame for pictures in false colours: illuminance of surfaces,
 * or luminance of the picture. Colours count by their luminance (ITU-R BT.709). */
#ifndef INSPECT_FALSE_COLOURS_H
#define INSPECT_FALSE_COLOURS_H

#include "metrics/heat_map.h"
#include "renderer/renderer.h"

/* Units by the number of lumens that a watt of the scene stands for, as probe --efficacy has it. */
enum light_unit { LIGHT_CANDELA, LIGHT_555_NM, LIGHT_RADIANCE, LIGHT_WATTS, LIGHT_UNITS };

extern const char *const light_unit_names[LIGHT_UNITS];

/* Makes the map: values, unit as its title, and a scale to `top`; 0 fits it to the values. The
 * caller calls false_colours_free. Error: as renderer_read_layers. */
bool false_colours_init(struct heat_map *map, struct renderer *renderer, enum output_kind kind,
                        enum light_unit unit, float top);

/* Accepts a zeroed map. */
void false_colours_free(struct heat_map *map);

#endif
