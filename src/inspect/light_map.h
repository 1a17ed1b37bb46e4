/* Measures light at each pixel of a frame for pictures in false colours: illuminance of surfaces,
 * or luminance of the picture. Colours count by their luminance (ITU-R BT.709). */
#ifndef INSPECT_LIGHT_MAP_H
#define INSPECT_LIGHT_MAP_H

#include "metrics/heat_map.h"
#include "renderer/renderer.h"

/* Units by the number of lumens that a watt of the scene stands for, as probe --efficacy has it. */
enum light_unit { LIGHT_CANDELA, LIGHT_555_NM, LIGHT_RADIANCE, LIGHT_WATTS, LIGHT_UNITS };

extern const char *const light_unit_names[LIGHT_UNITS];

/* Makes the map: values, unit as its title, and a scale to `top`; 0 fits it to the values. The
 * caller calls light_map_free. Error: as renderer_read_layers. */
bool light_map_init(struct heat_map *map, struct renderer *renderer, enum output_kind kind,
                    enum light_unit unit, float top);

/* Accepts a zeroed map. */
void light_map_free(struct heat_map *map);

#endif
