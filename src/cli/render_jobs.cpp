#include "cli/render_jobs.hpp"

#include <filesystem>
#include <map>

#include "cli/paths.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

std::string in_quotes(const std::string& path) {
  return '"' + path + '"';
}

}  // namespace

std::vector<RenderJob> render_jobs(const std::vector<std::string>& inputs,
                                   const std::string& output, const std::string& folder,
                                   const std::string& extension) {
  if (folder.empty()) return {{inputs.front(), output}};
  std::vector<RenderJob> jobs;
  for (const std::string& input : inputs) {
    // "drawing.svg.gz" and "drawing.svgz" both become "drawing".
    fs::path name = fs::path(input).filename();
    if (name.extension() == ".gz") name = name.stem();
    jobs.push_back({input, (fs::path(folder) / name.stem()).string() + '.' + extension});
  }
  return jobs;
}

std::string complaint_about(const std::vector<RenderJob>& jobs) {
  std::map<std::string, std::string> input_of;
  for (const RenderJob& job : jobs) {
    if (job.output == "-") continue;
    const auto [other, is_new] = input_of.emplace(job.output, job.input);
    if (!is_new) {
      return in_quotes(other->second) + " and " + in_quotes(job.input) + " would both become " +
             in_quotes(job.output);
    }
  }
  std::map<FileIdentity, std::string> drawing_of;
  for (const RenderJob& job : jobs) {
    if (const auto identity = file_identity(job.input)) drawing_of.emplace(*identity, job.input);
  }
  for (const RenderJob& job : jobs) {
    const auto identity = file_identity(job.output);
    if (!identity) continue;
    const auto drawing = drawing_of.find(*identity);
    if (drawing != drawing_of.end()) {
      return "the picture would replace the drawing " + in_quotes(drawing->second);
    }
  }
  return {};
}

}  // namespace sfumato::cli
