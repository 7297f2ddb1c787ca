#include "capi/context.hpp"

#include <algorithm>
#include <cstring>

#include "base/try.hpp"
#include "options/option_reader.hpp"
#include "options/tables.hpp"

namespace sfumato::capi {
namespace {

/// Sets up a context by the options of sfumato_context_new().
Outcome equip(const char* text, sfumato_context& context) {
  options::Settings settings;
  options::Resources resources;
  options::ContextSettings own;
  options::OptionReader reader(options::kContext);
  reader.take(options::render_options(), settings);
  reader.take(options::resource_options(), resources);
  reader.take(options::context_options(), own);
  reader.take_limits(resources.limits);
  if (Status status = reader.read(text ? text : ""); !status) return bad_usage(std::move(status));
  auto workshop =
      std::make_shared<Workshop>(settings.threads, resources.memory_bytes, resources.limits);
  workshop->seconds = resources.seconds;
  workshop->context.simd = own.simd.value_or(workshop->context.simd);
  SFUMATO_TRY(validate(workshop->context));
  context.workshop = std::move(workshop);
  return {};
}

}  // namespace

void ToldProgress::report(std::string_view stage, double fraction) {
  char word[32] = {};
  std::memcpy(word, stage.data(), std::min(stage.size(), sizeof word - 1));
  function(user, word, fraction);
}

}  // namespace sfumato::capi

using sfumato::capi::caught;
using sfumato::capi::Outcome;

const char* sfumato_version(void) {
  return SFUMATO_VERSION;
}

uint32_t sfumato_abi(void) {
  return SFUMATO_ABI;
}

sfumato_context* sfumato_context_new(const char* options) {
  std::unique_ptr<sfumato_context> context(new (std::nothrow) sfumato_context);
  if (!context) return nullptr;
  context->last = caught([&] { return sfumato::capi::equip(options, *context); });
  return context->last.code == SFUMATO_OUT_OF_MEMORY ? nullptr : context.release();
}

void sfumato_context_free(sfumato_context* context) {
  // Objects made by the call may still use the work's context.
  if (context && context->workshop) context->workshop->context.progress = nullptr;
  delete context;
}

const char* sfumato_error_text(const sfumato_context* context) {
  return context ? context->last.status.message.c_str() : "no context";
}

const char* sfumato_error_file(const sfumato_context* context) {
  return context ? context->last.status.where.file.c_str() : "";
}

void sfumato_error_place(const sfumato_context* context, int32_t* line, int32_t* column) {
  if (line) *line = context ? context->last.status.where.line : 0;
  if (column) *column = context ? context->last.status.where.column : 0;
}

const char* sfumato_warning(const sfumato_context* context, size_t index) {
  if (!context || index >= context->warnings.size()) return nullptr;
  return context->warnings[index].c_str();
}

void sfumato_set_progress(sfumato_context* context, sfumato_progress_fn progress, void* user) {
  if (!context || !context->workshop) return;
  context->progress.function = progress;
  context->progress.user = user;
  context->workshop->context.progress = progress ? &context->progress : nullptr;
}

void sfumato_cancel(sfumato_context* context) {
  if (context && context->workshop) context->workshop->context.cancel.store(true);
}

void sfumato_resume(sfumato_context* context) {
  if (context && context->workshop) context->workshop->context.cancel.store(false);
}
