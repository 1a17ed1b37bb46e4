// The texel of a panorama that lies in a direction, of any length; turn: radians. As scene/lights/environment.c has it.
vec3 panorama_texel(sampler2D panorama, vec3 along, float turn) {
    const float PI = 3.14159265;
    float azimuth = atan(along.z, along.x) + turn;
    vec2 place = vec2(fract(azimuth / (2.0 * PI) + 0.5), atan(length(along.xz), along.y) / PI);
    ivec2 size = textureSize(panorama, 0);
    return texelFetch(panorama, min(ivec2(place * vec2(size)), size - 1), 0).rgb;
}
