#include "shared/map_view.h"

layout(std140, binding = BLOCK_MAPS) uniform map_uniforms {
    map_view views[MAP_VIEWS_MAX];
};
