/* JPEG by libjpeg: textures. */
#include "base/file/small/small.h"

#include "base/error.h"

#include <setjmp.h>
#include <stdio.h>

#include <jpeglib.h>

struct source {
    struct jpeg_decompress_struct jpeg;
    struct jpeg_error_mgr errors;
    jmp_buf back;
};

static void on_error(j_common_ptr jpeg) {
    struct source *source = (struct source *)jpeg->client_data;
    char message[JMSG_LENGTH_MAX];
    jpeg->err->format_message(jpeg, message);
    error_set("%s", message);
    longjmp(source->back, 1);
}

static void on_message(j_common_ptr jpeg, int level) {
    (void)jpeg, (void)level;
}

static bool read_header(struct source *source, struct raster *raster, const unsigned char *bytes,
                        size_t size) {
    struct jpeg_decompress_struct *jpeg = &source->jpeg;
    if (setjmp(source->back))
        return false;
    jpeg_create_decompress(jpeg);
    jpeg_mem_src(jpeg, bytes, size);
    jpeg_read_header(jpeg, TRUE);
    if (jpeg->num_components != 1 && jpeg->num_components != 3)
        return error_set("a JPEG in CMYK, which this build does not read");
    jpeg->out_color_space = jpeg->num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_calc_output_dimensions(jpeg);
    raster->width = (int)jpeg->output_width;
    raster->height = (int)jpeg->output_height;
    raster->channels = jpeg->output_components;
    return check_picture_size(raster->width, raster->height);
}

static bool read_rows(struct source *source, struct raster *raster) {
    struct jpeg_decompress_struct *jpeg = &source->jpeg;
    size_t row = (size_t)raster->width * (size_t)raster->channels;
    if (setjmp(source->back))
        return false;
    jpeg_start_decompress(jpeg);
    while (jpeg->output_scanline < jpeg->output_height) {
        JSAMPROW at = raster->narrow + jpeg->output_scanline * row;
        jpeg_read_scanlines(jpeg, &at, 1);
    }
    return true;
}

bool jpeg_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only) {
    struct source source;
    *raster = (struct raster){0};
    source.jpeg = (struct jpeg_decompress_struct){.client_data = &source};
    source.jpeg.err = jpeg_std_error(&source.errors);
    source.errors.error_exit = on_error;
    source.errors.emit_message = on_message;
    bool ok = read_header(&source, raster, bytes, size) &&
              (size_only || (raster_alloc(raster) && read_rows(&source, raster)));
    jpeg_destroy_decompress(&source.jpeg);
    if (!ok)
        raster_free(raster);
    return ok;
}
