#include "renderer/sky_pieces.h"

#include "base/memory.h"
#include "base/unit.h"
#include "shared/sky.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

/* Of a door's sides, over the domain's: a cell of the importance map. */
static const float least_door = 1.F / VPL_DENSITY_SIDE;

bool sky_pieces_init(struct texture *pieces) {
    return texture_init(pieces, &(struct texture_desc){.label = "pieces of a sky",
                                                       .format = GL_RGBA32F,
                                                       .width = SKY_ROW_TEXELS,
                                                       .height = LIGHTS_MAX});
}

/* What all pieces of a group share. */
struct group {
    const struct sky_door *door;
    const struct emitter *sample; /* of the group, with its view and measure */
    const struct view *view;
    float measure;
    float door_place[2];
};

/* Turned as little from the group's as its direction lets; as it is where that is across. */
static void turn_like(struct emitter *piece, const struct emitter *sample) {
    const float least = 1e-3F;
    vec3 right;
    glm_vec3_copy((float *)sample->right, right);
    glm_vec3_muladds(piece->direction, -glm_vec3_dot(right, piece->direction), right);
    if (glm_vec3_norm(right) < least)
        return;
    vec3_unit_to(right, piece->right);
    glm_vec3_cross(piece->right, piece->direction, piece->up);
}

/* In the view's rectangle, from 0 to 1. */
static void place_of(const struct view *view, const float point[3], float place[2]) {
    vec3 from;
    glm_vec3_sub((float *)point, (float *)view->origin, from);
    for (int c = 0; c < 2; c++) {
        float *side = (float *)(c ? view->up : view->right);
        place[c] = .5F + .5F * glm_vec3_dot(from, side) / glm_vec3_norm2(side);
    }
}

static struct sky_piece piece_of(const struct emitter *emitter, const struct group *group,
                                 const struct geometry *geometry) {
    struct view view;
    struct sky_piece piece = {0};
    float door[2];
    view_of_directional(&view, emitter, geometry);
    place_of(&view, group->door->position, door);
    piece.area = 4 * glm_vec3_norm(view.right) * glm_vec3_norm(view.up) / group->measure;
    glm_vec3_copy(view.origin, piece.origin);
    glm_vec3_copy(view.right, piece.right);
    glm_vec3_copy(view.up, piece.up);
    glm_vec3_copy((float *)emitter->intensity, piece.intensity);
    if (group->door->radius > 0) {
        piece.shift_x = door[0] - group->door_place[0];
        piece.shift_y = door[1] - group->door_place[1];
    }
    return piece;
}

static void set_door(struct sky_row *row, const struct group *group) {
    for (int c = 0; c < 2; c++) {
        float half = .5F * group->door->radius /
                     glm_vec3_norm((float *)(c ? group->view->up : group->view->right));
        float low = glm_clamp(group->door_place[c] - half, 0, 1 - least_door),
              high = fminf(group->door_place[c] + half, 1);
        row->door[c] = half > 0 ? low : 0;
        row->door_size[c] = half > 0 ? fmaxf(high - low, least_door) : 1;
    }
}

static void fill_row(struct sky_row *row, const struct renderer *renderer, int index, int first) {
    const struct light *light = &renderer->sample_block->sources[index];
    const struct sky_groups *groups = &renderer->plan.sky_samples;
    struct group group = {.door = &groups->doors[index - first],
                          .sample = &renderer->light_samples.items[index],
                          .view = &renderer->sample_block->views[light->first_view].view,
                          .measure = light->measure};
    place_of(group.view, group.door->position, group.door_place);
    set_door(row, &group);
    for (int k = 0; k < SKY_PIECES; k++) {
        float place[2];
        light_samples_choose_place(place, k, SKY_PIECES, renderer->pass);
        struct emitter piece = sky_group_piece(&renderer->plan.sky, groups, index - first,
                                               renderer->light_samples.sky, place);
        turn_like(&piece, group.sample);
        row->pieces[k] = piece_of(&piece, &group, renderer->desc.geometry);
    }
}

void sky_pieces_write(const struct renderer *renderer) {
    const struct texture *pieces = &renderer->sky_pieces;
    int count = renderer->light_samples.count,
        first = count - (renderer->light_samples.sky ? renderer->plan.sky_samples.count : 0);
    if (first == count)
        return;
    struct sky_row *rows = mem_alloc((size_t)count, sizeof *rows);
    for (int i = first; i < count; i++)
        fill_row(&rows[i], renderer, i, first);
    gl.TextureSubImage2D(pieces->id, 0, 0, 0, pieces->desc.width, count, GL_RGBA, GL_FLOAT, rows);
    free(rows);
}
