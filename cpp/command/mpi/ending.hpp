#pragma once
/// \file
/// A run that is ended from outside: one process of it was killed, or all are to stop.

#include <filesystem>

namespace certet::command {

/// SIGINT, SIGTERM and SIGHUP, which `mpirun` sends the others when a process dies, end this one
/// at once, wherever it waits; what is told of is deleted before.
void end_at_signals();

/// A file that is not whole yet, which no process may leave behind.  There is one at a time.
class Unfinished {
 public:
  explicit Unfinished(const std::filesystem::path& file);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
};

}  // namespace certet::command
