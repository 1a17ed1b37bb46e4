/* A scene pack: scene.glb as it is, environment.exr, and scene.json, which tells camera, lights and
 * picture in plain numbers. bench/entries/README.md describes it; bench/schema/pack.schema.json
 * tells its form. */
#ifndef LAB_EXPORT_PACK_H
#define LAB_EXPORT_PACK_H

#include "lab/export/target.h"

/* Error: also of a scene that is no GLB, and of lamps of which some shine and some do not. */
bool export_pack(struct export_target *target);

#endif
