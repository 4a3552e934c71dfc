#include "parts/part.hpp"

#include <dlfcn.h>

#include <string>
#include <string_view>

#include "certet/error.hpp"

namespace certet::command {
namespace {

[[noreturn]] void fail(const char* name, const std::string& why) {
  throw Error(ErrorCode::bad_option, "the part '" + std::string(name) + "' of certet " + why);
}

}  // namespace

const void* load_part(const char* name) {
  void* const module = dlopen((std::string(name) + ".so").c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (module == nullptr) {
    const char* const why = dlerror();
    fail(name, "cannot be loaded (" + std::string(why == nullptr ? "no reason told" : why) + ")");
  }
  const auto tell = reinterpret_cast<Part (*)()>(dlsym(module, "certet_part"));
  if (tell == nullptr) fail(name, "is none");
  const auto [version, functions] = tell();
  if (std::string_view(version) != CERTET_VERSION)
    fail(name, "is of version " + std::string(version) + ", not " CERTET_VERSION);
  return functions;
}

}  // namespace certet::command
