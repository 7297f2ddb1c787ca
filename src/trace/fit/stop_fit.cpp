#include "trace/fit/stop_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "trace/curves/drawing_stops.hpp"
#include "trace/fit/bounded_solve.hpp"
#include "trace/fit/row_color.hpp"

namespace sfumato::tracing {
namespace {

/// A layer that counts for less than this in a pixel is mixed there with others.
constexpr float kSolid = 0.9f;
/// Beyond the colours of any space.
constexpr float kUnbound = 1e3f;
/// Pixels, and numbers of a plane, of one task.
constexpr std::size_t kPixelsPerTask = 256;
constexpr std::size_t kValuesPerTask = 4096;

FourFloats four(const Rgb& color) {
  return {color.r, color.g, color.b, 0};
}

bool counts(const FourFloats& coefficient) {
  return coefficient[0] > 0 || coefficient[1] > 0 || coefficient[2] > 0;
}

}  // namespace

StopFit::StopFit(Context& context, const Picture& picture, const Document& drawing,
                 std::span<const CurveOfLayer> only)
    : context_(context), picture_(picture), drawing_(drawing), only_(only) {
  const Box& box = drawing.artboard;
  laid_ = {picture.width(), picture.height(),
           Affine{box.width() / picture.width(), 0, 0, box.height() / picture.height(), box.min.x,
                  box.min.y}};
}

Status StopFit::prepare(const Rgb& backdrop, std::uint64_t seed) {
  for (std::uint32_t i = 0; i < drawing_.layers.size(); ++i) {
    SFUMATO_TRY_ASSIGN(auto&& layer, prepare_layer(context_, drawing_, i, laid_));
    layers_.push_back(std::move(layer));
  }
  SFUMATO_TRY(choose_points(seed));
  SFUMATO_TRY_ASSIGN(points_, look_through(context_, drawing_, layers_, laid_, pixels_, backdrop));
  Status status = list_stops();
  if (status) status = choose_curves();
  if (status) status = list_parts();
  if (status) status = list_moving_curves();
  if (status) status = convert_picture();
  if (status) status = look_at(drawing_);
  if (status) status = count_weights();
  return status ? find_bounds() : status;
}

Status StopFit::choose_points(std::uint64_t seed) {
  SFUMATO_TRY_ASSIGN(auto&& marks, PixelMarks::create(context_, laid_.width, laid_.height));
  const Affine pixel_from_artboard = inverse(laid_.artboard_from_pixel);
  for (const StackItem& item : drawing_.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance || !layers_[instance->layer]) continue;
    SFUMATO_TRY(mark_sharp_curves(context_, drawing_.layers[instance->layer].curves,
                                  layers_[instance->layer]->flat,
                                  pixel_from_artboard * instance->artboard_from_layer, marks));
  }
  const double pixels = static_cast<double>(laid_.width) * laid_.height;
  SFUMATO_TRY_ASSIGN(
      pixels_, choose_pixels(context_, marks,
                             {std::max(1.0, pixels / kFittedPixels), seed, 0, marks.height()}));
  return ok_status();
}

Status StopFit::list_stops() {
  std::size_t stops = 0, curves = 0;
  for (const Layer& layer : drawing_.layers) {
    first_stop_.push_back(static_cast<std::uint32_t>(stops));
    first_curve_.push_back(static_cast<std::uint32_t>(curves));
    stops += curves::stop_count(layer.curves, StopAttribute::color);
    curves += layer.curves.size();
  }
  SFUMATO_TRY(memory_.resize_all(context_, stops, x_, low_, high_));
  SFUMATO_TRY(memory_.resize(context_, weight_, stops));
  SFUMATO_TRY(memory_.resize_all(context_, stops, has_next_, is_free_));
  SFUMATO_TRY(memory_.resize(context_, is_chosen_, curves));
  SFUMATO_TRY(memory_.resize_all(context_, curves, factor_, radius_px_));
  return memory_.resize(context_, missing_, pixels_.pixel.size());
}

/// Which curves and stops are fitted.
Status StopFit::choose_curves() {
  std::ranges::fill(is_chosen_, static_cast<std::uint8_t>(only_.empty()));
  for (const CurveOfLayer& one : only_) is_chosen_[first_curve_[one.layer] + one.curve] = 1;
  std::size_t curve = 0, at = 0;
  return for_each_curve(context_, drawing_, [&](const Curve& of) {
    const std::size_t count = curves::stop_count({&of, 1}, StopAttribute::color);
    std::fill_n(is_free_.begin() + static_cast<std::ptrdiff_t>(at), count, is_chosen_[curve++]);
    at += count;
  });
}

Status StopFit::list_parts() {
  SFUMATO_TRY(memory_.resize(context_, part_begin_, pixels_.point.size() + 1));
  RarePoll<65536> poll(context_);
  for (const ShownInstance& shown : points_.shown) {
    for (std::size_t i = 0; i < shown.coefficient.size(); ++i) {
      if (poll.cancelled()) return context_.cancel_status();
      part_begin_[shown.sight.point[i] + 1] += counts(shown.coefficient[i]);
    }
  }
  for (std::size_t p = 1; p < part_begin_.size(); ++p) part_begin_[p] += part_begin_[p - 1];
  SFUMATO_TRY(memory_.resize(context_, part_, part_begin_.back()));
  std::vector<std::uint32_t> next;
  TableMemory memory("the colours of a fit");
  SFUMATO_TRY(memory.assign(context_, part_begin_, next));
  for (std::uint32_t s = 0; s < points_.shown.size(); ++s) {
    const ShownInstance& shown = points_.shown[s];
    for (std::uint32_t i = 0; i < shown.coefficient.size(); ++i) {
      if (poll.cancelled()) return context_.cancel_status();
      if (counts(shown.coefficient[i])) part_[next[shown.sight.point[i]]++] = {s, i};
    }
  }
  return ok_status();
}

/// The picture in the drawing's interpolation space.
Status StopFit::convert_picture() {
  if (is_in_srgb()) return ok_status();
  for (Plane& plane : color_) {
    SFUMATO_TRY(make_plane(context_, laid_.width, laid_.height, memory_, plane));
  }
  const auto& code = picture_.code;
  return parallel_for(
      context_, code[0].value.size(), kValuesPerTask, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
          const Rgb color = from_srgb(drawing_.interpolation,
                                      {code[0].value[i], code[1].value[i], code[2].value[i]});
          color_[0].value[i] = color.r;
          color_[1].value[i] = color.g;
          color_[2].value[i] = color.b;
        }
      });
}

Status StopFit::look_at(const Document& drawing) {
  std::size_t at = 0;
  SFUMATO_TRY(for_each_color_list(context_, drawing, [&](const ColorStops& list) {
    for (const Stop<Rgb>& stop : list.stops) {
      x_[at++] = four(from_srgb(drawing_.interpolation, stop.value));
    }
  }));
  std::vector<float> radius;
  TableMemory memory("the colours of a fit");
  SFUMATO_TRY(memory.reserve(context_, radius, factor_.size()));
  SFUMATO_TRY(for_each_curve(context_, drawing,
                             [&](const Curve& curve) { radius.push_back(largest_radius(curve)); }));
  std::size_t curve = 0;
  SFUMATO_TRY(for_each_curve(context_, drawing_, [&](const Curve& before) {
    const float was = largest_radius(before);
    factor_[curve] = was > 0 ? radius[curve] / was : 1;
    ++curve;
  }));
  SFUMATO_TRY(build_matrix());
  return find_missing();
}

Status StopFit::build_matrix() {
  const auto columns = static_cast<std::uint32_t>(x_.size());
  matrix_ = {};
  SFUMATO_TRY_ASSIGN(
      matrix_,
      build_rows(context_, pixels_.pixel.size(), columns, [&](std::size_t i, RowSummer& sum) {
        for_each_part(i, [&](const Part& part, double share, const FourFloats& coefficient) {
          for_each_stop(part, [&](std::uint32_t column, double weight) {
            sum.add(column, static_cast<float>(share * coefficient[3] * weight));
          });
        });
      }));
  return ok_status();
}

/// How much the picture shows of each stop, and which neighbours are to be alike.
Status StopFit::count_weights() {
  RarePoll<65536> poll(context_);
  for (std::size_t k = 0; k < matrix_.column.size(); ++k) {
    if (poll.cancelled()) return context_.cancel_status();
    weight_[matrix_.column[k]] += matrix_.value[k] * matrix_.value[k];
  }
  std::size_t at = 0;
  return for_each_color_list(context_, drawing_, [&](const ColorStops& list) {
    for (std::size_t i = 0; i < list.stops.size(); ++i, ++at) {
      // Two stops at one place are a step.
      has_next_[at] = i + 1 < list.stops.size() && is_shown(at) && is_shown(at + 1) &&
                      list.stops[i].offset < list.stops[i + 1].offset;
    }
  });
}

Status StopFit::find_bounds() {
  const bool is_lab = drawing_.interpolation == InterpolationSpace::oklab;
  const FourFloats least = is_lab ? FourFloats{0, -1, -1, 0} : FourFloats{0, 0, 0, 0};
  for (std::size_t i = 0; i < x_.size(); ++i) {
    low_[i] = least;
    high_[i] = {1, 1, 1, 0};
  }
  SFUMATO_TRY_ASSIGN(auto&& blocks, SolidBlocks::create(context_, laid_.width, laid_.height));
  std::vector<float> counts;
  TableMemory memory("the colours of a fit");
  SFUMATO_TRY(memory.resize(context_, counts, pixels_.pixel.size()));
  for (std::uint32_t i = 0; i < layers_.size(); ++i) {
    SFUMATO_TRY(narrow_bounds(i, blocks, counts));
  }
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (is_shown(i)) continue;
    low_[i].fill(-kUnbound);
    high_[i].fill(kUnbound);
  }
  return ok_status();
}

/// Sums over the stops of a layer. blocks, counts: tables for this, the latter a number a pixel
Status StopFit::narrow_bounds(std::uint32_t layer, SolidBlocks& blocks,
                              std::vector<float>& counts) {
  std::vector<Affine> pixel_from_layer;
  blocks.clear();
  std::ranges::fill(counts, 0.0f);
  for (const ShownInstance& shown : points_.shown) {
    if (shown.layer != layer) continue;
    pixel_from_layer.push_back(inverse(shown.sight.layer_from_pixel));
    for (std::size_t i = 0; i < shown.coefficient.size(); ++i) {
      const std::uint32_t pixel = points_.pixel_of[shown.sight.point[i]];
      const std::uint32_t points = pixels_.point_begin[pixel + 1] - pixels_.point_begin[pixel];
      counts[pixel] += shown.coefficient[i][3] / static_cast<float>(points);
    }
  }
  if (pixel_from_layer.empty()) return context_.check();
  for (std::size_t i = 0; i < counts.size(); ++i) blocks.add(pixels_.pixel[i], counts[i] > kSolid);
  const std::vector<Curve>& curves = drawing_.layers[layer].curves;
  const std::size_t first = first_stop_[layer];
  const std::size_t count = curves::stop_count(curves, StopAttribute::color);
  return find_stop_ranges(context_, curves, pixel_from_layer, is_in_srgb() ? picture_.code : color_,
                          blocks, std::span(weight_).subspan(first, count),
                          std::span(low_).subspan(first, count),
                          std::span(high_).subspan(first, count));
}

double StopFit::radius_of(const ShownInstance& shown, const gather::RowSource& source,
                          const gather::RowTerm& term) const {
  const double factor = factor_[first_curve_[shown.layer] + source.curve];
  return factor * gather::radius_at(source, term.moment);
}

/// In the interpolation space.
Rgb StopFit::color_of(const Part& part) const {
  const ShownInstance& shown = points_.shown[part.shown];
  const InstanceSight& sight = shown.sight;
  const ShadersAt shaders{points_.color_shaders, layers_[shown.layer]->color_places.shader,
                          sight.layer_from_pixel, pixels_.point[sight.point[part.row]]};
  const auto radius = [&](const gather::RowSource& source, const gather::RowTerm& term) {
    return radius_of(shown, source, term);
  };
  return row_color(sight.rows, part.row, std::span(x_).subspan(first_stop_[shown.layer]), radius,
                   shaders);
}

StopFit::Missing StopFit::missing_of(std::size_t pixel) const {
  Missing missing{};
  if (points_.is_left_out[pixel]) return missing;
  const InterpolationSpace space = drawing_.interpolation;
  const std::uint32_t first = pixels_.point_begin[pixel], end = pixels_.point_begin[pixel + 1];
  std::array<double, 3> code{}, whole{};
  for (std::uint32_t p = first; p < end; ++p) {
    for (std::size_t c = 0; c < 3; ++c) code[c] += double{points_.fixed[p][c]} / (end - first);
  }
  for_each_part(pixel, [&](const Part& part, double share, const FourFloats& coefficient) {
    const FourFloats shown = four(clamped_color(to_srgb(space, color_of(part))));
    for (std::size_t c = 0; c < 3; ++c) {
      code[c] += share * coefficient[c] * shown[c];
      whole[c] += share * coefficient[c];
    }
  });
  FourFloats change{};  // of each part
  for (std::size_t c = 0; c < 3; ++c) {
    const double lacks = picture_.code[c].value[pixels_.pixel[pixel]] - code[c];
    missing.code[c] = static_cast<float>(lacks);
    change[c] = static_cast<float>(whole[c] > 0 ? lacks / whole[c] : 0.0);
  }
  for_each_part(pixel, [&](const Part& part, double share, const FourFloats& coefficient) {
    FourFloats step = change;
    if (!is_in_srgb()) {
      const Rgb color = color_of(part);
      const Rgb shown = clamped_color(to_srgb(space, color));
      const Rgb to = from_srgb(
          space, clamped_color({shown.r + change[0], shown.g + change[1], shown.b + change[2]}));
      step = {to.r - color.r, to.g - color.g, to.b - color.b, 0};
    }
    for (std::size_t c = 0; c < 3; ++c) {
      missing.color[c] += static_cast<float>(share * coefficient[3] * step[c]);
    }
  });
  return missing;
}

Status StopFit::find_missing() {
  SFUMATO_TRY(
      parallel_for(context_, missing_.size(), kPixelsPerTask, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) missing_[i] = missing_of(i);
      }));
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < missing_.size(); ++i) {
    if (points_.is_left_out[i]) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += double{pixels_.stands_for[i]} * missing_[i].code[c] * missing_[i].code[c];
    }
    count += 3.0 * pixels_.stands_for[i];
  }
  psnr_db_ = sum > 0 ? -10 * std::log10(sum / count) : 100.0;
  return ok_status();
}

Status StopFit::fit_colors() {
  SFUMATO_TRY_ASSIGN(auto&& transpose, transposed(context_, matrix_));
  SFUMATO_TRY_ASSIGN(auto&& normal, normal_matrix(context_, matrix_, transpose, {}));
  TableMemory memory("the colours of a fit");
  std::vector<FourFloats> wanted, right_side;
  std::vector<float> pull;
  SFUMATO_TRY(memory.resize(context_, wanted, missing_.size()));
  SFUMATO_TRY(memory.resize(context_, right_side, x_.size()));
  SFUMATO_TRY(memory.resize(context_, pull, x_.size(), kPull));
  SFUMATO_TRY(multiply(context_, matrix_, x_, wanted));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) wanted[i][c] += missing_[i].color[c];
  }
  SFUMATO_TRY(multiply(context_, transpose, wanted, right_side));
  SFUMATO_TRY(
      solve_bounded(context_, {normal, right_side, has_next_, low_, high_, pull, kEven}, x_));
  return find_missing();
}

}  // namespace sfumato::tracing
