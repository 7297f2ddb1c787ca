#pragma once

#include <utility>

#include "capi/context.hpp"
#include "options/option_reader.hpp"
#include "options/settle.hpp"

namespace sfumato::capi {

/// Sets the options of a call (NULL: none) by the entries of a table that the call knows. Errors:
/// bad usage.
template <class Table, class Settings>
Outcome read_options(const char* text, options::Call call, const Table& table, Settings& settings) {
  options::OptionReader reader(call);
  reader.take(table, settings);
  Status status = reader.read(text ? text : "");
  return status ? Outcome{} : bad_usage(std::move(status));
}

/// Returns bad usage for a conflict, if there is one.
inline Outcome expect_none(const options::Conflict& conflict) {
  if (conflict.key.empty()) return {};
  return bad_usage(options::spelled(conflict.key, false) + ": " +
                   options::spelled(conflict.complaint, false));
}

}  // namespace sfumato::capi
