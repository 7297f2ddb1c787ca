#pragma once

#include <optional>
#include <pugixml.hpp>
#include <span>

namespace sfumato::svg {

/// An element, and the elements that it inherits from: the elements around it in the document or,
/// for content of <use>, around the place where it is drawn.
class StyleScope {
 public:
  /// Inherits from its parents in the document.
  StyleScope(pugi::xml_node element) : element_(element) {}  // NOLINT: implicit on purpose
  /// around   the elements around the place where it is drawn, the outermost first; they outlive
  /// this
  StyleScope(pugi::xml_node element, std::span<const pugi::xml_node> around)
      : element_(element), around_(around) {}

  pugi::xml_node element() const { return element_; }
  /// Returns whether it inherits from its parents in the document.
  bool is_of_document() const { return !around_; }
  /// Returns the scope that it inherits from; without an element at the end.
  StyleScope outer() const {
    if (around_) {
      if (around_->empty()) return StyleScope(pugi::xml_node());
      return StyleScope(around_->back(), around_->first(around_->size() - 1));
    }
    const pugi::xml_node parent = element_.parent();
    return parent.type() == pugi::node_element ? parent : pugi::xml_node();
  }
  explicit operator bool() const { return static_cast<bool>(element_); }

 private:
  pugi::xml_node element_;
  std::optional<std::span<const pugi::xml_node>> around_;
};

}  // namespace sfumato::svg
