/* Memory of the module for JavaScript, and the structs that web/wasm/library.mjs and sfumato.mjs
   read and write by their bytes. */
#include <stddef.h>
#include <stdlib.h>

#include "sfumato/sfumato.h"

#define EXPORTED(name) __attribute__((export_name(#name)))

_Static_assert(sizeof(sfumato_view) == 20 && offsetof(sfumato_view, rows) == 4 &&
                   offsetof(sfumato_view, row_bytes) == 8 &&
                   offsetof(sfumato_view, columns) == 12 && offsetof(sfumato_view, type) == 16,
               "as Library.table() reads it");
_Static_assert(sizeof(sfumato_image) == 20 && offsetof(sfumato_image, row_bytes) == 4 &&
                   offsetof(sfumato_image, width) == 8 && offsetof(sfumato_image, height) == 12 &&
                   offsetof(sfumato_image, format) == 16,
               "as SfumatoContext.raster() writes it");
_Static_assert(sizeof(sfumato_loader) == 8 && offsetof(sfumato_loader, user) == 4,
               "as SfumatoContext.read() writes it");

EXPORTED(sfumato_allocate) void* sfumato_allocate(size_t byte_count) {
  return malloc(byte_count);
}

EXPORTED(sfumato_free) void sfumato_free(void* memory) {
  free(memory);
}
