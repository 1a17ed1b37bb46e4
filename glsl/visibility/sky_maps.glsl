// Which layers of the array have a light's map: the suns, which are the first SUNS lights, have SUN_MAPS^2 each, row by
// row; each other has one.
const int OF_SUN = SUN_MAPS * SUN_MAPS;

struct sky_maps_of {
    int light, first, side; // the first layer; maps a side
};

int light_of_layer(int layer) {
    return layer < SUNS * OF_SUN ? layer / OF_SUN : layer - SUNS * (OF_SUN - 1);
}

sky_maps_of sky_maps_at(int light) {
    return light < SUNS ? sky_maps_of(light, light * OF_SUN, SUN_MAPS)
                        : sky_maps_of(light, light + SUNS * (OF_SUN - 1), 1);
}
