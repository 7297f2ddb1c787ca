#include "formats/text/warnings.hpp"

#include <utility>

#include "sfumato/base/limits.hpp"

namespace sfumato::text {

bool Warnings::is_new(std::string_view kind) {
  if (kinds_.contains(kind)) return false;
  if (kinds_.size() < limits::kWarnings) return kinds_.emplace(kind).second;
  ++left_out_;
  return false;
}

void Warnings::add(std::string message, SourcePlace place) {
  warnings_.push_back({std::move(message), std::move(place)});
}

std::vector<Diagnostic> Warnings::take() {
  if (left_out_ > 0) {
    add("and " + std::to_string(left_out_) + " more of other kinds",
        {warnings_.empty() ? std::string() : warnings_.front().where.file});
    left_out_ = 0;
  }
  return std::move(warnings_);
}

}  // namespace sfumato::text
