#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "cli/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// The editor's page on 127.0.0.1, for one drawing. All that it answers lies below a secret path:
///
///   GET  SECRET/              the page, with <meta name="sfumato-file" content="NAME">
///   GET  SECRET/drawing       the file's bytes, with an ETag
///   PUT  SECRET/drawing       replaces it; If-Match names an ETag, or is "*". 204, or 412 where
///   the
///                             file has changed since
///   GET  SECRET/file?HREF     a PNG or JPEG that the drawing names, where FolderLoader allows it
///
/// Everything else is 404. Runs its own thread.
class EditServer {
 public:
  /// `page`: what `make editor` made. Arguments and context must outlive this, and be left alone
  /// until it ends. Errors: io.
  static Result<std::unique_ptr<EditServer>> start(const EditArguments& arguments, Context& context,
                                                   std::string page);
  ~EditServer();
  EditServer(const EditServer&) = delete;
  EditServer& operator=(const EditServer&) = delete;

  /// With the secret: whoever has it reads and writes the drawing.
  std::string address() const;
  /// One that leads there once. Other users may see it in the list of processes, and come too late.
  std::string address_for_once() const;

 private:
  class Answers;
  explicit EditServer(std::unique_ptr<Answers> answers);

  std::unique_ptr<Answers> answers_;
};

}  // namespace sfumato::cli
