#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "cli/run_command.hpp"
#include "support/places.hpp"

/// docs/cli.md, the man page and the completions name exactly the command's options. `make check`
/// also runs scripts/make-completions --check.
namespace sfumato::test {
namespace {

using NameSet = std::set<std::string>;

constexpr const char* kCommands[] = {"render", "solve",   "tiles", "info",  "convert", "trace",
                                     "lint",   "compare", "init",  "watch", "edit",    "help"};

std::string file_text(const std::string& path) {
  const std::string text = read_whole(source_path(path));
  EXPECT_FALSE(text.empty()) << path;
  return text;
}

/// Returns the text from `begin` to the next `end`, or to the end of the text.
std::string section(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  EXPECT_NE(from, std::string::npos) << begin;
  if (from == std::string::npos) return {};
  const std::size_t inside = from + begin.size();
  return text.substr(inside, text.find(end, inside) - inside);
}

/// Returns the first groups of all matches, except --help.
NameSet matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  NameSet names;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i) {
    names.insert((*i)[1]);
  }
  names.erase("--help");
  return names;
}

std::string help_of(const std::string& command) {
  return run_sfumato({command, "--help"}).out;
}

NameSet options_of(const std::string& command) {
  return matches(help_of(command), "\n  (?:-[a-z],)?(--[a-z-]+)");
}

/// Returns the words for an option's value: "exact", "off".
NameSet choices_of(const std::string& command) {
  NameSet words;
  const NameSet lists = matches(help_of(command), "\n  --[a-z-]+ ([A-Za-z0-9]+(?:\\|[a-z0-9]+)+)");
  for (const std::string& list : lists) words.merge(matches(list, "([a-z0-9]+)"));
  return words;
}

void expect_words(const NameSet& words, const std::string& text, const std::string& where) {
  for (const std::string& word : words) {
    EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + word + "\\b"))) << word << where;
  }
}

constexpr const char* kOption = "(--[a-z]+(?:-[a-z]+)*)";

TEST(CommandDocuments, the_help_names_options_and_choices) {
  EXPECT_EQ(options_of("convert"), (NameSet{"--allow-files", "--limit", "--max-memory",
                                            "--max-time", "--output", "--quiet"}));
  EXPECT_TRUE(options_of("render").contains("--no-antialias"));
  EXPECT_TRUE(choices_of("render").contains("rays"));
  EXPECT_TRUE(choices_of("render").contains("off"));
}

TEST(CommandDocuments, every_command_is_known) {
  const std::string help = run_sfumato({"--help"}).out;
  const NameSet commands = matches(section(help, "Subcommands:", "Examples:"), "\n  ([a-z]+)");
  EXPECT_EQ(commands, NameSet(std::begin(kCommands), std::end(kCommands)));
}

TEST(CommandDocuments, the_manual_in_markdown_names_every_option) {
  const std::string document = file_text("docs/cli.md");
  for (const std::string command : kCommands) {
    const std::string text = section(document, "\n## " + command + "\n", "\n## ");
    NameSet named = matches(text, kOption);
    if (text.find("`-o") != std::string::npos) named.insert("--output");
    EXPECT_EQ(named, options_of(command)) << command;
    expect_words(choices_of(command), text, " in docs/cli.md, " + command);
  }
}

TEST(CommandDocuments, the_session_in_the_manual_runs) {
  const TemporaryFolder folder;
  const std::string session = section(file_text("docs/cli.md"), "```sh\n", "```");
  const std::string script = "cd \"$1\" && cp -r " + source_path("examples") +
                             " . && sfumato() { " + sfumato_program() + " \"$@\"; }\n" + session;
  const CommandResult result = run_command({"/bin/bash", "-ec", script, "bash", folder.path("")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("evening.svg: no hints\n"), std::string::npos) << result.out;
  EXPECT_TRUE(std::regex_search(result.out, std::regex("maximum +0\\.0000\n"))) << result.out;
}

TEST(CommandDocuments, the_drawing_of_the_readme_has_no_hints) {
  const std::string drawing = section(file_text("README.md"), "```xml\n", "```");
  const CommandResult result = run_sfumato({"lint", "--strict", "-"}, drawing);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(CommandDocuments, the_first_drawing_of_the_readme_is_its_picture) {
  const TemporaryFolder folder;
  const std::string readme = file_text("README.md");
  folder.add("evening.svg", section(readme, "```xml\n", "```"));
  const std::string command = section(readme, "then run `build/sfumato ", "`");
  const std::string script = "cd \"$1\" && " + sfumato_program() + " " + command + " && " +
                             sfumato_program() + " compare evening.png " +
                             source_path("docs/images/first.png");
  const CommandResult result = run_command({"/bin/bash", "-ec", script, "bash", folder.path("")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::smatch rms;
  ASSERT_TRUE(std::regex_search(result.out, rms, std::regex("rms +([0-9.]+)"))) << result.out;
  EXPECT_LE(std::stod(rms[1]), 1.0);
}

/// Runs all commands except the first, which builds, and `watch`, which runs until it is
/// interrupted.
TEST(CommandDocuments, the_commands_of_the_index_run_in_an_empty_folder) {
  const TemporaryFolder folder;
  std::string session = section(file_text("docs/README.md"), "```sh\nmake demo", "```");
  session = std::regex_replace(session, std::regex("build/sfumato watch"), "true");
  session = std::regex_replace(session, std::regex("build/sfumato"), sfumato_program());
  const std::string script = "cd \"$1\"\n" + session;
  const CommandResult result = run_command({"/bin/bash", "-ec", script, "bash", folder.path("")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* name :
       {"drawing.svg", "picture.png", "picture.html", "picture.pdf", "pictures/drawing.webp"}) {
    EXPECT_FALSE(read_whole(folder.path(name)).empty()) << name;
  }
}

TEST(CommandDocuments, the_man_page_names_every_option) {
  const std::string document =
      std::regex_replace(file_text("docs/man/sfumato.1"), std::regex("\\\\-"), "-");
  for (const std::string command : kCommands) {
    const std::string text = section(document, "\n.SS " + command + "\n", "\n.S");
    EXPECT_EQ(matches(text, kOption), options_of(command)) << command;
    expect_words(choices_of(command), text, " in the man page, " + command);
  }
}

TEST(CommandDocuments, bash_completes_every_option) {
  const std::string document = file_text("completions/sfumato.bash");
  for (const std::string command : kCommands) {
    const std::string text = section(document, "\n    " + command + ")", ";;");
    EXPECT_EQ(matches(text, kOption), options_of(command)) << command;
    expect_words(choices_of(command), document, " in the completion for bash");
  }
}

TEST(CommandDocuments, bash_offers_what_fits) {
  const std::string script = "source " + source_path("completions/sfumato.bash") +
                             "; "
                             "COMP_CWORD=$(($# - 1)); COMP_WORDS=(\"$@\"); "
                             "_sfumato; echo \"${COMPREPLY[*]}\"";
  const auto offered = [&script](std::vector<std::string> words) {
    words.insert(words.begin(), {"/bin/bash", "-c", script, "bash", "sfumato"});
    const CommandResult result = run_command(words);
    EXPECT_EQ(result.err, "");
    return result.out;
  };
  EXPECT_EQ(offered({"co"}), "convert compare\n");
  EXPECT_EQ(offered({"help", "tr"}), "trace\n");
  EXPECT_EQ(offered({"help", "--"}), "--help --json\n");
  EXPECT_EQ(offered({"tiles", "--format", "p"}), "png\n");
  EXPECT_EQ(offered({"solve", "--method", ""}), "exact rays\n");
  EXPECT_EQ(offered({"render", "--order", "=", "c"}), "cubic\n");
  EXPECT_EQ(offered({"render", "--background", "sky"}), "skyblue\n");
  EXPECT_EQ(offered({"render", "--m"}),
            "--method --max-error --max-area --min-angle --mesh-overlay "
            "--max-memory --max-time\n");
  EXPECT_EQ(offered({"info", "--limit", "tex"}), "textures= texels=\n");
  EXPECT_EQ(offered({"render", "a.svg", "--order", "q"}), "quadratic\n");
  EXPECT_EQ(offered({"lint", "--s"}), "--strict\n");
  EXPECT_EQ(offered({"render", "--width", ""}), "\n");
}

TEST(CommandDocuments, bash_offers_files_that_fit) {
  const TemporaryFolder folder;
  for (const char* name : {"a.svg", "a.PNG", "a.txt"}) folder.add(name, "");
  const auto offered = [&folder](const std::string& words) {
    const std::string script = "cd \"$1\"; source " + source_path("completions/sfumato.bash") +
                               "; COMP_WORDS=(sfumato " + words +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _sfumato; "
                               "echo \"${COMPREPLY[*]}\"";
    return run_command({"/bin/bash", "-c", script, "bash", folder.path("")}).out;
  };
  EXPECT_EQ(offered("lint a"), "a.svg\n");
  EXPECT_EQ(offered("trace a"), "a.PNG\n");
  EXPECT_EQ(offered("tiles a.t"), "a.txt\n") << "no file fits, so all are offered";
}

TEST(CommandDocuments, zsh_completes_every_option) {
  const std::string document = file_text("completions/_sfumato");
  for (const std::string command : kCommands) {
    const std::string text = section(document, "\n    " + command + ")\n", ";;");
    EXPECT_EQ(matches(text, kOption), options_of(command)) << command;
    expect_words(choices_of(command), text, " in the completion for zsh, " + command);
  }
}

TEST(CommandDocuments, fish_completes_every_option) {
  const std::string document = file_text("completions/sfumato.fish");
  for (const std::string command : kCommands) {
    NameSet named;
    const NameSet long_names =
        matches(document, "'__sfumato_command_is " + command + "'(?: -s [a-z])? -l ([a-z-]+)");
    for (const std::string& name : long_names) named.insert("--" + name);
    EXPECT_EQ(named, options_of(command)) << command;
    expect_words(choices_of(command), document, " in the completion for fish");
  }
}

TEST(CommandDocuments, fish_offers_what_fits) {
  if (run_command({"/bin/sh", "-c", "command -v fish"}).exit_code != 0) {
    GTEST_SKIP() << "fish is not installed";
  }
  const auto offered = [](const std::string& line) {
    const std::string script = "source " + source_path("completions/sfumato.fish") +
                               "; complete -C '" + line + "' | string replace -r '\\t.*' ''";
    return run_command({"/usr/bin/env", "fish", "--no-config", "-c", script}).out;
  };
  EXPECT_EQ(offered("sfumato co"), "compare\nconvert\n");
  EXPECT_EQ(offered("sfumato render --or"), "--order\n");
  EXPECT_EQ(offered("sfumato tiles --format "), "jpg\npng\nwebp\n");
  EXPECT_EQ(offered("sfumato lint --limit tex"), "texels=\ntextures=\n");
  EXPECT_EQ(offered("sfumato help tr"), "trace\n");
  EXPECT_EQ(offered("sfumato help render --"), "--help\n--json\n");
}

}  // namespace
}  // namespace sfumato::test
