#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// An attack: files in an empty folder, a call of `sfumato` there, and the expected end.
namespace sfumato::hostile {

/// Bytes of a file. They are made only in a short-lived process, so that the measuring process
/// stays small.
class Bytes {
 public:
  Bytes(const char* text) : make_([text] { return std::string(text); }) {}
  Bytes(std::string text) : make_([text = std::move(text)] { return text; }) {}
  template <class Make>
  requires std::is_invocable_r_v<std::string, Make> Bytes(Make make) : make_(std::move(make)) {}

  std::string operator()() const { return make_(); }

 private:
  std::function<std::string()> make_;
};

/// sfumato's exit codes (docs/cli.md).
enum Exit : int { kDone = 0, kBadInput = 1, kBadUsage = 2, kLimit = 3 };

struct Case {
  std::string name;
  int exit_code = kDone;
  /// Part of the text on standard error; "" with kDone: no text there.
  std::string message;
  std::vector<std::pair<std::string, Bytes>> files{};
  /// Follow the command's name; the current folder is empty except for the case's files.
  std::vector<std::string> arguments{"render", "in.svg", "-o", "out.png"};
  /// Makes links, pipes and folders in the case's folder, in a separate process.
  std::function<void()> prepare{};
  std::string input{};  ///< standard input

  Case& with(const std::string& file, Bytes bytes) {
    files.emplace_back(file, std::move(bytes));
    return *this;
  }
  Case& run(std::vector<std::string> with_arguments) {
    arguments = std::move(with_arguments);
    return *this;
  }
  /// Adds arguments to `render in.svg -o out.png`.
  Case& also(const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return *this;
  }
  Case& in_folder(std::function<void()> make) {
    prepare = std::move(make);
    return *this;
  }
};

/// The cases of one file of this folder, NAME_cases.cpp.
class Family {
 public:
  explicit Family(std::string name) : name_(std::move(name)) {}

  /// Adds a case whose document is in.svg (also for Orzan's XML; the text shows the kind of the
  /// file).
  Case& add(std::string name, int exit_code, std::string message, Bytes document) {
    Case& made = add_call(std::move(name), exit_code, std::move(message), {});
    made.arguments = {"render", "in.svg", "-o", "out.png"};
    return made.with("in.svg", std::move(document));
  }
  /// Adds a case without a document.
  Case& add_call(std::string name, int exit_code, std::string message,
                 std::vector<std::string> arguments) {
    Case& made = cases_.emplace_back();
    made.name = std::move(name);
    made.exit_code = exit_code;
    made.message = std::move(message);
    made.arguments = std::move(arguments);
    return made;
  }

  const std::string& name() const { return name_; }
  const std::vector<Case>& cases() const { return cases_; }

 private:
  std::string name_;
  std::vector<Case> cases_;
};

/// Returns all families, by name.
std::vector<Family> all_families();

/// Registers the function that fills a family: `const Register kPaths("paths", add_paths);`.
struct Register {
  Register(const char* name, void (*fill)(Family&));
};

}  // namespace sfumato::hostile
