/* Where C and GLSL meet: the numbers of uniform blocks, texture units, attributes, targets and
 * uniforms. Each thing that is bound has its own, so that no unit means two things. */
#ifndef SHARED_BINDINGS_H
#define SHARED_BINDINGS_H

/* Uniform blocks. GL promises 84. */
#define BLOCK_VIEW 0
#define BLOCK_LIGHTS 1
#define BLOCK_PASS 2 /* the parameters of the pass */
#define BLOCK_MATERIAL 3
#define BLOCK_MAPS 4
#define BLOCK_VPLS 5
#define BLOCK_LOOKUP 6
#define BLOCK_VPL_SHARES 7
#define BLOCK_LIST_COUNTS 8
#define BLOCK_SERIES_RANGES 9
#define BLOCK_SKY 10
#define BLOCK_LIGHT_RECTANGLES 11

/* Storages and images, which shaders write. GL promises 8 each to compute shaders. A screen pass that is dispatched
 * stores to its targets from IMAGE_SCREEN_TARGETS on, at most five, and may have the images before (gl/screen.h); only
 * other compute shaders have those after. */
#define STORAGE_LIST_COUNTS 0
#define STORAGE_SERIES_RANGES 1
#define STORAGE_TREE_KEYS 2
#define STORAGE_SCREEN_ROWS 3 /* of screen passes that are dispatched */
#define IMAGE_LISTED_PIXELS 0
#define IMAGE_FURTHER_TEXELS 1
#define IMAGE_FURTHER_POINTS 2
#define IMAGE_SCREEN_TARGETS 3
#define IMAGE_SUMS 4
#define IMAGE_DEPTH_BOUNDS 5
#define IMAGE_TREE_NODES 6
#define IMAGE_CUTS 7

/* Texture units. GL promises 96, and 16 to a stage. Maps of lights' views have LIGHT_MAP_KINDS each
 * (shared/light.h). */
#define UNIT_BASE_COLOR 0
#define UNIT_GBUFFER_DEPTH 1
#define UNIT_GBUFFER_NORMAL 2
#define UNIT_GBUFFER_ALBEDO 3
#define UNIT_RSM_DEPTH 4
#define UNIT_CALIBRATION_TESTS 5
#define UNIT_RSM_NORMAL 6
#define UNIT_CALIBRATION_SUMS 7
#define UNIT_RSM_ALBEDO 8
#define UNIT_CALIBRATION_SQUARES 9
#define UNIT_VPLS 10
#define UNIT_VAL_POSITION 11
#define UNIT_VAL_NORMAL 12
#define UNIT_VAL_FLUX 13
#define UNIT_VAL_EXTREMES 14
#define UNIT_SUM_POSITION 15
#define UNIT_SUM_NORMAL 16
#define UNIT_SUM_FLUX 17
#define UNIT_MAP_DEPTH 18
#define UNIT_BASIS_COS 19
#define UNIT_BASIS_SIN 20
#define UNIT_BASIS_Z_COS 21
#define UNIT_BASIS_Z_SIN 22
#define UNIT_BASIS_Z 23
#define UNIT_BLOCK_VISIBILITY 24
#define UNIT_NEAR_LIGHT 25
#define UNIT_CALIBRATION 26
#define UNIT_DIRECT 27
#define UNIT_IRRADIANCE 28
#define UNIT_BLUR_TAPS 29
#define UNIT_SAMPLE_DEPTH 30
#define UNIT_SAMPLE_PICKS 31
#define UNIT_INSPECTED_LAYERS 32
#define UNIT_INSPECTED_PLANE 33
#define UNIT_LEFT_PICTURE 34
#define UNIT_RIGHT_PICTURE 35
#define UNIT_RADIANCE 36
#define UNIT_IN_SCATTER 37
#define UNIT_TRANSMITTANCE 38
#define UNIT_LISTED_PIXELS 39
#define UNIT_LIST_TEXELS 40
#define UNIT_DETAIL_IRRADIANCE 41
#define UNIT_VPL_SUMS 42
#define UNIT_PATH_AREAS 43
#define UNIT_PATHS_KEPT 44
#define UNIT_VPL_VALUES 46
#define UNIT_VPL_VALUE_SUM 47
#define UNIT_PATH_RESULTS 48 /* what the pass before has of each path */
#define UNIT_SKY 49
#define UNIT_EMISSION 50 /* a material's texture */
#define UNIT_GBUFFER_EMISSION 51
#define UNIT_SUMS 52
#define UNIT_DEPTH_BOUNDS 53
#define UNIT_MAP_NORMAL 54
#define UNIT_SKY_MAPS 55
#define UNIT_SKY_SHARES 56
#define UNIT_METAL_ROUGHNESS 57 /* a material's textures */
#define UNIT_NORMAL_MAP 58
#define UNIT_GBUFFER_GLOSS 59
#define UNIT_LOBES 60
#define UNIT_DIRECT_SPECULAR 61
#define UNIT_LAYER_SUMS 62 /* LAYERS of them: shared/composite.h */
#define UNIT_SAMPLE_NORMAL 71
#define UNIT_FURTHER_POINTS 72
#define UNIT_FURTHER_TEXELS 73
#define UNIT_FURTHER_IRRADIANCE 74
#define UNIT_TREE_NODES 75
#define UNIT_TREE_PICKS 76
#define UNIT_CUTS 77
#define UNIT_CASTER_POINTS 78
#define UNIT_COARSE_DEPTH 79
#define UNIT_SUM_SQUARES 80
#define UNIT_SUM_PRODUCTS 81
#define UNIT_RSM_GLOSS 82
#define UNIT_PATH_NEXT 83
#define UNIT_IMPORTANCE 84
#define UNIT_VPL_NUMBERS 85
#define UNIT_SEEDS 86
#define UNIT_TRIANGLE_TREE 90
#define UNIT_TRIANGLE_ALBEDOS 91
#define UNIT_PATH_NUMBERS 92
#define UNIT_PATH_POSITIONS 93
#define UNIT_PATH_NORMALS 94
#define UNIT_PATH_FLUXES 95

/* Attributes of the scene's vertices. UV is of a material's first mapping, the others of the further ones. */
#define ATTRIBUTE_POSITION 0
#define ATTRIBUTE_NORMAL 1
#define ATTRIBUTE_UV 2
#define ATTRIBUTE_COLOR 3
#define ATTRIBUTE_UV_1 4
#define ATTRIBUTE_UV_2 5
#define ATTRIBUTE_UV_3 6

/* Attributes of VPLs drawn as points, in the order of struct vpl; and of what they are made of. */
#define ATTRIBUTE_VPL_POSITION 0
#define ATTRIBUTE_VPL_NORMAL 1
#define ATTRIBUTE_VPL_FLUX 2
#define ATTRIBUTE_VPL_POINT 0
#define ATTRIBUTE_ROW_PLACE 0

/* Targets: the one of most shaders, and those of shaders that write several. */
#define TARGET_RESULT 0
#define TARGET_GBUFFER_NORMAL 0
#define TARGET_GBUFFER_ALBEDO 1
#define TARGET_GBUFFER_EMISSION 2
#define TARGET_GBUFFER_GLOSS 3
#define TARGET_DIRECT_SPECULAR 1
#define TARGET_BASIS_COS 0
#define TARGET_BASIS_SIN 1
#define TARGET_BASIS_Z_COS 2
#define TARGET_BASIS_Z_SIN 3
#define TARGET_BASIS_Z 4
#define TARGET_VAL_POSITION 0 /* likewise of sums over a VAL's VPLs */
#define TARGET_VAL_NORMAL 1
#define TARGET_VAL_FLUX 2
#define TARGET_CALIBRATION_SUM 0
#define TARGET_CALIBRATION_SQUARE 1
#define TARGET_SUM_SQUARES 0
#define TARGET_SUM_PRODUCTS 1
#define TARGET_BOUNCE_POSITION 0
#define TARGET_BOUNCE_NORMAL 1
#define TARGET_BOUNCE_FLUX 2
#define TARGET_BOUNCE_NEXT 3

/* Uniforms, which change from draw to draw: all else is in blocks. */
#define LOCATION_SLOT 0 /* of an interleaving pattern */
#define LOCATION_SLOT_WEIGHT 1
#define LOCATION_FIRST_MAP 2
#define LOCATION_FIRST_LAYER 3
#define LOCATION_FIRST_VIEW 4
#define LOCATION_LIGHT 5
#define LOCATION_TILE 6
#define LOCATION_SET_BACK 7
#define LOCATION_PICK_COUNT 8
#define LOCATION_TREE_STEP 9
#define LOCATION_NEAR_SHIFT 10
#define LOCATION_CAMERA_RANGE 11
#define LOCATION_SCREEN_AREA 12 /* of screen passes that are dispatched */
#define LOCATION_SCREEN_ADDS 14
#define LOCATION_SCREEN_ROW 15
#define LOCATION_PICKS 16 /* LIGHTS_MAX of them (shared/light.h) */

#endif
