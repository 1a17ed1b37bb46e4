/* Functions shared by the renderer's files. */
#ifndef RENDERER_VIEWS_H
#define RENDERER_VIEWS_H

#include "renderer/renderer.h"
#include "scene/medium.h"

/* True if the G-buffer, and all that reads it, has a specular target: else all materials are plain
 * (scene/material.h). */
bool renderer_has_specular(const struct renderer_desc *desc);

/* Returns the medium of a frame. */
struct medium renderer_medium(const struct renderer_desc *desc);

/* Writes the view buffers for renderer->desc and the current pass. */
void renderer_write_views(struct renderer *renderer);

/* Returns the picture's settings. */
struct picture_settings renderer_picture(const struct renderer *renderer);

/* Returns a power of two near the inverse of all lights' greatest irradiance. It multiplies exactly
 * and keeps half floats in range in any units. */
float renderer_irradiance_scale(const struct renderer *renderer);

/* Ambient occlusion as an output. After a call of `forget` the next request makes it again. */
extern const struct drawn_output renderer_drawn_ao;
void renderer_forget_ambient_occlusion(struct renderer *renderer);

#endif
