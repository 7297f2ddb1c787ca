#include "sfumato/base/status.hpp"

namespace sfumato {

namespace {

std::string placed(const SourcePlace& where, const std::string& message) {
  std::string text = where.file;
  if (where.line > 0) {
    text += ":" + std::to_string(where.line);
    if (where.column > 0) text += ":" + std::to_string(where.column);
  }
  if (!text.empty()) text += ": ";
  return text + message;
}

}  // namespace

std::string to_string(const Status& status) {
  return placed(status.where, status.message);
}

std::string to_string(const Diagnostic& diagnostic) {
  return placed(diagnostic.where, diagnostic.message);
}

}  // namespace sfumato
