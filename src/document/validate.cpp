#include <cmath>
#include <string>

#include "base/limits.hpp"
#include "document/document.hpp"

namespace sfumato {

Status validate(const Document& document) {
  if (document.artboard.empty()) return make_error(StatusCode::bad_input, "the artboard is empty");
  return ok_status();
}

}  // namespace sfumato
