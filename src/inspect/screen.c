#include "inspect/screen.h"

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "shared/inspect.h"

#include <math.h>

bool screen_init(struct screen *screen) {
    *screen = (struct screen){0};
    if (program_init(&screen->program, &(struct program_desc){.vertex = "fullscreen.vert",
                                                              .fragment = "inspect/screen.frag"}) &&
        buffer_init(&screen->params, "screen parameters", sizeof(struct screen_params), NULL))
        return true;
    screen_free(screen);
    return false;
}

void screen_free(struct screen *screen) {
    program_free(&screen->program);
    buffer_free(&screen->params);
}

struct rectangle screen_fit(struct rectangle area, int width, int height) {
    double scale = fmin((double)area.width / width, (double)area.height / height);
    struct rectangle fit = {0, 0, (int)lround(width * scale), (int)lround(height * scale)};
    if (fit.width < 1)
        fit.width = 1;
    if (fit.height < 1)
        fit.height = 1;
    fit.x = area.x + (area.width - fit.width) / 2;
    fit.y = area.y + (area.height - fit.height) / 2;
    return fit;
}

/* Into a rectangle, of which parts may lie outside of the window. */
static void draw(const struct screen *screen, int bottom, const struct rectangle *target,
                 const struct screen_pictures *pictures) {
    const struct texture *right = pictures->right ? pictures->right : pictures->left;
    struct screen_params params = {
        .corner = {(float)target->x, (float)bottom},
        .size = {(float)target->width, (float)target->height},
        .split = pictures->right ? pictures->split : 2,
        .difference = pictures->right && pictures->layout == SCREEN_DIFFERENCE,
    };
    buffer_write(&screen->params, 0, sizeof params, &params);
    pass_set_state(&(struct pass_state){
        .name = "screen",
        .program = screen->program,
        .window = true,
        .x = target->x,
        .y = bottom,
        .width = target->width,
        .height = target->height,
        .textures = {{UNIT_LEFT_PICTURE, pictures->left->id}, {UNIT_RIGHT_PICTURE, right->id}},
        .blocks = {{BLOCK_PASS, &screen->params}},
    });
}

void screen_draw(const struct screen *screen, int window_height, const struct rectangle *target,
                 const struct screen_pictures *pictures) {
    static const float around[4] = {.055F, .059F, .07F, 1};
    int bottom = window_height - target->y - target->height;
    struct screen_pictures one = *pictures, other = {.left = pictures->right};
    bool beside = pictures->right && pictures->layout == SCREEN_BESIDE;
    one.right = beside ? NULL : pictures->right;
    draw(screen, bottom, target, &one);
    framebuffer_clear_color(0, TARGET_RESULT, around);
    if (pictures->left->id)
        pass_draw_fullscreen(1);
    if (!beside)
        return;
    struct rectangle second = *target;
    second.x += pictures->beside;
    draw(screen, bottom, &second, &other);
    pass_draw_fullscreen(1);
}
