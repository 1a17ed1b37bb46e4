// Adds a point to its voxel.
#include "shared/volume.h"

flat in vec4 surface_sum, radiosity_sum, back_sum, albedo_sum;
flat in float is_turned;

layout(location = TARGET_VOLUME_SURFACES) out vec4 surfaces;
#if CHANNELS == VOLUME_RADIANCE
layout(location = TARGET_VOLUME_RADIOSITY) out vec4 radiosity;
#endif
#if BACKS
layout(location = TARGET_VOLUME_BACK) out vec4 back;
#endif
#if BOUNCES
layout(location = TARGET_VOLUME_BACK + BACKS) out vec4 albedo;
#endif
#if SPLIT
layout(location = TARGET_VOLUME_BACK + BACKS + BOUNCES) out vec4 turned_surfaces;
layout(location = TARGET_VOLUME_BACK + BACKS + BOUNCES + 1) out vec4 turned_radiosity;
#endif

void main() {
    surfaces = surface_sum;
#if CHANNELS == VOLUME_RADIANCE
    radiosity = radiosity_sum;
#endif
#if BACKS
    back = back_sum;
#endif
#if BOUNCES
    albedo = albedo_sum;
#endif
#if SPLIT
    turned_surfaces = is_turned * surface_sum;
    turned_radiosity = is_turned * radiosity_sum;
#endif
}
