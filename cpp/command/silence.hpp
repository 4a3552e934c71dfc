#pragma once
/// \file
/// Libraries that talk.

#include <fcntl.h>
#include <unistd.h>

namespace certet::command {

/// While it lives, what is written to stderr is lost: the C libraries under the
/// image readers print there on their own, and this program has one sentence.
class Silence {
 public:
  Silence() : kept_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
  ~Silence() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int kept_;
};

}  // namespace certet::command
