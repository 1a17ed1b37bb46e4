/* Between the renderer's own files. */
#ifndef RENDERER_VIEWS_H
#define RENDERER_VIEWS_H

#include "renderer/renderer.h"

/* The buffers of views, by what the desc says and for the pass at hand. */
void renderer_write_views(struct renderer *renderer);

/* How the picture is drawn and shown, as the settings have it. */
struct picture_settings renderer_picture(const struct renderer *renderer);

/* A power of two near what all lights could make, inverted: exact to multiply by, and keeps half
 * floats in range whatever the units. */
float renderer_irradiance_scale(const struct renderer *renderer);

/* Ambient occlusion as an output. It is made anew when somebody asks for it after forget. */
extern const struct drawn_output renderer_drawn_ao;
void renderer_forget_ambient_occlusion(struct renderer *renderer);

#endif
