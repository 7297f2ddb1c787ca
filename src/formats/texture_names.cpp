#include "formats/texture_names.hpp"

#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "codecs/gunzip.hpp"
#include "formats/svg/paint/texture_files.hpp"
#include "formats/svg/read/namespaces.hpp"
#include "formats/text/xml_source.hpp"

namespace sfumato::formats {
namespace {

class NameWalker final : public pugi::xml_tree_walker {
 public:
  NameWalker(const Context& context, const std::function<void(const std::string&)>& visit)
      : context_(context), poll_(context), visit_(visit) {}

  /// Ok, or why the walk ended early.
  const Status& status() const { return status_; }

  bool for_each(pugi::xml_node& node) override {
    using namespace std::string_view_literals;
    if (node.name() == "image"sv && node.parent().name() == "pattern"sv) {
      const auto name = svg::file_name_in(ascii_trimmed(node.attribute("href").value()));
      if (name) visit_(*name);
    }
    if (poll_.cancelled()) status_ = context_.cancel_status();
    return status_.ok();
  }

 private:
  const Context& context_;
  RarePoll<256> poll_;  // a visit may ask the file system
  const std::function<void(const std::string&)>& visit_;
  Status status_;
};

Status visit_in_text(Context& context, std::string_view text, const std::string& file,
                     const std::function<void(const std::string&)>& visit) {
  text::XmlSource xml(text, file);
  SFUMATO_TRY(xml.parse(context));
  SFUMATO_TRY(svg::resolve_namespaces(context, xml));
  NameWalker walker(context, visit);
  xml.root().traverse(walker);
  return walker.status() ? context.check() : walker.status();
}

Status visit_in_bytes(Context& context, std::string_view bytes, const std::string& file,
                      const std::function<void(const std::string&)>& visit) {
  if (!codecs::is_gzip(bytes)) return visit_in_text(context, bytes, file, visit);
  TableMemory memory("unpacked gzip");
  const Result<std::string> text = codecs::gunzip(context, bytes, memory);
  return text ? visit_in_text(context, *text, file, visit) : text.status();
}

}  // namespace

Status visit_texture_names(Context& context, std::string_view bytes, const std::string& file,
                           const std::function<void(const std::string& name)>& visit) {
  return public_verb(context, [&] { return visit_in_bytes(context, bytes, file, visit); });
}

}  // namespace sfumato::formats
