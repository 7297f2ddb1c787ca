#include <gtest/gtest.h>

#include <cstdint>

#include "allocation/failing_allocator.hpp"
#include "sfumato/sfumato.h"

/// The C interface with each allocation of a whole session refused once.
namespace sfumato::test {
namespace {

/// The first code of a session that is not OK, and whether each handle of a failed call was NULL.
struct Session {
  std::int32_t code = SFUMATO_OK;
  bool is_clean = true;

  /// handle: of what the call handed out, which is looked at after it.
  template <class Handle>
  bool take(std::int32_t result, Handle* const* handle) {
    if (code == SFUMATO_OK) code = result;
    is_clean = is_clean && (*handle != nullptr) == (result == SFUMATO_OK);
    return result == SFUMATO_OK;
  }
  bool take(std::int32_t result) {
    if (code == SFUMATO_OK) code = result;
    return result == SFUMATO_OK;
  }
};

constexpr char kDrawing[] =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' "
    "viewBox='0 0 8 8'></svg>";

void use_picture(Session& session, sfumato_context* c, sfumato_document* document) {
  sfumato_picture* picture = nullptr;
  sfumato_bytes* bytes = nullptr;
  const double green[] = {0, 0, 1, 0}, lower[] = {0, 5, 3, 5, 6, 5, 8, 5};
  if (!session.take(sfumato_solve(c, document, "max-error=off", &picture), &picture)) return;
  session.take(sfumato_set_curve_stops(c, document, 0, 0, 0, 0, SFUMATO_STOPS, 0, green, 1));
  session.take(sfumato_solve_again(c, document, 1, picture));
  session.take(sfumato_set_curve_points(c, document, 0, 0, lower, 4));
  session.take(sfumato_solve_again(c, document, 1, picture));
  session.take(sfumato_solve_again(c, document, 0, picture));
  sfumato_view response{};
  session.take(sfumato_stop_response(c, picture, 0, 0, 0, 0, 0, &response));
  std::uint8_t pixels[8 * 8 * 3];
  const sfumato_image image{pixels, 24, 8, 8, SFUMATO_RGB8};
  session.take(sfumato_raster(c, picture, &image, "background=white"));
  session.take(sfumato_export(c, picture, "pdf", "title=\"a b\" background=red", &bytes), &bytes);
  sfumato_bytes_free(bytes);
  session.take(sfumato_viewer_payload(c, picture, "background=red", &bytes), &bytes);
  sfumato_bytes_free(bytes);
  sfumato_picture_free(picture);
}

void use_document(Session& session, sfumato_context* c, sfumato_document* document) {
  const double line[] = {0, 4, 3, 4, 6, 4, 8, 4}, red[] = {0, 1, 0, 0}, at[] = {2, 2};
  float rgba[4];
  sfumato_document* copy = nullptr;
  sfumato_field* field = nullptr;
  session.take(sfumato_insert_curve(c, document, 0, UINT32_MAX, line, 4));
  if (sfumato_curve_count(document, 0) == 0) return;
  session.take(sfumato_set_curve_stops(c, document, 0, 0, 0, 0, SFUMATO_STOPS, 0, red, 1));
  session.take(sfumato_document_copy(c, document, &copy), &copy);
  sfumato_document_free(copy);
  sfumato_bytes* json = nullptr;
  session.take(sfumato_lint(c, document, "verbose", &json), &json);
  sfumato_bytes_free(json);
  if (session.take(sfumato_field_new(c, document, 0, nullptr, &field), &field)) {
    session.take(sfumato_field_colors(c, field, at, 1, rgba));
    sfumato_field_free(field);
  }
  use_picture(session, c, document);
}

/// Pixels for a file that no document has.
void add_image(Session& session, sfumato_context* c) {
  const char file[] = "some file";
  std::uint8_t pixels[4] = {};
  const sfumato_image image{pixels, 4, 1, 1, SFUMATO_RGBA8};
  session.take(sfumato_add_image(c, file, sizeof file, &image));
  session.take(sfumato_add_image(c, file, sizeof file, nullptr));
}

Session run(sfumato_context* c) {
  Session session;
  add_image(session, c);
  sfumato_document *document = nullptr, *read = nullptr;
  session.take(sfumato_read(c, kDrawing, sizeof kDrawing - 1, "in", nullptr, &read), &read);
  sfumato_document_free(read);
  if (session.take(sfumato_document_new(c, "artboard=0,0,8,8", &document), &document)) {
    use_document(session, c, document);
    sfumato_document_free(document);
  }
  return session;
}

TEST(CAllocation, each_refusal_is_told_and_survived) {
  sfumato_context* c = sfumato_context_new("threads=1");
  ASSERT_NE(c, nullptr);
  for (int i = 0; i < 2; ++i) ASSERT_EQ(run(c).code, SFUMATO_OK) << sfumato_error_text(c);
  std::size_t told = 0;
  for (const Refusal refusal : {Refusal::one, Refusal::all_from}) {
    bool was_refused = true;
    for (std::size_t k = 0; was_refused; ++k) {
      Session session;
      {
        const RefusedAllocations refused(k, refusal);
        session = run(c);
        was_refused = RefusedAllocations::requests() > k;
      }
      ASSERT_TRUE(session.is_clean) << k;
      ASSERT_TRUE(session.code == SFUMATO_OK || session.code == SFUMATO_OUT_OF_MEMORY)
          << k << ": " << session.code << ' ' << sfumato_error_text(c);
      told += session.code == SFUMATO_OUT_OF_MEMORY ? 1 : 0;
    }
  }
  EXPECT_GT(told, 100u);
  RecordProperty("told", static_cast<int>(told));
  ASSERT_EQ(run(c).code, SFUMATO_OK);
  sfumato_context_free(c);
}

TEST(CAllocation, a_context_is_there_or_null) {
  bool was_refused = true;
  for (std::size_t k = 0; was_refused; ++k) {
    sfumato_context* c = nullptr;
    {
      const RefusedAllocations refused(k, Refusal::one);
      c = sfumato_context_new("threads=1 limit.curves=3 max-time=5");
      was_refused = RefusedAllocations::requests() > k;
    }
    if (c) {
      EXPECT_STREQ(sfumato_error_text(c), "") << k;
    }
    sfumato_context_free(c);
  }
}

}  // namespace
}  // namespace sfumato::test
