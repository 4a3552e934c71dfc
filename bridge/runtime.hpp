#pragma once
/// \file
/// Private to the bridge: calling OCaml by name with integers.

#include <cstdint>
#include <exception>
#include <initializer_list>
#include <utility>
#include <vector>

namespace certified::runtime {

void start();

/// The C++ side of one call: its closures, and the exception that one of them
/// threw.  OCaml knows it by its place in the stack of the calls under way, so
/// that no C++ pointer ever lies in the OCaml heap.
class Frame {
 public:
  /// \param closures what the stubs of this call expect; outlives the frame
  explicit Frame(const void* closures);
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  [[nodiscard]] std::int64_t handle() const { return handle_; }
  [[nodiscard]] const void* closures() const { return closures_; }
  void park(std::exception_ptr thrown) { parked_ = std::move(thrown); }

  /// Throws again what a closure threw, if one did.
  void rethrow_parked();

  /// \throws Failure if the handle names no call under way
  static Frame& of(std::int64_t handle);

 private:
  std::int64_t handle_;
  const void* closures_;
  std::exception_ptr parked_;
};

using Arguments = std::initializer_list<std::int64_t>;

/// Calls the function registered under `name`.  A function without arguments is
/// given `()`.
/// \throws Failure for an argument beyond 63 bits, a strange thread, or an
/// OCaml exception that no closure caused
std::int64_t call_int(const char* name, Arguments arguments, Frame* frame = nullptr);
std::vector<std::int64_t> call_ints(const char* name, Arguments arguments,
                                    Frame* frame = nullptr);
void call(const char* name, Arguments arguments, Frame* frame = nullptr);

}  // namespace certified::runtime
