#include "cli/render_jobs.hpp"

#include <filesystem>

namespace sfumato::cli {

namespace fs = std::filesystem;

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

}  // namespace sfumato::cli
