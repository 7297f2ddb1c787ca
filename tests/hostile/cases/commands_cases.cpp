// Meaningless calls, the other commands, and outputs that cannot be written.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

namespace fs = std::filesystem;

void add_calls(Family& family) {
  family.add_call("nothing", kBadUsage, "Usage: sfumato", {});
  family.add_call("empty_command", kBadUsage, "unknown command", {""});
  family.add_call("unknown_command", kBadUsage, "; use render", {"paint"});
  family.add_call("unknown_command_long", kBadUsage, "sfumato: error: unknown command \"aaaa",
                  {repeated("a", 100'000)});
  family.add_call("command_of_bytes", kBadUsage, "; use render", {"\xff\x1b[2J"});
  family.add_call("option_first", kBadUsage, "before the command; use it after render",
                  {"--width", "9"});
  family.add_call("help_of_bytes", kBadUsage, "; use render", {"help", "\xff\x1b[2J"});
  family.add_call("help_as_json", kDone, "", {"help", "--json"});
  for (const char* command : {"render", "info", "convert", "lint", "compare"}) {
    const std::string name = command;
    family.add_call(name + "_alone", kBadUsage, "sfumato " + name, {command});
    family.add_call(name + "_unknown_option", kBadUsage, "unknown option", {command, "--nonsense"});
    family
        .add_call(
            name + "_empty_operand",
            name == "render" || name == "convert" || name == "compare" ? kBadUsage : kBadInput,
            "sfumato", {command, ""})
        .message = "error";
    family.add_call(name + "_help", kDone, "", {command, "--help"});
  }
  family.add_call("two_commands", kBadUsage, "sfumato", {"info", "lint", "a"});
  family.add_call("standard_input_twice", kBadUsage, "sfumato",
                  {"render", "-", "-", "--out-dir", "d"});
  family.add_call("standard_output_twice", kBadUsage, "sfumato",
                  {"render", "-", "-o", "-", "--stats", "-"});
  family.add_call("empty_standard_input", kBadInput, "the file is empty", {"info", "-"});
  for (const char* command : {"info", "lint", "convert"}) {
    std::vector<std::string> call{command, "in.svg"};
    if (std::string(command) == "convert") call.insert(call.end(), {"-o", "out.svg"});
    const std::string name = command;
    family.add(name + "_of_text", kBadInput, "no XML element found", "hello").run(call);
    family
        .add(name + "_of_a_bomb", kLimit, "elements read through <use>",
             [] { return svg(laughs(9, kLayer) + "<use href='#g9'/>"); })
        .run(call);
    family
        .add(name + "_of_100000_instances", kDone, "",
             [] {
               return svg(
                   "<defs><g id='a' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g></defs>" +
                   repeated("<use href='#a'/>", 100'000));
             })
        .run(call);
    family
        .add(name + "_of_20000_curves", kDone, "",
             [] { return layer(numbered("<path sf:left='red' d='M9 9h.1v.", 20'000, "'/>")); })
        .run(call);
    family
        .add(name + "_of_20000_equal_curves", kDone, "",
             [] { return layer(repeated("<path sf:left='red' d='M9 9h9'/>", 20'000)); })
        .run(call);
    family
        .add(name + "_of_10000_groups", kDone, "",
             [] { return svg(repeated("<g opacity='.5'>" + kStroke + kStroke + "</g>", 10'000)); })
        .run(call);
    family
        .add(name + "_of_everything_odd", kDone, "is not read",
             [] {
               return svg("<text/><g opacity='0'>" + kLayer +
                          "</g><path d='M9 9h9' sf:left='red' "
                          "sf:radius='1e7' sf:alpha='0'/><g sf:diffuse='true'><path d='M1e7 0h-1' "
                          "sf:opacity='0'/></g>");
             })
        .run(call);
  }
  family
      .add("info_as_json_of_control_characters", kDone, "",
           svg("<g sf:diffuse='true' id='\x01\x1b&#8;\xff'><path d='M9 9h9' sf:left='red'/></g>"))
      .run({"info", "--json", "in.svg"});
}

void add_outputs(Family& family) {
  const std::string good = svg(kLayer);
  const auto writing = [&](const std::string& name, int code, const std::string& message,
                           std::vector<std::string> arguments, std::function<void()> make = {}) {
    arguments.insert(arguments.begin(), {"render", "in.svg"});
    family.add(name, code, message, good).run(std::move(arguments)).in_folder(std::move(make));
  };
  const char* unwritable = "cannot be written";
  writing("into_a_missing_folder", kLimit, unwritable, {"-o", "none/out.png"});
  writing("into_a_file", kLimit, unwritable, {"-o", "in.svg/out.png"});
  writing("onto_a_folder", kLimit, unwritable, {"-o", "d.png"},
          [] { fs::create_directory("d.png"); });
  writing("onto_a_full_device", kLimit, unwritable, {"-o", "out.png"},
          [] { (void)symlink("/dev/full", "out.png"); });
  writing("through_a_link_to_nothing", kLimit, unwritable, {"-o", "out.png"},
          [] { (void)symlink("none/x.png", "out.png"); });
  writing("through_a_link_to_itself", kLimit, unwritable, {"-o", "out.png"},
          [] { (void)symlink("out.png", "out.png"); });
  writing("of_a_long_name", kLimit, unwritable, {"-o", repeated("a", 300) + ".png"});
  writing("of_a_very_long_name", kLimit, unwritable, {"-o", repeated("a", 100'000) + ".png"});
  writing("of_a_long_path", kLimit, unwritable, {"-o", repeated("a/", 2000) + "a.png"});
  writing("of_an_empty_name", kBadUsage, "-o", {"-o", ""});
  writing("of_an_unknown_extension", kBadUsage, "use a file name that ends in", {"-o", "out.exe"});
  writing("of_an_extension_alone", kBadUsage, "use a file name that ends in", {"-o", ".png"});
  writing("of_bytes", kDone, "", {"-o", "out\xff\x1b[31m.png"});
  writing("stats_into_a_missing_folder", kLimit, unwritable,
          {"-o", "out.png", "--stats", "none/a.json"});
  writing("stats_onto_the_picture", kBadUsage, "--stats", {"-o", "out.png", "--stats", "out.png"});
  writing("onto_the_drawing", kBadUsage, "in.svg", {"-o", "in.svg"});
  writing("folder_that_is_a_file", kLimit, "in.svg", {"--out-dir", "in.svg"});
  writing("folder_and_output", kBadUsage, "--out-dir", {"-o", "out.png", "--out-dir", "d"});
  writing("folder_onto_the_drawing", kBadUsage, "in.svg", {"--out-dir", ".", "--format", "svg"});
}

void add_compare(Family& family) {
  const auto compare = [&](const char* name, int code, const char* message, std::string first,
                           std::string second) -> Case& {
    Case& made = family.add_call(name, code, message, {"compare", "a", "b"});
    made.with("a", std::move(first)).with("b", std::move(second));
    return made;
  };
  const std::string good = good_png();
  compare("compare_equal", kDone, "", good, good);
  compare("compare_text", kBadInput, "is not a PNG image", "hello", good);
  compare("compare_empty", kBadInput, "is an empty file; use a PNG", "", "");
  compare("compare_cut", kBadInput, "the PNG image is damaged", good, good.substr(0, 99));
  compare("compare_lying", kBadInput, "is damaged: too few bytes",
          png_header({16'000, 16'000}) + png_chunk("IEND", ""), good);
  compare("compare_60000", kLimit, "the limit is 16384 pixels on a side",
          png_header({60'000, 60'000}) + png_chunk("IEND", ""), good);
  compare("compare_of_other_sizes", kBadInput, "15", good, png({1, 1, 8, 2}, std::string(4, '\0')));
  compare("compare_of_other_depths", kDone, "", good,
          png({15, 15, 16, 6}, std::string(1815, '\0')));
  compare("compare_scale_nan", kBadUsage, "--scale", good, good)
      .run({"compare", "a", "b", "--scale", "nan", "-o", "out.png"});
  compare("compare_scale_huge", kDone, "", good, good)
      .run({"compare", "a", "b", "--scale", "1e300", "-o", "out.png"});
  compare("compare_into_a_missing_folder", kLimit, "cannot be written", good, good)
      .run({"compare", "a", "b", "-o", "none/out.png"});
  family.add_call("compare_devices", kBadInput, "PNG", {"compare", "/dev/null", "/dev/null"});
  family.add_call("compare_files_that_are_missing", kBadInput, "No such file",
                  {"compare", "a", "b"});
  Case& bomb = family.add_call("compare_zeros_5000_by_5000", kDone, "", {"compare", "a", "a"});
  bomb.with("a", [] { return png_of_zeros({5000, 5000, 8, 0}, 5000); });
}

void add_commands_cases(Family& family) {
  add_calls(family);
  add_outputs(family);
  add_compare(family);
}

const Register kCommands("commands", add_commands_cases);

}  // namespace
}  // namespace sfumato::hostile
