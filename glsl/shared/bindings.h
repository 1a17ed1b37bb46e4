/* Binding numbers that C and GLSL share: uniform blocks, texture units, attributes, targets,
 * uniforms. */
#ifndef SHARED_BINDINGS_H
#define SHARED_BINDINGS_H

/* Uniform blocks. OpenGL guarantees 84. */
#define BLOCK_VIEW 0
#define BLOCK_LIGHTS 1
#define BLOCK_PASS 2 /* parameters of the pass */
#define BLOCK_MATERIAL 3
#define BLOCK_MAPS 4
#define BLOCK_VPLS 5
#define BLOCK_LOOKUP 6
#define BLOCK_VPL_SHARES 7
#define BLOCK_LIST_COUNTS 8
#define BLOCK_SERIES_RANGES 9
#define BLOCK_SKY 10
#define BLOCK_LIGHT_RECTANGLES 11
#define BLOCK_MEDIUM 12

/* Storage blocks and images, which shaders write. OpenGL guarantees 8 of each to compute shaders. A
 * dispatched screen pass stores to at most five targets from IMAGE_SCREEN_TARGETS on, and may use
 * the images before (gl/screen.h). Only other compute shaders use the images after. */
#define STORAGE_LIST_COUNTS 0
#define STORAGE_SERIES_RANGES 1
#define STORAGE_TREE_KEYS 2
#define STORAGE_SCREEN_ROWS 3  /* of dispatched screen passes */
#define STORAGE_SCREEN_QUEUE 4 /* of dispatched screen passes */
#define STORAGE_ELEMENT_CELLS 5
#define STORAGE_ELEMENTS 6
#define STORAGE_ELEMENT_LINKS 7
#define IMAGE_ADAPTIVE_PIXELS 0
#define IMAGE_EDGE_SAMPLE_TEXELS 1
#define IMAGE_EDGE_SAMPLES 2
#define IMAGE_SCREEN_TARGETS 3
#define IMAGE_SUMS 4
#define IMAGE_DEPTH_BOUNDS 5
#define IMAGE_TREE_NODES 6
#define IMAGE_CUTS 7

/* Texture units. OpenGL guarantees 96, and 16 samplers a stage. Textures of several passes have a
 * number here. Those of one pass are numbered from UNIT_OWN on in shared/PASS.h; passes share these
 * numbers, because a program includes own units of one header. An array takes a number for each
 * element. test/shaders/check and debug contexts (gl/context/samplers.c) check that no two samplers
 * of a program share a unit. */
#define UNIT_BASE_COLOR 1 /* of a material, with the next three */
#define UNIT_EMISSION 2
#define UNIT_METAL_ROUGHNESS 3
#define UNIT_NORMAL_MAP 4
#define UNIT_GBUFFER_DEPTH 5
#define UNIT_GBUFFER_NORMAL 6
#define UNIT_GBUFFER_ALBEDO 7
#define UNIT_GBUFFER_EMISSION 8
#define UNIT_GBUFFER_SPECULAR 9
#define UNIT_RSM_DEPTH 10 /* LIGHT_MAP_KINDS of each (shared/light.h) */
#define UNIT_RSM_NORMAL 12
#define UNIT_RSM_ALBEDO 14
#define UNIT_LOBES 16
#define UNIT_BVH 17
#define UNIT_VPLS 18
#define UNIT_VPL_SUMS 19
#define UNIT_VPL_VALUES 20
#define UNIT_VPL_VALUE_SUM 21
#define UNIT_TREE_NODES 22
#define UNIT_TREE_REPRESENTATIVES 23
#define UNIT_VAL_POSITION 24
#define UNIT_VAL_NORMAL 25
#define UNIT_VAL_FLUX 26
#define UNIT_VAL_EXTREMES 27
#define UNIT_MAP_DEPTH 28
#define UNIT_MAP_NORMAL 29
#define UNIT_BASIS_COS 30
#define UNIT_BASIS_SIN 31
#define UNIT_BASIS_Z_COS 32
#define UNIT_BASIS_Z_SIN 33
#define UNIT_BASIS_Z 34
#define UNIT_SUMS 35
#define UNIT_DEPTH_BOUNDS 36
#define UNIT_BLOCK_VISIBILITY 37
#define UNIT_DIRECT 39
#define UNIT_DIRECT_SPECULAR 40
#define UNIT_IRRADIANCE 41
#define UNIT_RADIANCE 42
#define UNIT_SAMPLE_ASSIGNMENT 43
#define UNIT_EDGE_SAMPLES 44
#define UNIT_ADAPTIVE_PIXELS 45
#define UNIT_LIST_TEXELS 46
#define UNIT_VPL_DENSITY 47
#define UNIT_SLIDES 48 /* of spots */
#define UNIT_LOBE_ALBEDOS 49
#define UNIT_TRIANGLE_ALBEDOS 50
#define UNIT_PANES 51
#define UNIT_SKY_PIECES 52   /* shared/sky.h */
#define UNIT_RSM_SPECULAR 53 /* LIGHT_MAP_KINDS of them */
#define UNIT_LIGHT_NODES 55
#define UNIT_SAMPLED_LIGHTS 56
#define UNIT_OWN 64

/* Attributes of the scene's vertices. UV is the first mapping of a material, the others follow. */
#define ATTRIBUTE_POSITION 0
#define ATTRIBUTE_NORMAL 1
#define ATTRIBUTE_UV 2
#define ATTRIBUTE_COLOR 3
#define ATTRIBUTE_UV_1 4
#define ATTRIBUTE_UV_2 5
#define ATTRIBUTE_UV_3 6

/* Attributes of VPLs drawn as points, in the order of struct vpl; and of their sample points. */
#define ATTRIBUTE_VPL_POSITION 0
#define ATTRIBUTE_VPL_NORMAL 1
#define ATTRIBUTE_VPL_FLUX 2
#define ATTRIBUTE_VPL_LOBE 3
#define ATTRIBUTE_VPL_POINT 0
#define ATTRIBUTE_ROW_PLACE 0

/* Targets: that of most shaders, and those of shaders with several. */
#define TARGET_RESULT 0
#define TARGET_GBUFFER_NORMAL 0
#define TARGET_GBUFFER_ALBEDO 1
#define TARGET_GBUFFER_EMISSION 2
#define TARGET_GBUFFER_SPECULAR 3
#define TARGET_DIRECT_SPECULAR 1
#define TARGET_SAMPLED 1
#define TARGET_SAMPLED_EXACT_SPECULAR 2
#define TARGET_SAMPLED_SPECULAR 3
#define TARGET_BASIS_COS 0
#define TARGET_BASIS_SIN 1
#define TARGET_BASIS_Z_COS 2
#define TARGET_BASIS_Z_SIN 3
#define TARGET_BASIS_Z 4
#define TARGET_SUM_SQUARES 0
#define TARGET_SUM_PRODUCTS 1
#define TARGET_TRANSMITTANCE 1
#define TARGET_BOUNCE_POSITION 0
#define TARGET_BOUNCE_NORMAL 1
#define TARGET_BOUNCE_FLUX 2
#define TARGET_BOUNCE_NEXT 3

/* Uniforms that change between draws; all others are in blocks. */
#define LOCATION_SLOT 0 /* slot of an interleaving pattern */
#define LOCATION_SLOT_WEIGHT 1
#define LOCATION_FIRST_MAP 2
#define LOCATION_FIRST_LAYER 3
#define LOCATION_FIRST_VIEW 4
#define LOCATION_LIGHT 5
#define LOCATION_TILE 6
#define LOCATION_SLOT_LIGHT_COUNT 8
#define LOCATION_TREE_STEP 9
#define LOCATION_FIRST_TRIANGLE 9
#define LOCATION_OF_PANES 10
#define LOCATION_NEAR_SHIFT 10
#define LOCATION_CAMERA_RANGE 11
#define LOCATION_SCREEN_AREA 12 /* of dispatched screen passes */
#define LOCATION_SCREEN_ADDS 14
#define LOCATION_SCREEN_ROW 15
#define LOCATION_SKY_LAYERS 13  /* first and count */
#define LOCATION_SLOT_LIGHTS 16 /* LIGHTS_MAX of them (shared/light.h) */

#endif
