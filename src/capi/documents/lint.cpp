#include "sfumato/lint/lint.hpp"

#include <utility>

#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/documents/document.hpp"
#include "capi/documents/read_options.hpp"
#include "lint/hint_list.hpp"
#include "options/tables.hpp"

namespace sfumato::capi {
namespace {

Outcome list_hints(Workshop& workshop, const sfumato_document* handle, const char* text,
                   sfumato_bytes** out) {
  if (!handle) return bad_usage("NULL given; pass a document");
  options::LintSettings settings;
  SFUMATO_TRY(read_options(text, options::kLint, options::lint_options(), settings));
  SFUMATO_TRY_ASSIGN(auto&& hints, lint(workshop.context, handle->document));
  if (!settings.verbose) std::erase_if(hints, [](const Hint& hint) { return is_note(hint.kind); });
  SFUMATO_TRY_ASSIGN(auto&& json, lint_detail::hints_json(workshop.context, handle->origin.name,
                                                          handle->document, hints));
  *out = new sfumato_bytes{std::move(json)};
  return {};
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_lint(sfumato_context* context, const sfumato_document* document,
                     const char* options, sfumato_bytes** json) {
  return sfumato::capi::make(context, json, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::list_hints(workshop, document, options, json);
  });
}
