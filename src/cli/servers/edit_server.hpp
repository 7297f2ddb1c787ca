#pragma once

#include <memory>
#include <string>

#include "cli/options/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// Serves the editor's page on 127.0.0.1 for one drawing. All its answers lie below a secret path:
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
  /// `page`: the file that `make editor` made. Arguments and context must outlive this object, and
  /// nothing else may use them until it ends. Errors: io.
  static Result<std::unique_ptr<EditServer>> start(const EditArguments& arguments, Context& context,
                                                   std::string page);
  ~EditServer();
  EditServer(const EditServer&) = delete;
  EditServer& operator=(const EditServer&) = delete;

  /// Returns the address with the secret: everyone who has it can read and write the drawing.
  std::string address() const;
  /// Returns an address that leads there once. Other users may see it in the list of processes, but
  /// then it no longer works.
  std::string address_for_once() const;

 private:
  class Answers;
  explicit EditServer(std::unique_ptr<Answers> answers);

  std::unique_ptr<Answers> answers_;
};

}  // namespace sfumato::cli
