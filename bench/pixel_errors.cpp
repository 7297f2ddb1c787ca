#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/codecs/png.hpp"

// Prints the errors of pictures in code values of 255. The reference is a larger picture with exact
// pixels, averaged over the square of each tested pixel. The error of a pixel is the error of its
// worst channel.
//
//   sfumato render X --method pixels --width 4096 --no-dither -o reference.png
//   sfumato render X --width 1024 --depth 16 --max-error 1 -o test.png
//   build/bench/pixel_errors reference.png test.png...
//
// Smooth pixels are those whose samples in the reference span at most 6 code values; the others are
// busy. The reference is coarse where an edge passes: rms and busy only serve to compare pictures.
// "new > 4" counts the pixels whose error is above 4 here and at most 4 in the first picture. "by >
// 1" counts the pixels among them whose error grew by more than 1.
namespace sfumato {
namespace {

constexpr float kSmoothSpan = 6;
constexpr float kFar = 4;

std::optional<Image> read(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  Context context;
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  Result<Image> image = decode_png(context, {data, bytes.size()}, path);
  if (image && channel_count(image->format) == 3) return std::move(*image);
  std::fprintf(
      stderr, "pixel_errors: %s: %s\n", path,
      image ? "has transparency; draw it over a background" : image.status().message.c_str());
  return std::nullopt;
}

/// Returns a channel in code values.
float code_at(const Image& image, int x, int y, int channel) {
  const std::size_t i = 3 * static_cast<std::size_t>(x) + channel;
  const std::uint8_t* const row = image.bytes.data() + image.row_bytes() * y;
  if (bytes_per_channel(image.format) == 1) return row[i];
  std::uint16_t value;
  std::memcpy(&value, row + 2 * i, 2);
  return value / 257.0f;
}

struct Reference {
  Image image;
  int factor;  ///< samples of a pixel along a side
};

struct PixelError {
  float error = 0;
  float span = 0;  ///< of the reference's samples
};

PixelError pixel_error(const Reference& reference, const Image& test, int x, int y) {
  PixelError pixel;
  const int factor = reference.factor;
  for (int c = 0; c < 3; ++c) {
    float sum = 0, least = 255, most = 0;
    for (int j = 0; j < factor; ++j) {
      for (int i = 0; i < factor; ++i) {
        const float value = code_at(reference.image, factor * x + i, factor * y + j, c);
        sum += value;
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
    const float mean = sum / static_cast<float>(factor * factor);
    pixel.error = std::max(pixel.error, std::fabs(mean - code_at(test, x, y, c)));
    pixel.span = std::max(pixel.span, most - least);
  }
  return pixel;
}

float percentile(std::vector<float>& errors, double share) {
  if (errors.empty()) return 0;
  const auto place = static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1));
  std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(place));
  return errors[place];
}

double percent_above(const std::vector<float>& errors, float limit) {
  const auto above = std::ranges::count_if(errors, [&](float e) { return e > limit; });
  return errors.empty() ? 0
                        : 100.0 * static_cast<double>(above) / static_cast<double>(errors.size());
}

std::vector<PixelError> errors_of(const Reference& reference, const Image& test) {
  std::vector<PixelError> errors;
  const int height = std::min(test.height, reference.image.height / reference.factor);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < test.width; ++x) errors.push_back(pixel_error(reference, test, x, y));
  return errors;
}

void print_row(const char* path, const std::vector<PixelError>& errors,
               const std::vector<PixelError>& first) {
  std::vector<float> all, smooth, busy;
  double squares = 0;
  std::size_t new_far = 0, much_farther = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const float error = errors[i].error;
    all.push_back(error);
    (errors[i].span <= kSmoothSpan ? smooth : busy).push_back(error);
    squares += double{error} * error;
    if (error <= kFar || i >= first.size() || first[i].error > kFar) continue;
    ++new_far;
    much_farther += error > first[i].error + 1;
  }
  std::printf("| %s | %.3f | %.2f | %.2f | %.2f | %.4f | %.2f | %.2f | %.3f | %.2f | %zu | %zu |\n",
              path, std::sqrt(squares / static_cast<double>(errors.size())), percentile(all, 0.99),
              percentile(all, 0.999), percentile(all, 1), percent_above(all, kFar),
              percentile(smooth, 0.99), percentile(smooth, 0.999), percent_above(smooth, 1),
              percentile(busy, 0.99), new_far, much_farther);
}

int run(int count, char** paths) {
  std::optional<Image> image = read(paths[0]);
  if (!image) return 1;
  Reference reference{std::move(*image), 1};
  std::vector<PixelError> first;
  std::printf(
      "| picture | rms | 99 %% | 99.9 %% | most | > 4, %% | smooth: 99 %% | 99.9 %% | > 1, %% "
      "| busy: 99 %% | new > 4 | by > 1 |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < count; ++i) {
    const std::optional<Image> test = read(paths[i]);
    if (!test) return 1;
    if (reference.image.width % test->width != 0) {
      std::fprintf(stderr, "pixel_errors: %s: its width must divide the reference's, %d\n",
                   paths[i], reference.image.width);
      return 1;
    }
    reference.factor = reference.image.width / test->width;
    const std::vector<PixelError> errors = errors_of(reference, *test);
    if (i == 1) first = errors;
    print_row(paths[i], errors, first);
  }
  return 0;
}

}  // namespace
}  // namespace sfumato

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("usage: pixel_errors REFERENCE.png TEST.png...\n", stderr);
    return 2;
  }
  return sfumato::run(count - 1, arguments + 1);
}
