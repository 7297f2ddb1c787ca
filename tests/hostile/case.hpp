#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// One attack: files in an empty folder, a call of `sfumato` there, and how it must end.
namespace sfumato::hostile {

/// Bytes of a file. Made only in a process that ends with them: what measures stays small.
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
  /// Stands in what is printed on standard error; "" with kDone: nothing is printed there.
  std::string message;
  std::vector<std::pair<std::string, Bytes>> files{};
  /// Behind the command's name; with an empty folder as the current one.
  std::vector<std::string> arguments{"render", "in.svg", "-o", "out.png"};
  /// Makes what is no file: links, pipes, folders. In the case's folder; in a process of its own.
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
  /// More arguments of `render in.svg -o out.png`.
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

  /// A case whose document is in.svg (Orzan's XML too: what a file is shows in its text).
  Case& add(std::string name, int exit_code, std::string message, Bytes document) {
    Case& made = add_call(std::move(name), exit_code, std::move(message), {});
    made.arguments = {"render", "in.svg", "-o", "out.png"};
    return made.with("in.svg", std::move(document));
  }
  /// A case without a document.
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

/// Every family there is, by name.
std::vector<Family> all_families();

/// Registers what fills a family: `const Register kPaths("paths", add_paths);`.
struct Register {
  Register(const char* name, void (*fill)(Family&));
};

}  // namespace sfumato::hostile
