// Which of the 3 x 3 pixels around it a pixel's samples take their shading from: four bits a sample.
// 0 is the pixel itself, 1 .. 8 its neighbours, PICK_EDGE_SAMPLE its edge sample, PICK_NOTHING where the sample sees
// no surface.
const uint PICK_EDGE_SAMPLE = 9u;
const uint PICK_NOTHING = 15u;

// Row by row, the pixel itself taken out of its place and put first.
ivec2 pick_offset(uint pick) {
    int at = pick == 0u ? 4 : int(pick) - (pick <= 4u ? 1 : 0);
    return ivec2(at % 3, at / 3) - 1;
}

uint pick_of(uvec2 picks, int index) {
    return picks[index / 8] >> uint(4 * (index % 8)) & 15u;
}

// Whether any of the samples does: one of the fours of bits is zero without PICK_EDGE_SAMPLE, and borrows.
bool picks_edge_sample(uvec2 picks) {
    uvec2 others = picks ^ 0x11111111u * PICK_EDGE_SAMPLE;
    return ((others - 0x11111111u) & ~others & 0x88888888u) != uvec2(0u);
}
