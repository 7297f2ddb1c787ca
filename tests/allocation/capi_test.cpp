#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>

#include "allocation/failing_allocator.hpp"
#include "sfumato/sfumato.h"

/// The C interface with each allocation of a session refused once. There are several short
/// sessions, because the number of calls grows with the square of a session's length.
namespace sfumato::test {
namespace {

/// The first code of a session that is not OK, and whether each failed call left its handle NULL.
struct Session {
  std::int32_t code = SFUMATO_OK;
  bool is_clean = true;

  /// handle: the handle that the call returns; examined after the call.
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

/// The start of a session: a document of one curve, and its picture if required.
struct Drawing {
  sfumato_document* document = nullptr;
  sfumato_picture* picture = nullptr;

  Drawing() = default;
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing() {
    sfumato_picture_free(picture);
    sfumato_document_free(document);
  }
};

void begin_nothing(Session&, sfumato_context*, Drawing&) {}

void begin_document(Session& session, sfumato_context* c, Drawing& drawing) {
  const double line[] = {0, 4, 3, 4, 6, 4, 8, 4}, red[] = {0, 1, 0, 0};
  sfumato_document*& document = drawing.document;
  if (!session.take(sfumato_document_new(c, "artboard=0,0,8,8", &document), &document)) return;
  if (!session.take(sfumato_insert_curve(c, document, 0, UINT32_MAX, line, 4))) return;
  session.take(sfumato_set_curve_stops(c, document, 0, 0, 0, 0, SFUMATO_STOPS, 0, red, 1));
}

void solve(Session& session, sfumato_context* c, Drawing& drawing) {
  session.take(sfumato_solve(c, drawing.document, "max-error=off", &drawing.picture),
               &drawing.picture);
}

void begin_picture(Session& session, sfumato_context* c, Drawing& drawing) {
  begin_document(session, c, drawing);
  if (drawing.document) solve(session, c, drawing);
}

/// Adds pixels for a file that no document has, and reads a document.
void read(Session& session, sfumato_context* c, Drawing& drawing) {
  const char file[] = "some file";
  std::uint8_t pixels[4] = {};
  const sfumato_image image{pixels, 4, 1, 1, SFUMATO_RGBA8};
  session.take(sfumato_add_image(c, file, sizeof file, &image));
  session.take(sfumato_add_image(c, file, sizeof file, nullptr));
  session.take(sfumato_read(c, kDrawing, sizeof kDrawing - 1, "in", nullptr, &drawing.document),
               &drawing.document);
}

void look(Session& session, sfumato_context* c, Drawing& drawing) {
  sfumato_document* copy = nullptr;
  session.take(sfumato_document_copy(c, drawing.document, &copy), &copy);
  sfumato_document_free(copy);
  sfumato_bytes* json = nullptr;
  session.take(sfumato_lint(c, drawing.document, "verbose", &json), &json);
  sfumato_bytes_free(json);
  const double at[] = {2, 2};
  float rgba[4];
  sfumato_field* field = nullptr;
  if (session.take(sfumato_field_new(c, drawing.document, 0, nullptr, &field), &field)) {
    session.take(sfumato_field_colors(c, field, at, 1, rgba));
    sfumato_field_free(field);
  }
  sfumato_weights* weights = nullptr;
  if (session.take(sfumato_weights_new(c, drawing.document, 0, 0, nullptr, &weights), &weights)) {
    session.take(sfumato_weights_at(c, weights, at, 1, 0));
    sfumato_weights_free(weights);
  }
}

void change_colors(Session& session, sfumato_context* c, Drawing& drawing) {
  const double green[] = {0, 0, 1, 0};
  session.take(
      sfumato_set_curve_stops(c, drawing.document, 0, 0, 0, 0, SFUMATO_STOPS, 0, green, 1));
  session.take(sfumato_solve_again(c, drawing.document, 1, drawing.picture));
}

void begin_colors(Session& session, sfumato_context* c, Drawing& drawing) {
  begin_picture(session, c, drawing);
  change_colors(session, c, drawing);
}

void lay_curve(Session& session, sfumato_context* c, Drawing& drawing, double y) {
  const double points[] = {0, y, 3, y, 6, y, 8, y};
  session.take(sfumato_set_curve_points(c, drawing.document, 0, 0, points, 4));
}

void move_curve(Session& session, sfumato_context* c, Drawing& drawing) {
  lay_curve(session, c, drawing, 5);
  session.take(sfumato_solve_again(c, drawing.document, 1, drawing.picture));
}

void begin_move(Session& session, sfumato_context* c, Drawing& drawing) {
  begin_colors(session, c, drawing);
  move_curve(session, c, drawing);
}

/// Makes another frame without time, and then the rest.
void hurry(Session& session, sfumato_context* c, Drawing& drawing) {
  lay_curve(session, c, drawing, 4);
  session.take(sfumato_solve_within(c, drawing.document, 0, drawing.picture));
  session.take(sfumato_solve_within(c, drawing.document, 0, drawing.picture));
}

void begin_film(Session& session, sfumato_context* c, Drawing& drawing) {
  begin_document(session, c, drawing);
  if (!drawing.document) return;
  session.take(sfumato_solve(c, drawing.document, "max-error=off coherent", &drawing.picture),
               &drawing.picture);
}

void make_next_frame(Session& session, sfumato_context* c, Drawing& drawing) {
  lay_curve(session, c, drawing, 5);
  session.take(sfumato_solve_next(c, drawing.document, drawing.picture));
}

void insert_another(Session& session, sfumato_context* c, Drawing& drawing) {
  const double points[] = {0, 2, 3, 2, 6, 2, 8, 2}, blue[] = {0, 0, 0, 1};
  sfumato_document* const document = drawing.document;
  if (!session.take(sfumato_insert_curve(c, document, 0, UINT32_MAX, points, 4))) return;
  session.take(sfumato_set_curve_stops(c, document, 0, 1, 0, 0, SFUMATO_STOPS, 0, blue, 1));
}

/// Makes a rough picture, and starts a drag from it.
void move_two(Session& session, sfumato_context* c, Drawing& drawing) {
  insert_another(session, c, drawing);
  session.take(sfumato_solve_again(c, drawing.document, 1, drawing.picture));
  move_curve(session, c, drawing);
}

void end_changes(Session& session, sfumato_context* c, Drawing& drawing) {
  session.take(sfumato_solve_again(c, drawing.document, 0, drawing.picture));
  sfumato_view response{};
  session.take(sfumato_stop_response(c, drawing.picture, 0, 0, 0, 0, 0, &response));
}

void show(Session& session, sfumato_context* c, Drawing& drawing) {
  std::uint8_t pixels[8 * 8 * 3];
  const sfumato_image image{pixels, 24, 8, 8, SFUMATO_RGB8};
  session.take(sfumato_raster(c, drawing.picture, &image, "background=white"));
  sfumato_bytes* bytes = nullptr;
  session.take(sfumato_export(c, drawing.picture, "pdf", "title=\"a b\" background=red", &bytes),
               &bytes);
  sfumato_bytes_free(bytes);
  session.take(sfumato_viewer_payload(c, drawing.picture, "background=red", &bytes), &bytes);
  sfumato_bytes_free(bytes);
  session.take(sfumato_picture_stack(c, drawing.picture, "background=red", &bytes), &bytes);
  sfumato_bytes_free(bytes);
  session.take(sfumato_exact_layer(c, drawing.picture, 0, &bytes), &bytes);
  sfumato_bytes_free(bytes);
}

void keep(Session& session, sfumato_context* c, Drawing& drawing) {
  sfumato_bytes* bytes = nullptr;
  if (session.take(sfumato_picture_write(c, drawing.picture, &bytes), &bytes)) {
    sfumato_picture* again = nullptr;
    session.take(
        sfumato_picture_read(c, sfumato_bytes_data(bytes), sfumato_bytes_size(bytes), &again),
        &again);
    sfumato_picture_free(again);
  }
  sfumato_bytes_free(bytes);
}

void write_reached(void* user, const sfumato_trace_state*, const sfumato_document* drawing) {
  sfumato_bytes* bytes = nullptr;
  sfumato_document_write(static_cast<sfumato_context*>(user), drawing, &bytes);
  sfumato_bytes_free(bytes);
}

/// Traces black beside white, with a callback after each round.
void trace(Session& session, sfumato_context* c, Drawing& drawing) {
  std::uint8_t pixels[3 * 8 * 8] = {};
  for (int i = 0; i < 8 * 8; ++i) {
    const int x = i % 8;
    for (int channel = 0; channel < 3; ++channel) pixels[3 * i + channel] = x < 4 ? 0 : 255;
  }
  const sfumato_image image{pixels, 24, 8, 8, SFUMATO_RGB8};
  const sfumato_trace_watch watch{write_reached, c};
  session.take(sfumato_trace(c, &image, "points=40 edges-only", &watch, &drawing.document),
               &drawing.document);
}

using Calls = void (*)(Session&, sfumato_context*, Drawing&);

struct Part {
  const char* name;
  Calls begin;  ///< calls without refusals
  Calls calls;
};

/// Which request of a session's calls to refuse, and, afterwards, whether it was made.
struct Refused {
  std::size_t k = 0;
  Refusal refusal = Refusal::one;
  bool was_refused = false;
};

/// Runs a session; null: without refusals. The session's objects are freed while memory is refused.
Session run(const Part& part, sfumato_context* c, Refused* refused) {
  Session session;
  std::optional<RefusedAllocations> refusing;
  Drawing drawing;
  part.begin(session, c, drawing);
  if (session.code != SFUMATO_OK) return session;
  if (refused) refusing.emplace(refused->k, refused->refusal);
  part.calls(session, c, drawing);
  if (refused) refused->was_refused = RefusedAllocations::requests() > refused->k;
  return session;
}

class CAllocation : public testing::TestWithParam<Part> {};

TEST_P(CAllocation, each_refusal_is_told_and_survived) {
  const Part& part = GetParam();
  sfumato_context* c = sfumato_context_new("threads=1");
  ASSERT_NE(c, nullptr);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(run(part, c, nullptr).code, SFUMATO_OK) << sfumato_error_text(c);
  }
  int told = 0;
  for (const Refusal refusal : {Refusal::one, Refusal::all_from}) {
    Refused refused{0, refusal, true};
    for (; refused.was_refused; ++refused.k) {
      refused.was_refused = false;
      const Session session = run(part, c, &refused);
      ASSERT_TRUE(session.is_clean) << refused.k;
      ASSERT_TRUE(session.code == SFUMATO_OK || session.code == SFUMATO_OUT_OF_MEMORY)
          << refused.k << ": " << session.code << ' ' << sfumato_error_text(c);
      told += session.code == SFUMATO_OUT_OF_MEMORY ? 1 : 0;
    }
  }
  EXPECT_GT(told, 20);
  RecordProperty("told", told);
  ASSERT_EQ(run(part, c, nullptr).code, SFUMATO_OK);
  sfumato_context_free(c);
}

INSTANTIATE_TEST_SUITE_P(Of, CAllocation,
                         testing::Values(Part{"reading", begin_nothing, read},
                                         Part{"a_new_document", begin_nothing, begin_document},
                                         Part{"what_looks_at_a_document", begin_document, look},
                                         Part{"a_picture", begin_document, solve},
                                         Part{"other_colors", begin_picture, change_colors},
                                         Part{"a_curve_that_moves", begin_colors, move_curve},
                                         Part{"a_frame_in_a_hurry", begin_move, hurry},
                                         Part{"curves_that_change", begin_picture, move_two},
                                         Part{"the_end_of_changes", begin_move, end_changes},
                                         Part{"a_frame_of_a_film", begin_film, make_next_frame},
                                         Part{"outputs", begin_picture, show},
                                         Part{"a_picture_file", begin_picture, keep},
                                         Part{"a_trace", begin_nothing, trace}),
                         [](const testing::TestParamInfo<Part>& part) { return part.param.name; });

TEST(CContextAllocation, a_context_is_there_or_null) {
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
