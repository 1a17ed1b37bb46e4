#include "viewer/free_number.h"

#include "base/error.h"

int free_number(enum name_state (*state_of)(void *user, int number), void *user) {
    for (int number = 1; number <= FREE_NUMBER_MOST; number++) {
        enum name_state state = state_of(user, number);
        if (state != NAME_IS_TAKEN)
            return state == NAME_IS_FREE ? number : 0;
    }
    error_set("all numbers up to %d are taken in this folder: move files out of it",
              FREE_NUMBER_MOST);
    return 0;
}
