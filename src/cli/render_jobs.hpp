#pragma once

#include <string>
#include <vector>

namespace sfumato::cli {

/// One document of a call of `sfumato render` and where its picture goes.
struct RenderJob {
  std::string input;
  std::string output;
};

/// What becomes of `inputs`: one of them goes to `output`, or each, named as it is but for its
/// extension, to `folder`. Either is given.
std::vector<RenderJob> render_jobs(const std::vector<std::string>& inputs,
                                   const std::string& output, const std::string& folder,
                                   const std::string& extension);

}  // namespace sfumato::cli
