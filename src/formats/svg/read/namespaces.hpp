#pragma once

#include "formats/text/xml_source.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Normalizes names: elements of SVG lose their prefix, xlink:href becomes href, attributes of
/// Sfumato's namespace are called ":left" whatever their prefix was, and elements of other
/// namespaces are removed. Errors: bad_input if Sfumato's namespace is used in a way that has no
/// meaning.
Status resolve_namespaces(const Context& context, text::XmlSource& xml);

}  // namespace sfumato::svg
