#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "allocation/documents.hpp"
#include "base/poll.hpp"
#include "codecs/image_file.hpp"
#include "codecs/photo/photo.hpp"
#include "formats/image_files.hpp"
#include "formats/photo_files.hpp"
#include "limits/large_inputs.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/cancel_at.hpp"

/// Whichever poll of the cancel flag is the first to see it, the answer is `cancelled`; incomplete
/// work never becomes a result.
namespace sfumato::test {
namespace {

/// Records the places in the code that poll the flag, and their polls.
class PollPlaces : public PollWatch {
 public:
  bool wants_every_turn() const override { return true; }
  void polled() override {
    Place& place = places_[__builtin_return_address(0)];
    ++polls_;
    ++place.polls;
    if (std::has_single_bit(place.polls)) chosen_.insert(polls_);
    place.last = polls_;
  }

  /// Returns, for each place, the first poll, the second, the fourth and so on, and the last; and
  /// some evenly spread polls, because builds without optimisation have one place for all.
  std::set<std::uint64_t> chosen() const {
    std::set<std::uint64_t> polls = chosen_;
    for (const auto& [address, place] : places_) polls.insert(place.last);
    for (std::uint64_t i = 1; i <= kSpread; ++i) polls.insert(1 + (polls_ - 1) * i / kSpread);
    return polls;
  }

 private:
  static constexpr std::uint64_t kSpread = 20;

  struct Place {
    std::uint64_t polls = 0, last = 0;
  };
  std::map<const void*, Place> places_;
  std::set<std::uint64_t> chosen_;
  std::uint64_t polls_ = 0;
};

/// Sets a passed deadline at a poll.
class LateAt : public PollWatch {
 public:
  LateAt(std::uint64_t poll, std::optional<Deadline>& deadline)
      : left_(poll), deadline_(deadline) {}
  bool wants_every_turn() const override { return left_ > 0; }
  void polled() override {
    if (left_ > 0 && --left_ == 0) deadline_ = Deadline{.at_ns = 1, .seconds = 1};
  }

 private:
  std::uint64_t left_;
  std::optional<Deadline>& deadline_;
};

/// Runs `work` to its end, then repeatedly, cancelled at chosen polls of every place in the code,
/// and sometimes out of time there.
template <class Work>
void expect_cancelled_at_every_poll(const std::string& name, const Work& work) {
  Context context;
  PollPlaces places;
  context.poll_watch = &places;
  const auto whole = work(context);
  ASSERT_TRUE(whole.ok()) << name << ": " << to_string(whole.status());
  const std::set<std::uint64_t> chosen = places.chosen();
  ASSERT_FALSE(chosen.empty()) << name << " never looks";
  for (const std::uint64_t k : chosen) {
    Context cancelled;
    CancelAt watch(k, cancelled.cancel);
    cancelled.poll_watch = &watch;
    {
      const auto result = work(cancelled);
      ASSERT_EQ(result.status().code, StatusCode::cancelled) << name << ", poll " << k;
    }
    ASSERT_EQ(cancelled.budget.used(), 0u) << name << ", poll " << k;
    if (k % 4 != 0) continue;
    Context late;
    LateAt clock(k, late.deadline);
    late.poll_watch = &clock;
    const auto result = work(late);
    ASSERT_EQ(result.status().code, StatusCode::limit) << name << ", poll " << k;
    ASSERT_EQ(result.status().limit, "time") << name << ", poll " << k;
  }
}

template <class Value>
Value take(Result<Value> result) {
  EXPECT_TRUE(result.ok()) << to_string(result.status());
  return std::move(*result);
}

Document document_of(const std::string& text) {
  Context context;
  return take(read_document(context, text, "a.svg")).document;
}

class EveryPoll : public testing::TestWithParam<SmallDocument> {};

TEST_P(EveryPoll, ends_the_reader) {
  expect_cancelled_at_every_poll(
      "read", [&](Context& c) { return read_document(c, GetParam().text, "a.svg"); });
}

TEST_P(EveryPoll, ends_what_is_done_with_a_document) {
  const Document document = document_of(GetParam().text);
  expect_cancelled_at_every_poll("convert", [&](Context& c) { return write_svg(c, document); });
  expect_cancelled_at_every_poll("lint", [&](Context& c) { return lint(c, document); });
  expect_cancelled_at_every_poll("diffuse", [&](Context& c) { return diffuse(c, document, {}); });
  expect_cancelled_at_every_poll(
      "diffuse for pixels", [&](Context& c) { return diffuse(c, document, {.pixel_grid = true}); });
  expect_cancelled_at_every_poll("pixels", [&](Context& c) {
    return render_pixels(c, document, {}, {.width = 16, .height = 12});
  });
}

TEST_P(EveryPoll, ends_the_raster) {
  Context context;
  const Picture picture = take(diffuse(context, document_of(GetParam().text), {}));
  expect_cancelled_at_every_poll("raster", [&](Context& c) {
    return rasterize(c, picture, {.width = 32, .height = 24, .format = PixelFormat::rgba8});
  });
}

INSTANTIATE_TEST_SUITE_P(Of, EveryPoll, testing::ValuesIn(small_documents()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(EveryPollOf, solving_many_curves) {
  const Document document = many_curves(20);
  expect_cancelled_at_every_poll(
      "diffuse", [&](Context& c) { return diffuse(c, document, {.max_error = 40}); });
}

TEST(EveryPollOf, exporters) {
  Context context;
  const DiffuseOptions coarse{.pixels_per_unit = 0.25, .max_error = 40};
  const Picture picture = take(diffuse(context, document_of(document_with_everything()), coarse));
  expect_cancelled_at_every_poll("HTML", [&](Context& c) { return export_html(c, picture, {}); });
  expect_cancelled_at_every_poll("PDF", [&](Context& c) { return export_pdf(c, picture, {}); });
  expect_cancelled_at_every_poll("EPS", [&](Context& c) { return export_eps(c, picture, {}); });
  expect_cancelled_at_every_poll("GLB", [&](Context& c) { return export_glb(c, picture, {}); });
  expect_cancelled_at_every_poll("NPZ", [&](Context& c) { return export_npz(c, picture); });
  expect_cancelled_at_every_poll("JSON", [&](Context& c) { return export_json(c, picture); });
  expect_cancelled_at_every_poll("PLY", [&](Context& c) { return export_ply(c, picture); });
  for (const SvgMode mode : {SvgMode::image, SvgMode::vector}) {
    expect_cancelled_at_every_poll(
        "SVG", [&](Context& c) { return export_svg(c, picture, {.mode = mode, .force = true}); });
  }
}

TEST(EveryPollOf, codecs) {
  Context context;
  const Image image = noise_image(70, 50);
  expect_cancelled_at_every_poll("PNG", [&](Context& c) { return encode_png(c, image); });
  expect_cancelled_at_every_poll("JPEG", [&](Context& c) { return encode_jpeg(c, image, 90); });
  expect_cancelled_at_every_poll("WebP", [&](Context& c) { return encode_webp(c, image, {}); });
  const auto png = take(encode_png(context, image));
  const auto jpeg = take(encode_jpeg(context, image, 90));
  expect_cancelled_at_every_poll("PNG back",
                                 [&](Context& c) { return codecs::decode_image(c, png); });
  expect_cancelled_at_every_poll("JPEG back",
                                 [&](Context& c) { return codecs::decode_image(c, jpeg); });
  const Bytes photo = with_exif(with_profile(jpeg, display_p3_profile()), exif_of(6));
  expect_cancelled_at_every_poll("photo",
                                 [&](Context& c) { return codecs::read_photo(c, photo, "a.jpg"); });
  const Bytes inks = with_profile(jpeg_file(70, 50, 4, {1, 2, 3, 4}), ink_profile());
  expect_cancelled_at_every_poll("CMYK",
                                 [&](Context& c) { return codecs::read_photo(c, inks, "a.jpg"); });
  const auto webp = take(encode_webp(context, image, {}));
  expect_cancelled_at_every_poll("WebP back",
                                 [&](Context& c) { return codecs::read_photo(c, webp, "a.webp"); });
}

}  // namespace
}  // namespace sfumato::test
