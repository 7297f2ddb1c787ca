// Replaces export/html/viewer_exact.cpp in a module whose pictures have no exact fields.
#include "export/html/viewer_exact.hpp"

namespace sfumato::outputs {

Status write_exact(Context&, const Picture&, ByteWriter& out) {
  return out.status();
}

Result<std::vector<std::uint8_t>> exact_alone(Context&, const ExactLayer&, InterpolationSpace) {
  return make_error(StatusCode::unavailable, "this module makes no exact fields");
}

}  // namespace sfumato::outputs
