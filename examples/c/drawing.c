/* The program of docs/c-api.md: draws a sky over land and writes it as PNG. */
#include <sfumato/sfumato.h>
#include <stdio.h>

/* From edge to edge; on the screen its left side is above. */
static const double horizon[] = {-20, 210, 130, 180, 270, 240, 420, 210};
/* Rows of an offset along the curve, red, green, blue. */
static const double sky[] = {0, 0.97, 0.80, 0.85, 1, 1.00, 0.60, 0.40};
static const double land[] = {0, 0.11, 0.17, 0.12};

static int32_t draw(sfumato_context* c, sfumato_document** d, sfumato_picture** p,
                    sfumato_bytes** png) {
  int32_t failed = sfumato_document_new(c, "artboard=0,0,400,300", d);
  if (!failed) failed = sfumato_insert_curve(c, *d, 0, UINT32_MAX, horizon, 4);
  if (!failed)
    failed = sfumato_set_curve_stops(c, *d, 0, 0, SFUMATO_LEFT, SFUMATO_COLOR, SFUMATO_STOPS,
                                     SFUMATO_ARC_LENGTH, sky, 2);
  if (!failed)
    failed = sfumato_set_curve_stops(c, *d, 0, 0, SFUMATO_RIGHT, SFUMATO_COLOR, SFUMATO_STOPS,
                                     SFUMATO_ARC_LENGTH, land, 1);
  if (!failed) failed = sfumato_solve(c, *d, "width=1200", p);
  if (!failed) failed = sfumato_export(c, *p, "png", "width=1200", png);
  return failed;
}

int main(void) {
  sfumato_context* c = sfumato_context_new("max-memory=1000");
  sfumato_document* d = NULL;
  sfumato_picture* p = NULL;
  sfumato_bytes* png = NULL;
  int32_t failed = draw(c, &d, &p, &png);
  if (failed) fprintf(stderr, "%s\n", sfumato_error_text(c));
  FILE* file = failed ? NULL : fopen("horizon.png", "wb");
  if (file) {
    fwrite(sfumato_bytes_data(png), 1, sfumato_bytes_size(png), file);
    failed = fclose(file);
  }
  sfumato_bytes_free(png);
  sfumato_picture_free(p);
  sfumato_document_free(d);
  sfumato_context_free(c);
  return failed || !file ? 1 : 0;
}
