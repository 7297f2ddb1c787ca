#include "formats/svg/read/namespaces.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr std::string_view kSvg = "http://www.w3.org/2000/svg";
constexpr std::string_view kXlink = "http://www.w3.org/1999/xlink";
constexpr std::string_view kSfumato = "urn:sfumato:1";
constexpr std::string_view kAnySfumato = "urn:sfumato:";

enum class Space : unsigned char { svg, xlink, sfumato, other };

struct QualifiedName {
  std::string_view prefix;
  std::string_view local;
};

QualifiedName split(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return {{}, name};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

class Resolver {
 public:
  Resolver(const Context& context, text::XmlSource& xml)
      : context_(context), poll_(context), xml_(xml) {}

  Status resolve(pugi::xml_node element);

 private:
  Status bind(pugi::xml_node element, std::vector<std::string_view>& bound);
  Status resolve_attributes(pugi::xml_node element);
  Status resolve_children(pugi::xml_node element);
  Status space_of(pugi::xml_node element, std::string_view prefix, Space& space);
  Space element_space(std::string_view prefix) const;
  Status error(pugi::xml_node element, std::string message) {
    return make_error(StatusCode::bad_input, std::move(message), xml_.place(element));
  }

  const Context& context_;
  RarePoll<256> poll_;
  text::XmlSource& xml_;
  /// The present meanings of each prefix, the innermost last; the empty prefix is the default
  /// namespace.
  std::map<std::string_view, std::vector<Space>> meanings_;
};

Status Resolver::resolve(pugi::xml_node element) {
  std::vector<std::string_view> bound;
  Status status = bind(element, bound);
  if (status) status = resolve_attributes(element);
  if (status) status = resolve_children(element);
  for (const std::string_view prefix : bound) meanings_[prefix].pop_back();
  return status;
}

Status Resolver::bind(pugi::xml_node element, std::vector<std::string_view>& bound) {
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name != "xmlns" && !name.starts_with("xmlns:")) continue;
    const std::string_view uri = attribute.value();
    const std::string_view prefix = name == "xmlns" ? std::string_view() : name.substr(6);
    // Illustrator writes entities of its DTD, which are not expanded, for SVG's own namespace.
    const bool is_svg = uri == kSvg || (prefix.empty() && (uri.empty() || uri.starts_with('&')));
    const Space space = is_svg            ? Space::svg
                        : uri == kXlink   ? Space::xlink
                        : uri == kSfumato ? Space::sfumato
                                          : Space::other;
    if (space == Space::other && uri.starts_with(kAnySfumato)) {
      return error(element, "the namespace " + text::quoted(uri) +
                                " is not known; use \"urn:sfumato:1\", the format that this "
                                "version reads");
    }
    meanings_[prefix].push_back(space);
    bound.push_back(prefix);
  }
  return ok_status();
}

Status Resolver::space_of(pugi::xml_node element, std::string_view prefix, Space& space) {
  const auto found = meanings_.find(prefix);
  if (found != meanings_.end() && !found->second.empty()) {
    space = found->second.back();
    return ok_status();
  }
  space = prefix == "xlink" ? Space::xlink : Space::other;
  if (prefix != "sf") return ok_status();
  return error(element, "the prefix sf is not declared; add xmlns:sf=\"urn:sfumato:1\" on <svg>");
}

Space Resolver::element_space(std::string_view prefix) const {
  const auto found = meanings_.find(prefix);
  if (found != meanings_.end() && !found->second.empty()) return found->second.back();
  return prefix.empty() ? Space::svg : Space::other;
}

Status Resolver::resolve_attributes(pugi::xml_node element) {
  bool has_href = static_cast<bool>(element.attribute("href"));
  std::vector<std::string_view> ours;
  for (pugi::xml_attribute attribute : element.attributes()) {
    const QualifiedName name = split(attribute.name());
    if (name.local.size() == std::string_view(attribute.name()).size()) continue;
    if (name.prefix == "xmlns" || name.prefix == "xml") continue;
    Space space = Space::other;
    SFUMATO_TRY(space_of(element, name.prefix, space));
    if (space == Space::sfumato) {
      // No longer than it was: the tree takes no memory for it.
      attribute.set_name((":" + std::string(name.local)).c_str());
      ours.push_back(attribute.name());
    } else if (space == Space::xlink && name.local == "href" && !has_href) {
      attribute.set_name("href");
      has_href = true;
    } else if (name.prefix.empty()) {
      attribute.set_name("-");  // ":left" as the file has it is not ours
    }
  }
  std::ranges::sort(ours);
  const auto twice = std::ranges::adjacent_find(ours);
  if (twice == ours.end()) return ok_status();
  return error(element, "the attribute \"sf" + std::string(twice->substr(0, 64)) +
                            "\" is given twice, by two prefixes of urn:sfumato:1");
}

Status Resolver::resolve_children(pugi::xml_node element) {
  for (pugi::xml_node child = element.first_child(), next; child; child = next) {
    next = child.next_sibling();
    if (poll_.cancelled()) return context_.cancel_status();
    if (child.type() != pugi::node_element) continue;
    const QualifiedName name = split(child.name());
    const pugi::xml_attribute own = child.attribute(
        name.prefix.empty() ? "xmlns" : ("xmlns:" + std::string(name.prefix)).c_str());
    Space space = element_space(name.prefix);
    if (own) {
      const std::string_view uri = own.value();
      space = uri == kSvg || (uri.empty() && name.prefix.empty()) ? Space::svg
              : uri == kSfumato                                   ? Space::sfumato
                                                                  : Space::other;
    }
    if (space == Space::sfumato) {
      return error(child, "the element <" + std::string(child.name()).substr(0, 64) +
                              "> means nothing; the namespace urn:sfumato:1 has attributes only");
    }
    if (space != Space::svg) {
      element.remove_child(child);
      continue;
    }
    if (!name.prefix.empty()) child.set_name(std::string(name.local).c_str());
    SFUMATO_TRY(resolve(child));
  }
  return ok_status();
}

}  // namespace

Status resolve_namespaces(const Context& context, text::XmlSource& xml) {
  pugi::xml_node root = xml.root();
  const QualifiedName name = split(root.name());
  if (!name.prefix.empty()) root.set_name(std::string(name.local).c_str());
  return Resolver(context, xml).resolve(root);
}

}  // namespace sfumato::svg
