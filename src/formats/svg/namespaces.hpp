#pragma once

#include "formats/text/xml_source.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Makes names plain: elements of SVG lose their prefix, xlink:href becomes href, attributes of
/// Sfumato's namespace are called ":left" whatever their prefix was; elements of other namespaces
/// are taken out. Errors: bad_input where Sfumato's namespace is used in a way that means nothing.
Status resolve_namespaces(const Context& context, text::XmlSource& xml);

}  // namespace sfumato::svg
