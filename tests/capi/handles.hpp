#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "sfumato/sfumato.h"
#include "support/places.hpp"

namespace sfumato::test {

template <class T, void (*kFree)(T*)>
struct Freed {
  void operator()(T* handle) const { kFree(handle); }
};
using ContextHandle =
    std::unique_ptr<sfumato_context, Freed<sfumato_context, sfumato_context_free>>;
using DocumentHandle =
    std::unique_ptr<sfumato_document, Freed<sfumato_document, sfumato_document_free>>;
using PictureHandle =
    std::unique_ptr<sfumato_picture, Freed<sfumato_picture, sfumato_picture_free>>;
using FieldHandle = std::unique_ptr<sfumato_field, Freed<sfumato_field, sfumato_field_free>>;
using WeightsHandle =
    std::unique_ptr<sfumato_weights, Freed<sfumato_weights, sfumato_weights_free>>;
using BytesHandle = std::unique_ptr<sfumato_bytes, Freed<sfumato_bytes, sfumato_bytes_free>>;

inline std::string example(const std::string& name) {
  std::ifstream file(source_path("examples/") + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline DocumentHandle read_text(sfumato_context* context, const std::string& text) {
  sfumato_document* document = nullptr;
  EXPECT_EQ(sfumato_read(context, text.data(), text.size(), "in", nullptr, &document), SFUMATO_OK)
      << sfumato_error_text(context);
  return DocumentHandle(document);
}

inline ContextHandle context_of(const char* options = "threads=2") {
  ContextHandle context(sfumato_context_new(options));
  EXPECT_STREQ(sfumato_error_text(context.get()), "");
  return context;
}

inline PictureHandle solve(sfumato_context* context, const sfumato_document* document,
                           const char* options = nullptr) {
  sfumato_picture* picture = nullptr;
  EXPECT_EQ(sfumato_solve(context, document, options, &picture), SFUMATO_OK)
      << sfumato_error_text(context);
  return PictureHandle(picture);
}

inline std::string text_of(const sfumato_bytes* bytes) {
  return {reinterpret_cast<const char*>(sfumato_bytes_data(bytes)), sfumato_bytes_size(bytes)};
}

/// Returns the document as SVG.
inline std::string written(sfumato_context* context, const sfumato_document* document) {
  sfumato_bytes* bytes = nullptr;
  EXPECT_EQ(sfumato_document_write(context, document, &bytes), SFUMATO_OK);
  return text_of(BytesHandle(bytes).get());
}

/// Returns the bytes of all tables of a picture, one after the other.
inline std::string tables_of(const sfumato_picture* picture) {
  std::string all;
  for (std::uint32_t layer = 0; layer < sfumato_picture_layer_count(picture); ++layer) {
    for (std::uint32_t table = SFUMATO_VERTICES; table <= SFUMATO_OPACITY_VALUES; ++table) {
      sfumato_view view{};
      EXPECT_EQ(sfumato_picture_table(picture, layer, table, &view), SFUMATO_OK);
      all += std::to_string(view.rows) + ' ';
      if (view.rows > 0)
        all.append(static_cast<const char*>(view.data), view.rows * view.row_bytes);
    }
  }
  return all;
}

}  // namespace sfumato::test
