// The program `certet`.

#include <cstdio>
#include <new>
#include <string>

#include "commands.hpp"
#include "outputs.hpp"
#include "signals.hpp"

namespace certet::command {
namespace {

Status run(const Options& options) {
  if (const auto* notice = std::get_if<Notice>(&options)) {
    write_text("-", notice->text);
    return Status::ok;
  }
  if (const auto* wanted = std::get_if<MeshOptions>(&options)) return mesh(*wanted);
  return check(std::get<CheckOptions>(options));
}

Status say(Status status, const char* sentence) {
  std::fprintf(stderr, "certet: %s\n", sentence);
  return status;
}

}  // namespace
}  // namespace certet::command

int main(int argc, char** argv) {
  using namespace certet::command;
  ignore_write_signals();
  try {
    return static_cast<int>(run(parse_options(argc, argv)));
  } catch (const certet::Error& error) {
    return static_cast<int>(say(status_of(error.code()), error.what()));
  } catch (const std::bad_alloc&) {
    return static_cast<int>(say(Status::too_large, "out of memory"));
  } catch (const std::exception& error) {
    return static_cast<int>(say(Status::bad_input, error.what()));
  }
}
