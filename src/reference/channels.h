/* The channels of a reference picture, in the order of the pixel's floats. */
#ifndef REFERENCE_CHANNELS_H
#define REFERENCE_CHANNELS_H

/* Those of every picture, and what the path tracer has besides: the standard error of the indirect
 * layer, whose square, the variance, half floats could not hold; and what emits light itself. Then what shadows are made of, where that
 * is asked for. Then specular reflection, where some surface has it, and ambient occlusion, where it is asked for. Last
 * airlight, where there is a medium. */
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

/* What light paths add where they are asked for (reference/light_tracer.h). */
#define CHANNELS_OF_CAUSTIC                                                                        \
    "caustic.R caustic.G caustic.B "                                                               \
    "standard_error.caustic.R standard_error.caustic.G standard_error.caustic.B"
#define CHANNELS_OF_VOLUME                                                                         \
    "volume.R volume.G volume.B "                                                                  \
    "standard_error.volume.R standard_error.volume.G standard_error.volume.B"

/* The first channel of each layer. Beauty and what is emitted alone are not zero where no surface is seen. */
enum film_channel {
    CHANNEL_BEAUTY = 0, /* radiance, W/(sr m2): albedo x (direct + indirect) + specular, and what is
                           emitted */
    CHANNEL_ALPHA = 3,  /* the share of the pixel that shows a surface */
    CHANNEL_DEPTH = 4,  /* along the view axis at the pixel's centre, m */
    CHANNEL_DIRECT = 5, /* irradiance over pi, W/(sr m2): the albedo is not in it */
    CHANNEL_INDIRECT = 8, /* the same */
    CHANNEL_ALBEDO = 11,  /* of the diffuse part, in [0, 1] */
    CHANNEL_NORMAL = 14,  /* world, unit, towards the camera's side */
    CHANNEL_COMMON_END = 17,
    CHANNEL_STANDARD_ERROR = CHANNEL_COMMON_END,
    CHANNEL_EMITTED = 20, /* radiance, W/(sr m2): of the sky, too */
    CHANNEL_PATH_TRACER_END = 23,
    CHANNEL_UNSHADOWED = CHANNEL_PATH_TRACER_END, /* direct light if nothing hid the lights */
    CHANNEL_VISIBILITY = 26, /* the share of the lights seen: reference/seen.h */
    CHANNEL_DIRECT_ERROR =
        29, /* standard errors of the means over RGB of direct light and visibility */
    CHANNEL_VISIBILITY_ERROR = 30,
    CHANNEL_END = 31,
};

/* The same, from where the layers of specular reflection begin: radiance, W/(sr m2). */
enum specular_channel {
    SPECULAR_DIRECT = 0,
    SPECULAR_INDIRECT = 3,
    SPECULAR_ALL = 6,
    SPECULAR_STANDARD_ERROR = 9, /* of all */
    SPECULAR_END = 12,
};

/* The same, from where ambient occlusion begins: reference/ao.h. */
enum ao_channel {
    AO_OPEN = 0, /* 1 = nothing is near */
    AO_STANDARD_ERROR = 1,
    AO_END = 2,
};

/* The same, from where the layers of a medium begin: radiance, W/(sr m2). */
enum airlight_channel {
    AIRLIGHT_RADIANCE = 0,
    AIRLIGHT_STANDARD_ERROR = 3,
    AIRLIGHT_END = 6,
};

/* The same, from where the layers of light paths begin. */
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
