flat in vec4 place;

layout(location = 0) out vec4 extremes; // max s, max t, -min s, -min t

void main() {
    extremes = place;
}
