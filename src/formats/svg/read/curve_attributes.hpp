#pragma once

#include <cstdint>
#include <vector>

#include "formats/svg/paint/paints.hpp"
#include "formats/svg/paint/stop_list.hpp"
#include "formats/svg/read/input.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::svg {

/// The attributes of a side before they are applied to a subpath.
template <class Value>
struct WrittenShader {
  ShaderKind kind = ShaderKind::open;
  std::vector<WrittenStop<Value>> stops{};
  std::uint32_t shader = 0;
};

struct WrittenSide {
  WrittenShader<Rgb> color{};
  WrittenShader<float> opacity{};
  std::vector<WrittenStop<float>> blur_radius{};  ///< user units
};

struct CurveAttributes {
  WrittenSide left{};
  WrittenSide right{};
  double weight = 1;

  /// Returns the number of stops that each curve will have.
  std::size_t stop_count() const;
};

struct LocalAttributes {
  std::vector<WrittenStop<Rgb>> left_color{};
  std::vector<WrittenStop<Rgb>> right_color{};
  std::vector<WrittenStop<float>> blur_radius{};
  std::vector<WrittenStop<float>> influence_radius{};
  double alpha = 1;

  std::size_t stop_count() const;
};

/// Reads the attributes of a diffusion curve; their stops are allocated from `memory`.
/// Errors: bad_input, limit, cancelled, out_of_memory.
Result<CurveAttributes> read_curve_attributes(Input& input, Paints& paints,
                                              const PaintedShape& shape, TableMemory& memory);

/// The same for the attributes of a local curve. Errors: bad_input, limit, cancelled.
Result<LocalAttributes> read_local_attributes(Input& input, Element shape, TableMemory& memory);

}  // namespace sfumato::svg
