#pragma once

#include "formats/svg/read/input.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

bool is_shape(std::string_view element_name);

/// Fails if the element has an attribute of Sfumato's namespace that does not exist or has no
/// meaning there. Errors: bad_input.
Status check_sf_attributes(Input& input, Element element);

}  // namespace sfumato::svg
