// Directions: their codes, the texel of a panorama that they show, and directions around an axis.

// A unit vector in two numbers of [0, 1]: the octahedron unfolded onto a square.
vec2 octahedral_encode(vec3 n) {
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    vec2 folded = (1.0 - abs(n.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(n.xy, vec2(0.0)));
    return (n.z >= 0.0 ? n.xy : folded) * 0.5 + 0.5;
}

// Of any length.
vec3 octahedral_unfold(vec2 code) {
    vec2 p = code * 2.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float fold = max(-n.z, 0.0);
    n.xy -= mix(vec2(-fold), vec2(fold), greaterThanEqual(n.xy, vec2(0.0)));
    return n;
}

vec3 octahedral_decode(vec2 code) {
    return normalize(octahedral_unfold(code));
}

// The texel of a panorama that lies in a direction, of any length; turn: radians. As scene/lights/environment.c has it.
vec3 panorama_texel(sampler2D panorama, vec3 along, float turn) {
    const float PI = 3.14159265;
    float azimuth = atan(along.z, along.x) + turn;
    vec2 place = vec2(fract(azimuth / (2.0 * PI) + 0.5), atan(length(along.xz), along.y) / PI);
    ivec2 size = textureSize(panorama, 0);
    return texelFetch(panorama, min(ivec2(place * vec2(size)), size - 1), 0).rgb;
}

// A unit vector perpendicular to a unit vector, continuous but at one point [Duff et al. 2017].
vec3 perpendicular(vec3 n) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    return vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// A unit direction around a unit axis, by its cosine.
vec3 cosine_direction(vec3 axis, vec2 number) {
    float turn = 6.28318530718 * number.y, radius = sqrt(number.x);
    vec3 right = perpendicular(axis);
    return sqrt(1.0 - number.x) * axis + radius * (cos(turn) * right + sin(turn) * cross(axis, right));
}

// A place of a disk around the origin, evenly over its area.
vec3 disk_place(float radius, vec3 right, vec3 up, vec2 place) {
    float turn = 6.28318531 * place.y;
    return radius * sqrt(place.x) * (cos(turn) * right + sin(turn) * up);
}
