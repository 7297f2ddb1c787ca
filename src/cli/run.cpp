#include <cstdio>
#include <exception>
#include <new>

#include "cli/commands/commands.hpp"
#include "cli/heap.hpp"
#include "cli/interrupt.hpp"
#include "cli/messages.hpp"

namespace sfumato::cli {
namespace {

struct RunCommand {
  int operator()(const NoCommand& none) const {
    if (none.exit_code != kDone) {
      std::fputs(none.text.c_str(), stderr);
      return none.exit_code;
    }
    const Status printed = print(none.text);
    return printed ? kDone : fail(printed);
  }
  int operator()(const RenderArguments& arguments) const { return render(arguments); }
  int operator()(const SolveArguments& arguments) const { return solve(arguments); }
  int operator()(const TilesArguments& arguments) const { return tiles(arguments); }
  int operator()(const InfoArguments& arguments) const { return info(arguments); }
  int operator()(const ConvertArguments& arguments) const { return convert(arguments); }
  int operator()(const LintArguments& arguments) const { return lint(arguments); }
  int operator()(const CompareArguments& arguments) const { return compare(arguments); }
  int operator()(const InitArguments& arguments) const { return init(arguments); }
  int operator()(const WatchArguments& arguments) const { return watch(arguments); }
  int operator()(const EditArguments& arguments) const { return edit(arguments); }
  int operator()(const TraceArguments& arguments) const { return trace(arguments); }
};

int parse_and_run(int argc, const char* const* argv) {
  try {
    return std::visit(RunCommand{}, parse_arguments(argc, argv));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return fail(make_error(StatusCode::internal,
                           std::string("internal error, please report it: ") + error.what()));
  }
}

}  // namespace

int run(int argc, const char* const* argv) {
  ignore_write_signals();
  prepare_heap();
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {  // without another allocation
    std::fputs("sfumato: error: out of memory\n", stderr);
    return kResource;
  }
}

}  // namespace sfumato::cli
