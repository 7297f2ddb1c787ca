#pragma once

#include "formats/svg/input.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

bool is_shape(std::string_view element_name);

/// Fails where the element bears an attribute of Sfumato's namespace that does not exist or that
/// means nothing there. Errors: bad_input.
Status check_sf_attributes(Input& input, Element element);

}  // namespace sfumato::svg
