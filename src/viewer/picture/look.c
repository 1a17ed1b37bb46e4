#include "viewer/picture/look.h"

#include "viewer/picture/legend.h"
#include "viewer/picture/picture.h"

#include <math.h>

/* The size that it is shown in: one that was rendered smaller, in the full one; sheets have their
 * own. */
static void size_of(const struct viewer *viewer, int *width, int *height) {
    const struct renderer_desc *desc = &viewer->shown.renderer.desc;
    *width = viewer->shown.left->desc.width;
    *height = viewer->shown.left->desc.height;
    if (*width == desc->width && *height == desc->height)
        viewer_full_size(viewer, width, height);
}

/* Of the window, what one picture may take. */
static struct rectangle room_of(const struct viewer *viewer) {
    struct rectangle room = viewer->shown.area;
    room.height -= (int)legend_height(viewer);
    if (look_is_beside(viewer))
        room.width /= 2;
    return room;
}

bool look_is_beside(const struct viewer *viewer) {
    return viewer->look.layout == SCREEN_BESIDE && viewer->shown.right;
}

static double fitting_zoom(const struct viewer *viewer) {
    struct rectangle room = room_of(viewer);
    int width, height;
    size_of(viewer, &width, &height);
    return fmin((double)room.width / width, (double)room.height / height);
}

double look_zoom(const struct viewer *viewer) {
    return viewer->look.zoom > 0 ? viewer->look.zoom : fitting_zoom(viewer);
}

void look_place(struct viewer *viewer) {
    const struct look *look = &viewer->look;
    struct rectangle room = room_of(viewer), *picture = &viewer->shown.picture;
    int width, height;
    size_of(viewer, &width, &height);
    *picture = screen_fit(room, width, height);
    if (look->zoom > 0) {
        picture->width = (int)lround(width * look->zoom);
        picture->height = (int)lround(height * look->zoom);
        picture->x = room.x + room.width / 2 - (int)lround(look->middle[0] * picture->width);
        picture->y = room.y + room.height / 2 - (int)lround(look->middle[1] * picture->height);
    }
    viewer->shown.room = room;
}

bool look_at_mouse(const struct viewer *viewer, float *x, float *y) {
    const struct rectangle *picture = &viewer->shown.picture, *room = &viewer->shown.room;
    double left = viewer->host.input->x;
    if (look_is_beside(viewer) && left >= room->x + room->width)
        left -= room->width;
    *x = (float)((left - picture->x) / picture->width);
    *y = (float)((viewer->host.input->y - picture->y) / picture->height);
    return *x >= 0 && *y >= 0 && *x < 1 && *y < 1;
}

void look_enlarge(struct viewer *viewer, double zoom) {
    struct look *look = &viewer->look;
    if (look->zoom <= 0)
        look->middle[0] = look->middle[1] = .5;
    look->zoom = zoom <= fitting_zoom(viewer) ? 0 : fmin(zoom, LOOK_ZOOM_MOST);
}

/* What is under the mouse stays there. */
static void zoom_to(struct viewer *viewer, double zoom) {
    struct look *look = &viewer->look;
    const struct rectangle *room = &viewer->shown.room;
    float x, y;
    int width, height;
    look_at_mouse(viewer, &x, &y);
    size_of(viewer, &width, &height);
    double off_x = (double)x * viewer->shown.picture.width + viewer->shown.picture.x -
                   (room->x + room->width / 2);
    double off_y = (double)y * viewer->shown.picture.height + viewer->shown.picture.y -
                   (room->y + room->height / 2);
    look->zoom = zoom;
    look->middle[0] = (double)x - off_x / (width * zoom);
    look->middle[1] = (double)y - off_y / (height * zoom);
}

void look_scroll(struct viewer *viewer, double steps) {
    double zoom = fmin(look_zoom(viewer) * pow(1.25, steps), LOOK_ZOOM_MOST);
    if (zoom <= fitting_zoom(viewer))
        viewer->look.zoom = 0;
    else
        zoom_to(viewer, zoom);
}

void look_toggle(struct viewer *viewer) {
    if (!viewer->shown.left)
        return;
    if (viewer->look.zoom > 0)
        viewer->look.zoom = 0;
    else
        zoom_to(viewer, 1);
}

void look_drag(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    struct look *look = &viewer->look;
    if (look->zoom <= 0)
        return;
    look->middle[0] -= input->dx / viewer->shown.picture.width;
    look->middle[1] -= input->dy / viewer->shown.picture.height;
    for (int i = 0; i < 2; i++)
        look->middle[i] = fmin(fmax(look->middle[i], 0), 1);
}

void look_step_layout(struct viewer *viewer) {
    viewer->look.layout = (enum screen_layout)((viewer->look.layout + 1) % SCREEN_LAYOUTS);
    viewer->look.zoom = 0;
}
