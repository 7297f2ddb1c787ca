#pragma once

#include <utility>

#include "capi/context.hpp"
#include "options/option_reader.hpp"

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

}  // namespace sfumato::capi
