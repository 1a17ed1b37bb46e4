// Nothing is between a receiver and a sample of the near field.
const bool NEAR_IS_TESTED = false;

bool is_between(surface s, near_arrival representative, bool any) {
    return false;
}
