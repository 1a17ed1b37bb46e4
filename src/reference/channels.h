/* The channels of a reference picture, in the order of the pixel's floats. */
#ifndef REFERENCE_CHANNELS_H
#define REFERENCE_CHANNELS_H

/* Channels of all pictures, then those of the path tracer: standard error of the indirect layer,
 * and emission. Half floats cannot hold the variance, which is the error's square. On request
 * `seen` follows. Then come specular reflection if some surface is specular, ambient occlusion on
 * request, and airlight with a medium. */
#define CHANNELS_COMMON                                                                            \
    "R G B A Z direct.R direct.G direct.B indirect.R indirect.G indirect.B "                       \
    "albedo.R albedo.G albedo.B normal.X normal.Y normal.Z"
#define CHANNELS_OF_PATH_TRACER                                                                    \
    CHANNELS_COMMON " standard_error.R standard_error.G standard_error.B "                         \
                    "emitted.R emitted.G emitted.B"
#define CHANNELS_OF_SEEN                                                                           \
    "unshadowed.R unshadowed.G unshadowed.B visibility.R visibility.G visibility.B "               \
    "standard_error.direct.Y standard_error.visibility.Y"
#define CHANNELS_OF_SPECULAR                                                                       \
    "direct.specular.R direct.specular.G direct.specular.B "                                       \
    "indirect.specular.R indirect.specular.G indirect.specular.B "                                 \
    "specular.R specular.G specular.B "                                                            \
    "standard_error.specular.R standard_error.specular.G standard_error.specular.B"
#define CHANNELS_OF_AO "ao.Y standard_error.ao.Y"

#define CHANNELS_OF_AIRLIGHT                                                                       \
    "airlight.R airlight.G airlight.B "                                                            \
    "standard_error.airlight.R standard_error.airlight.G standard_error.airlight.B"

/* Channels that light paths add on request (reference/light_tracer.h). */
#define CHANNELS_OF_CAUSTIC                                                                        \
    "caustic.R caustic.G caustic.B "                                                               \
    "standard_error.caustic.R standard_error.caustic.G standard_error.caustic.B"
#define CHANNELS_OF_VOLUME                                                                         \
    "volume.R volume.G volume.B "                                                                  \
    "standard_error.volume.R standard_error.volume.G standard_error.volume.B"

/* First channel of each layer. Without a surface all are zero except beauty and emission. */
enum film_channel {
    /* Radiance, W/(sr m2): albedo x (direct + indirect) + specular + emission. */
    CHANNEL_BEAUTY = 0,
    CHANNEL_ALPHA = 3,    /* fraction of the pixel covered by surfaces */
    CHANNEL_DEPTH = 4,    /* along the view axis at the pixel's centre, metres */
    CHANNEL_DIRECT = 5,   /* irradiance over pi, W/(sr m2), without the albedo */
    CHANNEL_INDIRECT = 8, /* as CHANNEL_DIRECT */
    CHANNEL_ALBEDO = 11,  /* of the diffuse part, in [0, 1] */
    CHANNEL_NORMAL = 14,  /* world, unit, towards the camera */
    CHANNEL_COMMON_END = 17,
    CHANNEL_STANDARD_ERROR = CHANNEL_COMMON_END,
    CHANNEL_EMITTED = 20, /* radiance, W/(sr m2), with the environment */
    CHANNEL_PATH_TRACER_END = 23,
    CHANNEL_UNSHADOWED = CHANNEL_PATH_TRACER_END, /* direct light without shadows */
    CHANNEL_VISIBILITY = 26, /* visible fraction of the lights (reference/seen.h) */
    /* Standard errors of the RGB means of direct light and of visibility. */
    CHANNEL_DIRECT_ERROR = 29,
    CHANNEL_VISIBILITY_ERROR = 30,
    CHANNEL_END = 31,
};

/* Offsets from the first layer of specular reflection: radiance, W/(sr m2). */
enum specular_channel {
    SPECULAR_DIRECT = 0,
    SPECULAR_INDIRECT = 3,
    SPECULAR_ALL = 6,
    SPECULAR_STANDARD_ERROR = 9, /* of SPECULAR_ALL */
    SPECULAR_END = 12,
};

/* Offsets from the first layer of ambient occlusion (reference/ao.h). */
enum ao_channel {
    AO_OPEN = 0, /* 1: no occluder in range */
    AO_STANDARD_ERROR = 1,
    AO_END = 2,
};

/* Offsets from the first layer of airlight: radiance, W/(sr m2). */
enum airlight_channel {
    AIRLIGHT_RADIANCE = 0,
    AIRLIGHT_STANDARD_ERROR = 3,
    AIRLIGHT_END = 6,
};

/* Offsets from the first layers of light paths. */
enum caustic_channel {
    CAUSTIC_LIGHT = 0, /* irradiance over pi, W/(sr m2), as CHANNEL_DIRECT */
    CAUSTIC_STANDARD_ERROR = 3,
    CAUSTIC_END = 6,
};
enum volume_channel {
    VOLUME_LIGHT = 0, /* radiance, W/(sr m2) */
    VOLUME_STANDARD_ERROR = 3,
    VOLUME_END = 6,
};

#endif
