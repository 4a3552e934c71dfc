// The program `certet`.

#include <cstdio>

#include "command_line.hpp"
#include "failure.hpp"
#include "signals.hpp"

int main(int argc, char** argv) {
  using namespace certet::command;
  ignore_write_signals();
  try {
    return static_cast<int>(CommandLine().parse(argc, argv)());
  } catch (...) {
    const auto [status, sentence] = current_failure();
    std::fprintf(stderr, "certet: %s\n", sentence.c_str());
    return static_cast<int>(status);
  }
}
