#include "cli/render_options.hpp"

#include "cli/paths.hpp"
#include "cli/values.hpp"
#include "formats/css/color.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kRenderFooter =
    "Examples:\n"
    "  sfumato render lady_bug.xml -o lady_bug.png\n"
    "  sfumato render lady_bug.xml -o big.png --width 4096 --depth 16\n"
    "  sfumato render lady_bug.xml -o eye.png --viewport 200,100,64,64 --scale 8\n"
    "  sfumato render lady_bug.xml -o noisy.png --method rays --rays 64 --max-error off\n"
    "  sfumato render lady_bug.xml -o lady_bug.html\n"
    "  sfumato render lady_bug.xml -o lady_bug.pdf --title \"Lady bug\"\n"
    "  sfumato render *.svg --out-dir pictures --format webp\n"
    "  sfumato render - -o - <lady_bug.xml >lady_bug.png";

constexpr std::uint64_t kLargestCount = 1'000'000'000;
constexpr double kLargestMinAngleDeg = 33;
constexpr double kLargestMaxError = 255;

bool set_min_angle(const std::string& text, double& angle_deg) {
  const std::optional<double> value = parse_number(text);
  if (!value || *value < 0 || *value > kLargestMinAngleDeg) return false;
  angle_deg = *value;
  return true;
}

bool set_max_error(const std::string& text, double& max_error) {
  const std::optional<double> value = text == "off" ? 0 : parse_positive(text);
  if (!value || *value > kLargestMaxError) return false;
  max_error = *value;
  return true;
}

/// A colour as drawings have it; `none` and `transparent` are none.
bool set_background(const std::string& text, RenderArguments& arguments) {
  const Result<css::Color> color = css::parse_color(text);
  arguments.no_background = text == "none" || (color && color->alpha == 0);
  arguments.raster.background.reset();
  if (arguments.no_background) return true;
  if (!color || color->alpha < 1) return false;
  arguments.raster.background = color->color;
  return true;
}

void add_files(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  app.add_option("IN", choices.inputs,
                 "Diffusion curves (SVG or Orzan XML); '-': from stdin;\nseveral with --out-dir")
      ->required()
      ->type_name("");
  add_output(app, choices.output, {}, "OUT",
             "The picture, made as its extension says; '-': to\nstdout, as --format says");
  app.add_option("--out-dir", choices.output_folder,
                 "Instead: every picture into this folder, named as its\ndrawing; made where it "
                 "is not there")
      ->type_name("DIR")
      ->excludes("--output");
  add_value(app, "--format", one_of(known_extensions(), "EXTENSION"),
            "What --out-dir and '-o -' write [png]", [&choices](const std::string& text) {
              choices.extension = text;
              choices.format = kind_of_extension(text);
              return choices.format.has_value();
            });
  add_allowed_folders(app, arguments);
}

void add_solution_options(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  const char* group = "Solution";
  DiffuseOptions& diffuse = arguments.diffuse;
  add_choice(app, "--method",
             {{"exact", RenderMethod::exact},
              {"rays", RenderMethod::rays},
              {"pixels", RenderMethod::pixels}},
             "exact: closed form on a mesh; rays: random rays on a mesh;\npixels: closed form at "
             "every pixel, slow [exact]",
             choices.method)
      ->group(group);
  add_value(app, "--rays", {"a whole number from 1 to " + std::to_string(limits::kRays), "N"},
            "Rays per node of --method rays [64]",
            whole_into(diffuse.gather.rays_per_node, 1, limits::kRays))
      ->group(group);
  add_value(app, "--seed", {"a whole number", "N"}, "Of the random rays [0]",
            [&seed = diffuse.gather.seed](const std::string& text) {
              const auto value = parse_whole(text, 0, UINT64_MAX);
              seed = value.value_or(0);
              return value.has_value();
            })
      ->group(group);
  add_value(app, "--tolerance", {"a number of user units above 0", "UNITS"},
            "Largest distance between a curve and its chords\n"
            "[0.04 pixels, at most 0.05 on an artboard of 512]",
            into(diffuse.tolerance, parse_positive))
      ->group(group);
  add_choice(app, "--ends", {{"soft", gather::Ends::soft}, {"paper", gather::Ends::paper}},
             "Ahead of an open curve's end: its colours turn into each\nother, or meet in the "
             "paper's sliver [soft]",
             diffuse.ends)
      ->group(group);
  app.add_flag("--no-blur", diffuse.ignore_blur, "Draw every curve sharp")->group(group);
}

void add_mesh_options(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  const char* group = "Mesh (no effect with --method pixels)";
  DiffuseOptions& diffuse = arguments.diffuse;
  add_value(app, "--max-error", {"a number above 0 and at most 255, or off", "E|off"},
            "Refine where a patch misses by more, in code values of\n255; off: the plain mesh [1; "
            "with 16 bits 0.25]",
            [&](const std::string& text) {
              choices.sets_max_error = true;
              return set_max_error(text, diffuse.max_error);
            })
      ->group(group);
  add_value(app, "--max-area", {"a fraction above 0 and at most 1, as 0.04 or 4%", "FRACTION"},
            "Largest triangle, as a fraction of the artboard [4%]",
            into(diffuse.max_area_fraction, parse_fraction))
      ->group(group);
  add_value(
      app, "--min-angle", {"degrees from 0 to 33", "DEGREES"},
      "Smallest angle of a triangle, where the curves allow it [22]",
      [&diffuse](const std::string& text) { return set_min_angle(text, diffuse.min_angle_deg); })
      ->group(group);
  add_choice(app, "--order",
             {{"linear", PatchOrder::linear},
              {"quadratic", PatchOrder::quadratic},
              {"cubic", PatchOrder::cubic}},
             "Interpolation inside a triangle [cubic]", diffuse.order)
      ->group(group);
  app.add_flag("--mesh-overlay", arguments.raster.mesh_overlay, "Draw the mesh on top")
      ->group(group);
}

void add_image_options(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  const char* group = "Image";
  add_value(app, "--background",
            {"an opaque colour of CSS, as gold, #rrggbb or rgb(255 165 0), or none", "COLOR"},
            "Behind transparent parts; none: not even the drawing's\nown [the drawing's own, else "
            "none; JPEG and EPS: white]",
            [&arguments](const std::string& text) { return set_background(text, arguments); })
      ->group(group);
  add_choice(app, "--depth", {{"8", 8}, {"16", 16}}, "Bits per channel [8]", choices.depth)
      ->group(group);
  CLI::Option* dither = app.add_flag_callback(
      "--dither", [&choices] { choices.dither = true; },
      "Blue noise below a code value where colours change, for 8\nbits [with PNG and WebP]");
  dither->group(group);
  app.add_flag_callback(
         "--no-dither", [&choices] { choices.dither = false; },
         "Round to the nearest code value [with JPEG]")
      ->excludes(dither)
      ->group(group);
  add_value(app, "--quality", {"a whole number from 1 to 100", "N"}, "Of JPEG and WebP [90]",
            whole_into(choices.quality, 1, 100))
      ->group(group);
  app.add_flag("--lossless", arguments.output.lossless, "WebP that keeps every pixel")
      ->group(group);
  app.add_flag("--no-antialias", choices.no_antialias, "Hard edges at curves")->group(group);
}

void add_vector_options(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  const char* group = "HTML, PDF, EPS, SVG and GLB";
  OutputOptions& output = arguments.output;
  add_value(app, "--detail", {"a number above 0", "NUMBER"},
            "Make the mesh for a picture this many times larger, to\nbe enlarged [2; vector SVG 1]",
            into(choices.detail, parse_positive))
      ->group(group);
  add_value(app, "--dpi", {"a number above 0", "NUMBER"},
            "Of what stands as pixels there; a user unit is 1/96\ninch [300; SVG and GLB 192]",
            into(output.dpi, parse_positive))
      ->group(group);
  add_choice(app, "--svg", {{"image", SvgMode::image}, {"vector", SvgMode::vector}},
             "image: one PNG in an SVG; vector: triangles of gradients\n[image]", choices.svg)
      ->group(group);
  app.add_flag("--force", output.force, "A vector SVG however large it is")->group(group);
  add_choice(app, "--pdf-flatten",
             {{"auto", PdfFlatten::automatic},
              {"always", PdfFlatten::always},
              {"never", PdfFlatten::never}},
             "Layers of a PDF as pixels; auto: those that take some\nprograms minutes [auto]",
             output.pdf_flatten)
      ->group(group);
  app.add_option("--title", output.title, "Of HTML, PDF and EPS [the drawing's file name]")
      ->type_name("TEXT")
      ->group(group);
}

void add_running_options(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  const char* group = "Running";
  add_choice(app, "--device", {{"cpu", RenderDevice::cpu}, {"gpu", RenderDevice::gpu}},
             "What draws pixels; gpu: by OpenGL ES, where there is\none [cpu]", choices.device)
      ->group(group);
  add_value(app, "--threads", {"a whole number from 1 to " + std::to_string(limits::kThreads), "N"},
            "Threads; the picture is the same for any number [all cores]",
            whole_into(arguments.threads, 1, limits::kThreads))
      ->group(group);
  app.add_option("--stats", arguments.stats, "Sizes and times as JSON; '-': to stdout")
      ->type_name("FILE.json")
      ->group(group);
  app.add_flag("--quiet", arguments.quiet, "No warnings, no progress bar")->group(group);
}

}  // namespace

void add_place_options(CLI::App& app, RenderArguments& arguments) {
  const char* group = "Part and size";
  const ValueText pixels{"a whole number of pixels, at least 1", "PIXELS"};
  SizeRequest& size = arguments.size;
  add_value(
      app, "--viewport",
      {"x,y,width,height in user units, width and height above 0, no edge beyond 1e7", "X,Y,W,H"},
      "The part to draw, in user units [the artboard]",
      into(arguments.diffuse.viewport, parse_viewport))
      ->group(group);
  add_value(app, "--width", pixels, "Width; the height follows unless given [the drawing's]",
            whole_into(size.width, 1, kLargestCount))
      ->group(group);
  add_value(app, "--height", pixels, "Height; the width follows unless given [the drawing's]",
            whole_into(size.height, 1, kLargestCount))
      ->group(group);
  add_value(
      app, "--scale", {"a number above 0", "NUMBER"},
      "Instead: pixels per user unit [1, or what the drawing's\nown width and height make it]",
      into(size.scale, parse_positive))
      ->group(group);
}

CLI::App* add_render(CLI::App& root, RenderArguments& arguments, RenderChoices& choices) {
  CLI::App* app = root.add_subcommand("render", "Draw files of diffusion curves");
  app->footer(kRenderFooter);
  add_files(*app, arguments, choices);
  add_place_options(*app, arguments);
  add_solution_options(*app, arguments, choices);
  add_mesh_options(*app, arguments, choices);
  add_image_options(*app, arguments, choices);
  add_vector_options(*app, arguments, choices);
  add_running_options(*app, arguments, choices);
  add_resources(*app, arguments.resources);
  return app;
}

}  // namespace sfumato::cli
