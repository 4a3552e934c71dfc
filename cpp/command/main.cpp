// The program `certet`.

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "command_line.hpp"
#include "signals.hpp"

namespace certet::command {
namespace {

/// On one line, whatever the names of files in it have in them.
Status say(Status status, std::string sentence) {
  std::ranges::replace_if(sentence, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  std::fprintf(stderr, "certet: %s\n", sentence.c_str());
  return status;
}

}  // namespace
}  // namespace certet::command

int main(int argc, char** argv) {
  using namespace certet::command;
  ignore_write_signals();
  try {
    return static_cast<int>(CommandLine().parse(argc, argv)());
  } catch (const certet::Error& error) {
    return static_cast<int>(say(status_of(error.code()), error.what()));
  } catch (const std::bad_alloc&) {
    return static_cast<int>(say(Status::too_large, "out of memory"));
  } catch (const std::system_error& error) {
    // What a thread that finds no room for its stack throws.
    if (error.code() == std::errc::resource_unavailable_try_again)
      return static_cast<int>(say(Status::too_large, "out of memory for another thread"));
    return static_cast<int>(say(Status::bad_input, error.what()));
  } catch (const std::exception& error) {
    // oneTBB tells the same by this sentence alone.
    if (std::string_view(error.what()).starts_with("pthread_create has failed"))
      return static_cast<int>(say(Status::too_large, "out of memory for another thread"));
    return static_cast<int>(say(Status::bad_input, error.what()));
  }
}
