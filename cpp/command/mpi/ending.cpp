#include "ending.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <csignal>
#include <string>

#include "status.hpp"

namespace certet::command {
namespace {

// What a handler may look at.
std::array<char, PATH_MAX> unfinished{};
volatile std::sig_atomic_t is_there = 0;

void end(int) {
  if (is_there != 0) ::unlink(unfinished.data());
  ::_exit(static_cast<int>(Status::interrupted));
}

}  // namespace

void end_at_signals() {
  struct sigaction action {};
  action.sa_handler = end;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

Unfinished::Unfinished(const std::filesystem::path& file) {
  const std::string name = std::filesystem::absolute(file).string();
  if (name.size() >= unfinished.size()) return;  // no file has such a name
  std::ranges::copy(name, unfinished.begin());
  unfinished[name.size()] = '\0';
  is_there = 1;
}

Unfinished::~Unfinished() { is_there = 0; }

}  // namespace certet::command
