/* A C99 program that uses the C interface from end to end. Exits with 0 if all its checks hold. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sfumato/sfumato.h"

static int failures = 0;

#define CHECK(condition)                                     \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("line %d: not so: %s\n", __LINE__, #condition); \
      ++failures;                                            \
    }                                                        \
  } while (0)

/* Makes a line across the artboard, red above and blue below. Its ends lie outside and are soft, so
 * the other
 * * colour shows a little. */
static sfumato_document* two_halves(sfumato_context* context) {
  const double line[8] = {-8, 32, 16, 32, 48, 32, 72, 32};
  const double red[4] = {0, 1, 0, 0}, blue[4] = {0, 0, 0, 1};
  sfumato_document* document = NULL;
  CHECK(sfumato_document_new(context, "artboard=0,0,64,64", &document) == SFUMATO_OK);
  CHECK(sfumato_insert_curve(context, document, 0, UINT32_MAX, line, 4) == SFUMATO_OK);
  CHECK(sfumato_set_curve_stops(context, document, 0, 0, SFUMATO_LEFT, SFUMATO_COLOR, SFUMATO_STOPS,
                                SFUMATO_ARC_LENGTH, red, 1) == SFUMATO_OK);
  CHECK(sfumato_set_curve_stops(context, document, 0, 0, SFUMATO_RIGHT, SFUMATO_COLOR,
                                SFUMATO_STOPS, SFUMATO_ARC_LENGTH, blue, 1) == SFUMATO_OK);
  return document;
}

static void pixels_are_those_of_the_sides(sfumato_context* context,
                                          const sfumato_picture* picture) {
  unsigned char pixels[8 * 40];
  const sfumato_image image = {pixels, 40, 8, 8, SFUMATO_RGBA8};
  memset(pixels, 7, sizeof pixels);
  CHECK(sfumato_raster(context, picture, &image, NULL) == SFUMATO_OK);
  CHECK(pixels[0] > 240 && pixels[1] == 0 && pixels[2] < 15 && pixels[3] == 255);
  CHECK(pixels[7 * 40] < 15 && pixels[7 * 40 + 2] > 240);
  CHECK(pixels[32] == 7 && pixels[39] == 7); /* between rows */
}

static void the_field_has_the_colours_of_the_sides(sfumato_context* context,
                                                   const sfumato_document* document) {
  const double points[4] = {20, 10, 20, 60};
  float rgba[8];
  sfumato_field* field = NULL;
  CHECK(sfumato_field_new(context, document, 0, "scale=2", &field) == SFUMATO_OK);
  CHECK(sfumato_field_colors(context, field, points, 2, rgba) == SFUMATO_OK);
  CHECK(rgba[0] > 0.95f && rgba[2] < 0.05f && rgba[3] == 1);
  CHECK(rgba[4] < 0.05f && rgba[6] > 0.95f && rgba[7] == 1);
  sfumato_field_free(field);
}

static void files_begin_as_their_formats_do(sfumato_context* context,
                                            const sfumato_picture* picture) {
  const char* const formats[] = {"png", "html", "pdf", "eps", "svg", "glb"};
  const char* const begins[] = {"\x89PNG", "<!", "%PDF", "%!PS", "<", "glTF"};
  size_t i;
  for (i = 0; i < sizeof formats / sizeof *formats; ++i) {
    sfumato_bytes* file = NULL;
    CHECK(sfumato_export(context, picture, formats[i], "", &file) == SFUMATO_OK);
    CHECK(sfumato_bytes_size(file) > 100);
    CHECK(memcmp(sfumato_bytes_data(file), begins[i], strlen(begins[i])) == 0);
    sfumato_bytes_free(file);
  }
}

static void an_edit_shows_after_solving_again(sfumato_context* context, sfumato_document* document,
                                              sfumato_picture* picture) {
  const double green[4] = {0, 0, 1, 0};
  unsigned char pixel[3];
  const sfumato_image image = {pixel, 3, 1, 1, SFUMATO_RGB8};
  CHECK(sfumato_set_curve_stops(context, document, 0, 0, SFUMATO_LEFT, SFUMATO_COLOR, SFUMATO_STOPS,
                                SFUMATO_ARC_LENGTH, green, 1) == SFUMATO_OK);
  CHECK(sfumato_solve_again(context, document, 0, picture) == SFUMATO_OK);
  CHECK(sfumato_raster(context, picture, &image, "viewport=0,0,4,4") == SFUMATO_OK);
  CHECK(pixel[0] == 0 && pixel[1] > 240);
}

int main(void) {
  sfumato_context* context = sfumato_context_new("threads=2 max-memory=500");
  sfumato_document* document = two_halves(context);
  sfumato_picture* picture = NULL;
  CHECK(sfumato_abi() == SFUMATO_ABI);
  CHECK(sfumato_solve(context, document, "max-error=1", &picture) == SFUMATO_OK);
  pixels_are_those_of_the_sides(context, picture);
  the_field_has_the_colours_of_the_sides(context, document);
  files_begin_as_their_formats_do(context, picture);
  an_edit_shows_after_solving_again(context, document, picture);
  sfumato_context_free(context); /* first: the order is free */
  sfumato_picture_free(picture);
  sfumato_document_free(document);
  printf("%d failures\n", failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
