// Irradiance of the elements around each pixel's surface that face as it does.
#include "techniques/implicit-visibility/elements.glsl"

layout(location = TARGET_RESULT) out vec4 result;

// Keeps a plane level that few elements tell: variance of their place along the surface, over the squared reach.
const float STIFFNESS = 0.02;


// Sums of a plane's fit to the elements' irradiance over the surface, by weighted least squares.
struct fit {
    vec3 ones;      // weight, and weight times the place along two tangents
    vec3 squares;   // weight times u u, u v, v v
    vec3 value, value_u, value_v;
};

void add_element(surface s, vec3 tangent, vec3 bitangent, int number, inout fit sums) {
    vec3 path;
    float weight = element_weight(s, number, path);
    if (weight <= 0.0)
        return;
    vec3 value = weight * elements[ELEMENT_TEXELS * number + 2].xyz;
    float u = dot(path, tangent), v = dot(path, bitangent);
    sums.ones += weight * vec3(1.0, u, v);
    sums.squares += weight * vec3(u * u, u * v, v * v);
    sums.value += value;
    sums.value_u += u * value;
    sums.value_v += v * value;
}

// The plane's value at the place itself; at most twice the mean, and not below a quarter of it.
vec3 fit_value(fit sums) {
    vec3 mean = sums.value / sums.ones.x;
    vec2 middle = sums.ones.yz / sums.ones.x;
    float uu = sums.squares.x / sums.ones.x - middle.x * middle.x + STIFFNESS;
    float uv = sums.squares.y / sums.ones.x - middle.x * middle.y;
    float vv = sums.squares.z / sums.ones.x - middle.y * middle.y + STIFFNESS;
    float inverse = 1.0 / (uu * vv - uv * uv);
    vec2 toward = inverse * vec2(vv * middle.x - uv * middle.y, uu * middle.y - uv * middle.x);
    vec3 slope_u = sums.value_u / sums.ones.x - middle.x * mean, slope_v = sums.value_v / sums.ones.x - middle.y * mean;
    return clamp(mean - toward.x * slope_u - toward.y * slope_v, 0.25 * mean, 2.0 * mean);
}

void main() {
    result = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    vec3 tangent = normalize(cross(s.normal, abs(s.normal.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 bitangent = cross(s.normal, tangent);
    fit sums = fit(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    for (int k = 0; k < ELEMENT_ROWS; k++) {
        ivec2 row = element_row(s.position, k);
        for (int number = row.x; number < row.y; number++)
            add_element(s, tangent, bitangent, number, sums);
    }
    result = vec4(sums.ones.x > 0.0 ? fit_value(sums) * params.scale : vec3(0.0), 1.0);
}
