#include <algorithm>

#include "cli/file_uses.hpp"
#include "cli/paths.hpp"
#include "cli/render_options.hpp"

namespace sfumato::cli {
namespace {

constexpr double kMaxErrorOf16Bits = 0.25;

/// Throws where `given` and what it needs are not there together.
void expect(bool good, const char* option, const std::string& complaint) {
  if (!good) throw CLI::ValidationError(option, complaint);
}

/// No picture and no stats may replace a drawing that is read, or one another.
void settle_file_uses(RenderArguments& arguments) {
  std::vector<InputFile> inputs;
  std::vector<OutputFile> outputs;
  for (const RenderJob& job : arguments.jobs) {
    inputs.push_back({job.input, "the drawing"});
    outputs.push_back({job.output, "the picture", in_quotes(job.input)});
  }
  std::string complaint = complaint_about(inputs, outputs);
  expect(complaint.empty(), arguments.many ? "--out-dir" : "--output", complaint);
  if (!arguments.stats.empty()) outputs.push_back({arguments.stats, "the figures", "--stats"});
  complaint = complaint_about(inputs, outputs);
  expect(complaint.empty(), "--stats", complaint);
  for (const OutputFile& output : outputs) arguments.outputs.push_back(output.path);
}

void settle_files(RenderArguments& arguments, const RenderChoices& choices) {
  arguments.many = !choices.output_folder.empty();
  arguments.output_folder = choices.output_folder;
  expect(arguments.many || !choices.output.empty(), "--output", "expected, or --out-dir");
  expect(arguments.many || choices.inputs.size() == 1, "IN",
         "several drawings given, expected --out-dir for their pictures");
  const bool reads_stdin = std::count(choices.inputs.begin(), choices.inputs.end(), "-") > 0;
  expect(!arguments.many || !reads_stdin, "--out-dir", "stdin has no name, expected -o");
  expect(!choices.format || arguments.many || choices.output == "-", "--format",
         "expected with --out-dir or '-o -' only: a file's extension says it");
  arguments.output.kind = arguments.many || choices.output == "-"
                              ? choices.format.value_or(OutputKind::png)
                              : *output_kind(choices.output);
  arguments.jobs =
      render_jobs(choices.inputs, choices.output, choices.output_folder, choices.extension);
  expect(choices.output != "-" || arguments.stats != "-", "--stats",
         "stdout is taken by the picture, expected a file name");
  settle_file_uses(arguments);
}

/// What only images have, or only outputs that can be enlarged.
void settle_kind(RenderArguments& arguments, const RenderChoices& choices) {
  OutputOptions& output = arguments.output;
  const bool is_svg = output.kind == OutputKind::svg;
  if (is_image(output.kind)) {
    const char* complaint = "expected with HTML, PDF, EPS, SVG and GLB only";
    expect(!choices.detail, "--detail", complaint);
    expect(!output.dpi, "--dpi", complaint);
    expect(output.title.empty(), "--title", complaint);
  } else {
    const char* complaint = "expected with images only";
    expect(choices.method != RenderMethod::pixels, "--method pixels", complaint);
    expect(choices.device == RenderDevice::cpu, "--device gpu", complaint);
    expect(!arguments.raster.mesh_overlay, "--mesh-overlay", complaint);
    expect(!choices.dither, choices.dither.value_or(true) ? "--dither" : "--no-dither", complaint);
    expect(!choices.no_antialias, "--no-antialias", complaint);
    expect(!(arguments.size.width && arguments.size.height), "--height",
           "expected without --width: only images are stretched");
  }
  expect(is_svg || !choices.svg, "--svg", "expected with SVG only");
  output.svg = choices.svg.value_or(output.svg);
  expect(!output.force || (is_svg && output.svg == SvgMode::vector), "--force",
         "expected with --svg vector only");
  // Triangles of a vector SVG are dear.
  output.detail = choices.detail.value_or(output.svg == SvgMode::vector ? 1 : 2);
  arguments.on_gpu = choices.device == RenderDevice::gpu;
}

void settle_image(RenderArguments& arguments, const RenderChoices& choices) {
  OutputOptions& output = arguments.output;
  const bool is_webp = output.kind == OutputKind::webp;
  expect(!output.lossless || is_webp, "--lossless", "expected with WebP only");
  expect(!choices.quality || output.kind == OutputKind::jpeg || (is_webp && !output.lossless),
         "--quality", "expected with JPEG and lossy WebP only");
  output.quality = choices.quality.value_or(output.quality);
  expect(choices.depth == 8 || output.kind == OutputKind::png, "--depth",
         "16 bits given, expected with PNG only");
  expect(!arguments.no_background || output.kind != OutputKind::jpeg, "--background",
         "none given, but JPEG has no alpha channel");
  expect(!choices.dither || choices.depth == 8,
         choices.dither.value_or(true) ? "--dither" : "--no-dither",
         "expected with --depth 8 only");
  // A JPEG keeps too little of the noise to be worth its bytes.
  const bool is_jpeg = output.kind == OutputKind::jpeg;
  arguments.raster.dither = choices.depth == 8 && choices.dither.value_or(!is_jpeg);
  // What is missed by a code value shows where there are 257 steps to one.
  if (choices.depth == 16 && !choices.sets_max_error) {
    arguments.diffuse.max_error = kMaxErrorOf16Bits;
  }
  arguments.raster.antialias = !choices.no_antialias;
  arguments.raster.format = choices.depth == 8 ? PixelFormat::rgb8 : PixelFormat::rgb16;
}

}  // namespace

void settle(RenderArguments& arguments, const RenderChoices& choices) {
  settle_files(arguments, choices);
  settle_kind(arguments, choices);
  settle_image(arguments, choices);
  expect(!arguments.size.scale || !(arguments.size.width || arguments.size.height), "--scale",
         "expected without --width and --height");
  expect(!arguments.raster.mesh_overlay || choices.method != RenderMethod::pixels, "--mesh-overlay",
         "--method pixels has no mesh to draw");
  expect(!arguments.on_gpu || choices.method != RenderMethod::pixels, "--device",
         "--method pixels runs on the CPU only");
  arguments.per_pixel = choices.method == RenderMethod::pixels;
  arguments.diffuse.gather.method =
      choices.method == RenderMethod::rays ? gather::Method::rays : gather::Method::exact;
}

}  // namespace sfumato::cli
