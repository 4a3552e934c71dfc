#include "memory.hpp"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace certet::command {

namespace {

/// The entry `key` of a file like /proc/meminfo, in bytes; 0 if there is none.
std::uint64_t entry(const char* name, const std::string& key) {
  std::ifstream file(name);
  std::string word, rest;
  while (file >> word) {
    std::uint64_t kibibytes = 0;
    if (word == key && file >> kibibytes) return kibibytes * 1024;
    std::getline(file, rest);
  }
  return 0;
}

}  // namespace

std::uint64_t available_memory() { return entry("/proc/meminfo", "MemAvailable:"); }

// getrusage would count what the parent held before it started this program.
std::uint64_t peak_memory() { return entry("/proc/self/status", "VmHWM:"); }

#if defined(__SANITIZE_ADDRESS__)
// The sanitizer's shadow memory is larger than any limit worth setting.
void limit_memory(std::uint64_t) {}
#else
void limit_memory(std::uint64_t bytes) {
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur <= bytes) return;
  limit.rlim_cur = bytes;
  setrlimit(RLIMIT_DATA, &limit);
}
#endif

}  // namespace certet::command
