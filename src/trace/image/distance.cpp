#include "trace/image/distance.hpp"

#include <cstddef>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

constexpr std::size_t kLines = 16;

/// The lower envelope of parabolas with their apexes at (i, value[i]).
class Envelope {
 public:
  explicit Envelope(std::size_t size) : place_(size), begin_(size + 1), out_(size) {}

  /// Transforms `count` values that lie `step` apart.
  void transform(float* value, std::size_t count, std::size_t step) {
    std::size_t last = 0;
    place_[0] = 0;
    begin_[0] = -kFar;
    for (std::size_t i = 1; i < count; ++i) {
      double cut = crossing(value, step, place_[last], i);
      while (last > 0 && cut <= begin_[last]) cut = crossing(value, step, place_[--last], i);
      if (cut <= begin_[last]) cut = begin_[last];
      place_[++last] = i;
      begin_[last] = cut;
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      while (at < last && begin_[at + 1] < static_cast<double>(i)) ++at;
      const double far = static_cast<double>(i) - static_cast<double>(place_[at]);
      out_[i] = static_cast<float>(far * far + value[place_[at] * step]);
    }
    for (std::size_t i = 0; i < count; ++i) value[i * step] = out_[i];
  }

 private:
  static double crossing(const float* value, std::size_t step, std::size_t a, std::size_t b) {
    const auto x0 = static_cast<double>(a), x1 = static_cast<double>(b);
    return (value[b * step] + x1 * x1 - value[a * step] - x0 * x0) / (2 * (x1 - x0));
  }

  std::vector<std::size_t> place_;
  std::vector<double> begin_;
  std::vector<float> out_;
};

}  // namespace

Status transform_distance(Context& context, Plane& plane) {
  const auto width = static_cast<std::size_t>(plane.width);
  const auto height = static_cast<std::size_t>(plane.height);
  SFUMATO_TRY(parallel_for(context, width, kLines, [&](std::size_t x, std::size_t end) {
    Envelope envelope(height);
    for (; x < end; ++x) envelope.transform(plane.value.data() + x, height, width);
  }));
  return parallel_for(context, height, kLines, [&](std::size_t y, std::size_t end) {
    Envelope envelope(width);
    for (; y < end; ++y) envelope.transform(plane.value.data() + y * width, width, 1);
  });
}

}  // namespace sfumato::tracing
