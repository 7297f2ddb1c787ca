#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>

#include "cli/commands/difference.hpp"
#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

using cli::Difference;

/// Returns an image of one row: channel c of pixel x is value_of(x, c), of 255 or 65535.
Image row_image(int width, PixelFormat format, const std::function<int(int x, int c)>& value_of) {
  Image image{width, 1, format, {}};
  image.bytes.resize(image.row_bytes());
  std::uint8_t* byte = image.bytes.data();
  const int channel_bytes = bytes_per_channel(format);
  for (int x = 0; x < width; ++x) {
    for (int c = 0; c < channel_count(format); ++c, byte += channel_bytes) {
      const auto value = static_cast<std::uint16_t>(value_of(x, c));
      if (channel_bytes == 2) {
        std::memcpy(byte, &value, 2);
      } else {
        *byte = static_cast<std::uint8_t>(value);
      }
    }
  }
  return image;
}

/// Returns a hundred pixels; the last two differ from black, by 2 and by 10 in every channel.
Image nearly_black() {
  return row_image(100, PixelFormat::rgb8, [](int x, int) {
    return x == 99 ? 10 : x == 98 ? 2 : 0;
  });
}

Image black(PixelFormat format = PixelFormat::rgb8) {
  return row_image(100, format, [](int, int) { return 0; });
}

Difference difference_of(const Image& a, const Image& b) {
  Result<Difference> difference = Difference::of(Context(), a, b);
  EXPECT_TRUE(difference.ok());
  return std::move(*difference);
}

TEST(Difference, counts_every_channel_once) {
  const Difference difference = difference_of(black(), nearly_black());
  EXPECT_DOUBLE_EQ(difference.rms(), std::sqrt(1.04));
  EXPECT_DOUBLE_EQ(difference.psnr_db(), 20 * std::log10(255 / std::sqrt(1.04)));
  EXPECT_EQ(difference.maximum(), 10);
  EXPECT_EQ(difference.percentile(500), 0);
  EXPECT_EQ(difference.percentile(980), 0);
  EXPECT_EQ(difference.percentile(981), 2);
  EXPECT_EQ(difference.percentile(990), 2);
  EXPECT_EQ(difference.percentile(991), 10);
  EXPECT_EQ(difference.percentile(999), 10);
}

TEST(Difference, does_not_depend_on_the_order) {
  const Difference difference = difference_of(nearly_black(), black());
  EXPECT_DOUBLE_EQ(difference.rms(), std::sqrt(1.04));
  EXPECT_EQ(difference.maximum(), 10);
}

TEST(Difference, of_equal_images_is_nothing) {
  const Difference difference = difference_of(nearly_black(), nearly_black());
  EXPECT_EQ(difference.rms(), 0);
  EXPECT_EQ(difference.maximum(), 0);
  EXPECT_EQ(difference.psnr_db(), std::numeric_limits<double>::infinity());
}

TEST(Difference, takes_16_bits_as_fractions_of_a_code_value) {
  const Image eight = row_image(5, PixelFormat::rgb8, [](int x, int c) { return 40 * x + c; });
  const Image sixteen =
      row_image(5, PixelFormat::rgb16, [](int x, int c) { return 257 * (40 * x + c); });
  EXPECT_EQ(difference_of(eight, sixteen).rms(), 0);
  const Image finer =
      row_image(5, PixelFormat::rgb16, [](int x, int c) { return 257 * (40 * x + c) + 64; });
  EXPECT_DOUBLE_EQ(difference_of(eight, finer).maximum(), 64 / 257.0);
  EXPECT_DOUBLE_EQ(difference_of(eight, finer).rms(), 64 / 257.0);
}

Image picture_of(const Image& a, const Image& b, double scale) {
  const Context context;
  TableMemory memory("a test");
  Result<Image> picture = cli::difference_image(context, a, b, scale, memory);
  EXPECT_TRUE(picture.ok());
  return picture ? std::move(*picture) : Image();
}

TEST(Difference, picture_takes_its_room_from_the_budget) {
  const Context context{.budget = Budget(299)};
  TableMemory memory("a test");
  const auto picture = cli::difference_image(context, black(), nearly_black(), 1, memory);
  EXPECT_EQ(picture.status().code, StatusCode::limit);
}

TEST(Difference, takes_an_image_without_alpha_as_opaque) {
  const Image clear = row_image(100, PixelFormat::rgba8, [](int x, int c) {
    return c == 3 && x != 0 ? 255 : 0;  // the first pixel is transparent
  });
  EXPECT_EQ(difference_of(black(), clear).maximum(), 255);
  EXPECT_DOUBLE_EQ(difference_of(black(), clear).rms(), 255 / std::sqrt(400.0));
  EXPECT_EQ(picture_of(black(), clear, 1).bytes[0], 255);
  EXPECT_EQ(picture_of(black(), clear, 1).bytes[3], 0);
}

TEST(Difference, picture_is_scaled_and_clamped) {
  const Image picture = picture_of(black(), nearly_black(), 12.5);
  EXPECT_EQ(picture.format, PixelFormat::rgb8);
  EXPECT_EQ(picture.width, 100);
  EXPECT_EQ(picture.bytes[97 * 3], 0);
  EXPECT_EQ(picture.bytes[98 * 3], 25);
  EXPECT_EQ(picture.bytes[99 * 3 + 2], 125);
  EXPECT_EQ(picture_of(black(), nearly_black(), 128).bytes[99 * 3], 255);
}

TEST(Difference, ends_at_the_first_row_after_cancelling) {
  Context context;
  context.cancel = true;
  TableMemory memory("a test");
  const auto picture = cli::difference_image(context, black(), nearly_black(), 1, memory);
  EXPECT_EQ(picture.status().code, StatusCode::cancelled);
  EXPECT_EQ(Difference::of(context, black(), nearly_black()).status().code, StatusCode::cancelled);
}

TEST(Compare, charges_the_files) {
  const TemporaryFolder folder;
  const std::string large = folder.add("large.png", std::string(std::size_t{1} << 20, ' '));
  const CommandResult result = run_sfumato({"compare", large, large, "--max-memory", "1"});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.err.find("the input"), std::string::npos) << result.err;
}

/// Files larger than the memory limit are not read.
TEST(Compare, reads_no_more_than_the_memory_allows) {
  const TemporaryFolder folder;
  const std::string large = folder.add("large.png", std::string());
  std::filesystem::resize_file(large, std::size_t{200} << 20);
  const CommandResult result = run_sfumato({"compare", large, large, "--max-memory", "8"});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_TRUE(result.err.starts_with(large + ": error: memory limit of 8 MiB")) << result.err;
  EXPECT_LT(result.peak_bytes, std::size_t{150} << 20);
}

TEST(Compare, prints_the_figures) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", png_of(black()));
  const std::string b = folder.add("b.png", png_of(nearly_black()));
  const CommandResult result = run_sfumato({"compare", a, b});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "rms          1.0198\n"
            "psnr        47.9605 dB\n"
            "maximum     10.0000\n"
            "50%          0.0000\n"
            "90%          0.0000\n"
            "99%          2.0000\n"
            "99.9%       10.0000\n");
}

TEST(Compare, prints_json_and_reads_stdin) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", png_of(black()));
  const CommandResult differ = run_sfumato({"compare", "--json", a, "-"}, png_of(nearly_black()));
  EXPECT_EQ(differ.exit_code, 0) << differ.err;
  EXPECT_TRUE(differ.out.starts_with("{\"rms\":1.01980390271")) << differ.out;
  EXPECT_NE(differ.out.find("\"percentiles\":{\"p50\":0,\"p90\":0,\"p99\":2,\"p99.9\":10}}\n"),
            std::string::npos)
      << differ.out;
  const CommandResult same = run_sfumato({"compare", "--json", a, a});
  EXPECT_TRUE(same.out.starts_with("{\"rms\":0,\"psnr_db\":null,\"maximum\":0,")) << same.out;
}

TEST(Compare, draws_the_difference) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", png_of(black()));
  const std::string b = folder.add("b.png", png_of(nearly_black()));
  const std::string output = folder.path("difference.png");
  EXPECT_EQ(run_sfumato({"compare", a, b, "-o", output, "--scale", "20"}).exit_code, 0);
  const Image picture = image_of(read_whole(output));
  ASSERT_EQ(picture.width, 100);
  EXPECT_EQ(picture.bytes, picture_of(black(), nearly_black(), 20).bytes);
}

TEST(Compare, refuses_images_of_two_sizes) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", png_of(black()));
  const std::string b =
      folder.add("b.png", png_of(row_image(99, PixelFormat::rgb8, [](int, int) { return 0; })));
  const CommandResult result = run_sfumato({"compare", a, b, "-o", folder.path("difference.png")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, b + ": error: the picture has 99 x 1 pixels, but " + a +
                            " has 100 x 1; compare pictures of the same size\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "b.png"}));
}

TEST(Compare, refuses_what_is_no_png) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", png_of(black()));
  const std::string whole = png_of(nearly_black());
  for (const std::string& content :
       {std::string(), std::string("no picture"), whole.substr(0, whole.size() / 2)}) {
    const CommandResult result = run_sfumato({"compare", a, folder.add("b.png", content)});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(result.err.starts_with(folder.path("b.png") + ": error: ")) << result.err;
  }
}

TEST(Compare, refuses_options_that_make_no_sense) {
  EXPECT_EQ(run_sfumato({"compare", "-", "-"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"compare", "a.png", "b.png", "--scale", "2"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"compare", "a.png", "b.png", "-o", "-"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"compare", "a.png", "b.png", "-o", "c.png", "--scale", "0"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"compare", "a.png", "b.png", "-o", "/none/c.png"}).exit_code, 3);
}

}  // namespace
}  // namespace sfumato::test
