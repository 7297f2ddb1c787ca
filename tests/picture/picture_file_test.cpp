// Pictures as files: a written picture is read bit for bit, and other bytes give an error or a
// valid picture.
#include "sfumato/picture/picture_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "allocation/documents.hpp"
#include "codecs/file_kind.hpp"
#include "picture/checksum.hpp"
#include "picture/same_picture.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/places.hpp"
#include "support/random_document.hpp"
#include "support/sanitizers.hpp"
#include "support/scenes.hpp"

namespace sfumato::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kChecksumAt = 20, kHeaderBytes = 28;
constexpr int kAttacks = SFUMATO_HAS_SANITIZER ? 300 : 3000;

/// Few triangles and few texels, with every kind of content.
const DiffuseOptions kCoarse{.pixels_per_unit = 0.5, .max_area_fraction = 1, .max_error = 0};

Picture picture_of(const Document& document, const DiffuseOptions& options) {
  Context context;
  Result<Picture> picture = diffuse(context, document, options);
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return picture ? std::move(*picture) : Picture{};
}

Document read_text(const std::string& text, const std::string& name,
                   const ResourceLoader* files = nullptr) {
  Context context;
  Result<ReadDocument> read = read_document(context, text, name, files);
  EXPECT_TRUE(read.ok()) << to_string(read.status());
  return read ? std::move(read->document) : Document{};
}

/// Returns a picture with a background, layers, groups, instances, local curves, gradients and
/// textures.
Picture picture_of_everything() {
  Document document = read_text(document_with_everything(), "all.svg");
  document.background = Rgb{0.5f, 0.25f, 1};
  return picture_of(document, kCoarse);
}

Bytes written(const Picture& picture, const PictureOrigin& origin = {}) {
  Context context;
  Result<Bytes> bytes = write_picture(context, picture, origin);
  EXPECT_TRUE(bytes.ok()) << to_string(bytes.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return bytes ? std::move(*bytes) : Bytes{};
}

Result<Picture> reread(const Bytes& bytes, PictureOrigin* origin = nullptr) {
  Context context;
  Result<Picture> picture = read_picture(context, bytes, origin);
  EXPECT_EQ(context.budget.used(), 0u);
  return picture;
}

/// Corrects size and checksum, so that the reader examines the data after it.
void correct_header(Bytes& bytes) {
  if (bytes.size() < kHeaderBytes) return;
  const std::uint64_t size = bytes.size();
  std::memcpy(&bytes[12], &size, sizeof size);
  const Context context;
  const auto sum = picture::checksum(context, std::span(bytes).subspan(kHeaderBytes));
  std::memcpy(&bytes[kChecksumAt], &*sum, sizeof *sum);
}

void expect_survives(Picture picture, const std::string& name) {
  const PictureOrigin origin{{1.25, 0.75}, 2.5, 0.25};
  const Bytes bytes = written(picture, origin);
  EXPECT_TRUE(is_picture_file(bytes));
  PictureOrigin found;
  Result<Picture> read = reread(bytes, &found);
  ASSERT_TRUE(read.ok()) << name << ": " << to_string(read.status());
  EXPECT_TRUE(are_same(picture, *read)) << name;
  EXPECT_EQ(found, origin) << name;
  EXPECT_EQ(written(*read, found), bytes) << name;
}

/// Expects, for foreign bytes, either a valid picture or an error.
void expect_answer(const Bytes& bytes, const std::string& what) {
  const Result<Picture> read = reread(bytes);
  if (read) {
    written(*read);
    return;
  }
  const StatusCode code = read.status().code;
  EXPECT_TRUE(code == StatusCode::bad_input || code == StatusCode::limit) << what;
  EXPECT_FALSE(read.status().message.empty()) << what;
}

TEST(PictureFile, checksum_is_xxh64) {
  const Context context;
  const auto sum_of = [&](const std::string& text) {
    return *picture::checksum(context,
                              {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(sum_of(""), 0xEF46DB3751D8E999u);
  EXPECT_EQ(sum_of("a"), 0xD24EC4F1A98C6E5Bu);
  EXPECT_EQ(sum_of("abc"), 0x44BC2CF5AD770999u);
  EXPECT_EQ(sum_of("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1u);
}

TEST(PictureFile, a_picture_of_everything_is_read_as_it_was) {
  const Picture picture = picture_of_everything();
  EXPECT_FALSE(picture.shaders.empty());
  EXPECT_GT(picture.stack.size(), 3u);
  expect_survives(picture, "everything");
}

TEST(PictureFile, its_first_bytes_say_what_it_is) {
  EXPECT_EQ(codecs::file_kind(codecs::text_view(written(picture_of_everything()))),
            codecs::FileKind::solved);
}

TEST(PictureFile, zeros_of_both_signs_and_the_smallest_numbers_are_kept) {
  Picture picture = picture_of_everything();
  std::vector<float>& values = picture.layers[0].color.node_value;
  ASSERT_GE(values.size(), 3u);
  values[0] = -0.0f;
  values[1] = std::numeric_limits<float>::denorm_min();
  values[2] = std::numeric_limits<float>::lowest();
  expect_survives(std::move(picture), "numbers");
}

TEST(PictureFile, a_hundred_random_documents_are_read_as_they_were) {
  for (std::uint64_t seed = 0; seed < (SFUMATO_HAS_SANITIZER ? 10 : 100); ++seed) {
    expect_survives(picture_of(random_document(seed), kCoarse), "seed " + std::to_string(seed));
  }
}

/// Textures beside the examples.
class ExampleFiles : public ResourceLoader {
 public:
  Result<Bytes> load(std::string_view href) const override {
    const auto bytes = file_bytes(source_path("examples/") + std::string(href));
    if (!bytes) return make_error(StatusCode::bad_input, "no such file");
    return Bytes(bytes->begin(), bytes->end());
  }
};

TEST(PictureFile, every_example_is_read_as_it_was) {
  int count = 0;
  const ExampleFiles files;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("examples"))) {
    if (entry.path().extension() != ".svg") continue;
    const Document document =
        read_text(*file_bytes(entry.path().string()), entry.path().filename().string(), &files);
    const double side = std::max(document.artboard.width(), document.artboard.height());
    expect_survives(picture_of(document, {.pixels_per_unit = 128 / side, .max_error = 8}),
                    entry.path().filename().string());
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(PictureFile, tables_lie_at_multiples_of_sixteen) {
  const Picture picture = picture_of_everything();
  const Bytes bytes = written(picture);
  const std::vector<Vec2>& positions = picture.layers[0].vertex_position;
  const auto* begin = reinterpret_cast<const std::uint8_t*>(positions.data());
  const auto found =
      std::search(bytes.begin(), bytes.end(), begin, begin + positions.size() * sizeof(Vec2));
  ASSERT_NE(found, bytes.end());
  EXPECT_EQ((found - bytes.begin()) % 16, 0);
}

TEST(PictureFile, it_is_read_at_any_address) {
  const Bytes bytes = written(picture_of_everything());
  for (std::size_t shift = 1; shift < 9; ++shift) {
    Bytes moved(shift, 0);
    moved.insert(moved.end(), bytes.begin(), bytes.end());
    const Context context;
    Result<Picture> read = read_picture(context, std::span(moved).subspan(shift));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(written(*read), bytes);
  }
}

TEST(PictureFile, every_cut_is_told) {
  const Bytes bytes = written(picture_of_everything());
  std::mt19937 random(1);
  for (int i = 0; i < kAttacks; ++i) {
    const std::size_t size = i < 200 ? static_cast<std::size_t>(i) : random() % bytes.size();
    Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(reread(cut).ok()) << size;
    correct_header(cut);
    const Result<Picture> corrected = reread(cut);
    ASSERT_FALSE(corrected.ok()) << size;
    EXPECT_EQ(corrected.status().code, StatusCode::bad_input) << size;
  }
}

TEST(PictureFile, every_flip_is_told) {
  Bytes bytes = written(picture_of_everything());
  std::mt19937 random(2);
  for (int i = 0; i < kAttacks; ++i) {
    const std::size_t at = i < 40 ? static_cast<std::size_t>(i) : random() % bytes.size();
    const auto bit = static_cast<std::uint8_t>(1u << random() % 8);
    bytes[at] ^= bit;
    const Result<Picture> read = reread(bytes);
    EXPECT_FALSE(read.ok()) << at;
    EXPECT_EQ(read.status().code, StatusCode::bad_input) << at;
    bytes[at] ^= bit;
  }
}

TEST(PictureFile, flips_under_a_right_checksum_are_answered) {
  const Bytes bytes = written(picture_of_everything());
  std::mt19937 random(3);
  for (int i = 0; i < kAttacks; ++i) {
    Bytes altered = bytes;
    for (unsigned flips = random() % 3 + 1; flips > 0; --flips) {
      const std::size_t at = kHeaderBytes + random() % (bytes.size() - kHeaderBytes);
      altered[at] = random() % 2 == 0 ? static_cast<std::uint8_t>(random())
                                      : static_cast<std::uint8_t>(altered[at] ^ 1u << random() % 8);
    }
    correct_header(altered);
    expect_answer(altered, "flip " + std::to_string(i));
  }
}

TEST(PictureFile, lengths_beyond_the_file_take_no_memory) {
  const Bytes bytes = written(picture_of_everything());
  Context small{.budget = Budget(64u << 20)};
  int tried = 0;
  for (std::size_t at = kHeaderBytes; at + 8 <= bytes.size() && at < 4000; ++at) {
    for (const std::uint64_t length : {~std::uint64_t{0}, std::uint64_t{1} << 40, bytes.size()}) {
      Bytes altered = bytes;
      std::memcpy(&altered[at], &length, sizeof length);
      correct_header(altered);
      const Result<Picture> read = read_picture(small, altered);
      if (!read) {
        EXPECT_TRUE(read.status().code == StatusCode::bad_input ||
                    (read.status().code == StatusCode::limit && read.status().limit != "memory"))
            << at << ": " << to_string(read.status());
      }
      ++tried;
    }
  }
  EXPECT_GT(tried, 1000);
}

std::string complaint(const Bytes& bytes) {
  const Result<Picture> read = reread(bytes);
  EXPECT_EQ(read.status().code, StatusCode::bad_input);
  return read.status().message;
}

TEST(PictureFile, what_it_is_not_is_said) {
  const Bytes bytes = written(picture_of_everything());
  EXPECT_EQ(complaint({}), "not a solved picture");
  EXPECT_EQ(complaint({'<', 's', 'v', 'g', '>', ' ', ' ', ' '}), "not a solved picture");
  EXPECT_EQ(complaint({bytes.begin(), bytes.begin() + 20}), "a solved picture that is cut off");
  Bytes later = bytes;
  later[7] = kPictureFileVersion + 1;
  EXPECT_EQ(complaint(later), "a solved picture of version 3; only version 2 can be read");
  Bytes swapped = bytes;
  std::reverse(&swapped[8], &swapped[12]);
  EXPECT_EQ(complaint(swapped), "a solved picture of a machine with the other byte order");
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_EQ(complaint(longer), "a solved picture of " + std::to_string(bytes.size()) + " bytes, " +
                                   std::to_string(longer.size()) + " are here");
  correct_header(longer);
  EXPECT_EQ(complaint(longer), "damaged: there is something behind its end");
  Bytes altered = bytes;
  altered.back() ^= 1;
  EXPECT_EQ(complaint(altered), "damaged: the checksum of its bytes is another");
}

TEST(PictureFile, what_cannot_be_painted_is_not_written) {
  const Picture good = picture_of_everything();
  const auto refused = [](const Picture& picture, const PictureOrigin& origin = {}) {
    Context context;
    return write_picture(context, picture, origin).status().code == StatusCode::bad_input;
  };
  Picture picture = good;
  picture.layers[0].color.node_value[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(refused(picture));
  picture = good;
  picture.layers[0].triangle_vertex[0] = 1u << 30;
  EXPECT_TRUE(refused(picture));
  picture = good;
  picture.layers[0].edge_is_curve[0] = 2;
  EXPECT_TRUE(refused(picture));
  picture = good;
  picture.viewport = {};
  EXPECT_TRUE(refused(picture));
  picture = good;
  picture.viewport.min.x = 0;
  picture.viewport.max.x = 1e-150;
  EXPECT_TRUE(refused(picture));
  EXPECT_TRUE(refused(good, {.pixels_per_unit = 0}));
  EXPECT_TRUE(refused(good, {.max_error = 256}));
  EXPECT_TRUE(refused(good, {.own_scale = {1, std::numeric_limits<double>::infinity()}}));
  EXPECT_FALSE(refused(good));
}

/// Returns the limit named by the error after one limit is lowered.
std::string_view limit_of(const Bytes& bytes, std::size_t Limits::*limit, std::size_t most) {
  Context context;
  context.limits.*limit = most;
  const Result<Picture> read = read_picture(context, bytes);
  EXPECT_EQ(read.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
  return read.status().limit;
}

TEST(PictureFile, limits_hold) {
  const Bytes bytes = written(picture_of_everything());
  EXPECT_EQ(limit_of(bytes, &Limits::input_bytes, bytes.size() / kPictureFileFactor),
            "input-bytes");
  EXPECT_EQ(limit_of(bytes, &Limits::layers, 0), "layers");
  EXPECT_EQ(limit_of(bytes, &Limits::triangles, 1), "triangles");
  EXPECT_EQ(limit_of(bytes, &Limits::nodes, 9), "nodes");
  EXPECT_EQ(limit_of(bytes, &Limits::stack_items, 1), "stack-items");
  EXPECT_EQ(limit_of(bytes, &Limits::textures, 0), "textures");
  Context context{.budget = Budget(bytes.size() / 2)};
  EXPECT_EQ(read_picture(context, bytes).status().limit, "memory");
  EXPECT_EQ(write_picture(context, *reread(bytes)).status().limit, "memory");
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(PictureFile, who_cancels_is_heard) {
  const Picture picture = picture_of_everything();
  const Bytes bytes = written(picture);
  Context context;
  context.cancel = true;
  EXPECT_EQ(read_picture(context, bytes).status().code, StatusCode::cancelled);
  EXPECT_EQ(write_picture(context, picture).status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato::test
