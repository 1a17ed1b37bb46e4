// How the G-buffer keeps the specular part of reflection: the reflectance from straight on in rgb, the roughness in a;
// all 0 where a surface is matt. Reflectance is stored as its square root, so that eight bits serve dark ones too.

vec4 gloss_encode(vec4 gloss) {
    return vec4(sqrt(clamp(gloss.rgb, 0.0, 1.0)), gloss.a);
}

vec4 gloss_decode(vec4 code) {
    return vec4(code.rgb * code.rgb, code.a);
}
