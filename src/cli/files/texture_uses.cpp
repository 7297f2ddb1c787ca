#include "cli/files/texture_uses.hpp"

#include <filesystem>
#include <system_error>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/file_uses.hpp"
#include "cli/files/folder_loader.hpp"
#include "cli/files/paths.hpp"
#include "formats/texture_names.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

class TextureUses {
 public:
  TextureUses(Context& context, const DocumentArguments& arguments, const JobArguments& jobs)
      : context_(context),
        arguments_(arguments),
        jobs_(jobs),
        outputs_(written_files(arguments.outputs)) {}

  void look_at(const std::string& drawing);
  const std::string& complaint() const { return complaint_; }

 private:
  void look_at_texture(const std::string& drawing, const std::string& name);

  Context& context_;
  const DocumentArguments& arguments_;
  const JobArguments& jobs_;
  const FilesByIdentity outputs_;
  std::string complaint_;
};

void TextureUses::look_at_texture(const std::string& drawing, const std::string& name) {
  if (!complaint_.empty() || name.find('\0') != std::string::npos) return;
  std::error_code error;
  const fs::path path = fs::weakly_canonical(folder_of(drawing) / fs::path(name), error);
  if (error) return;
  const auto identity = file_identity(path.string(), FileUse::reads);
  const auto output = identity ? outputs_.find(*identity) : outputs_.end();
  if (output == outputs_.end()) return;
  const bool is_stats = output->second == jobs_.stats;
  complaint_ = std::string(is_stats     ? "--stats"
                           : jobs_.film ? "--output"
                                        : "--out-dir") +
               ": " + (is_stats ? "the figures " : "the picture ") + in_quotes(output->second) +
               " would replace the texture " + in_quotes(name) + " of " + in_quotes(drawing);
}

void TextureUses::look_at(const std::string& drawing) {
  std::error_code error;
  if (!fs::is_regular_file(drawing, error)) return;
  context_.deadline = deadline_of(arguments_.resources);
  const Result<std::string> bytes = read_drawing_text(context_, drawing);
  ScopedCharge charge;
  if (!bytes || !charge.add(context_, capacity_bytes(*bytes), "the input")) return;
  // Faults of the drawing are reported when it is drawn.
  [[maybe_unused]] const Status visited = formats::visit_texture_names(
      context_, *bytes, display_name(drawing),
      [&](const std::string& name) { look_at_texture(drawing, name); });
}

}  // namespace

std::string complaint_about_textures(Context& context, const DocumentArguments& arguments,
                                     const JobArguments& jobs) {
  const bool writes_no_file = jobs.film && jobs.stats.empty() && arguments.outputs.front() == "-";
  if (!jobs.many || writes_no_file) return {};
  TextureUses uses(context, arguments, jobs);
  for (const Job& job : jobs.jobs) {
    uses.look_at(job.input);
    if (!uses.complaint().empty() || context.cancel.load()) break;
  }
  return uses.complaint();
}

}  // namespace sfumato::cli
