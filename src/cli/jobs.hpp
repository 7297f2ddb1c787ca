#pragma once

#include <string>
#include <vector>

namespace sfumato::cli {

/// One document of a call of `sfumato render` and the destination of its picture.
struct RenderJob {
  std::string input;
  std::string output;
};

/// The jobs for `inputs`: either a single input is written to `output`, or each input is written to
/// `folder` under its own name with another extension. Exactly one of the two is given.
std::vector<RenderJob> render_jobs(const std::vector<std::string>& inputs,
                                   const std::string& output, const std::string& folder,
                                   const std::string& extension);

}  // namespace sfumato::cli
