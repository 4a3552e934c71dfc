#pragma once
/// \file
/// The one exception type of the library.

#include <stdexcept>
#include <string>

namespace certet {

/// Why an operation could not be carried out.
enum class ErrorCode {
  bad_option,      ///< a request that makes no sense: negative size, empty bounds
  bad_input,       ///< an input that cannot be read, or is not what it should be
  empty_domain,    ///< nothing is inside: there is no mesh to make
  too_large,       ///< the lattice leaves the coordinate range or the memory allowed
  write_failed,    ///< the output cannot be written
  cancelled,       ///< the caller asked to stop
  check_failed,    ///< a mesh breaks a property that it must have
};

/// Thrown by every function of the library that can fail; `what()` is one
/// sentence that names the cause and, where there is one, the file.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence)
      : std::runtime_error(sentence), code_(code) {}
  [[nodiscard]] ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace certet
