#include "base/status.hpp"

namespace sfumato {

std::string to_string(const Status& status) {
  std::string text = status.where.file;
  if (status.where.line > 0) {
    text += ":" + std::to_string(status.where.line);
    if (status.where.column > 0) text += ":" + std::to_string(status.where.column);
  }
  if (!text.empty()) text += ": ";
  return text + status.message;
}

}  // namespace sfumato
