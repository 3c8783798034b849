#include "apps/cli/command_line.h"

int main(int argumentCount, char** arguments) {
  return honeycomb::Cli::run(argumentCount, arguments);
}
