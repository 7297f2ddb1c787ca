#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::solve {

/// Gives the layers of a picture of the document their exact fields, but for those of which nothing
/// is seen, and those with image-domain shaders. Errors: limit, cancelled.
Status add_exact_fields(Context& context, const Document& document, const DiffuseOptions& options,
                        Picture* picture);

}  // namespace sfumato::solve
