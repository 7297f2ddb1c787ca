#include "cli/commands.hpp"

int main(int argc, char** argv) {
  return sfumato::cli::run(argc, argv);
}
