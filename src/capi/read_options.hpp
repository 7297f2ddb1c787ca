#pragma once

#include <utility>

#include "capi/context.hpp"
#include "options/option_reader.hpp"

namespace sfumato::capi {

/// Sets what a call's options say, NULL for none, by those of a table that it knows. Errors: bad
/// usage.
template <class Table, class Settings>
Outcome read_options(const char* text, options::Call call, const Table& table, Settings& settings) {
  options::OptionReader reader(call);
  reader.take(table, settings);
  Status status = reader.read(text ? text : "");
  return status ? Outcome{} : bad_usage(std::move(status));
}

}  // namespace sfumato::capi
