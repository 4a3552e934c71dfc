#include "failure.hpp"

#include <algorithm>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "certet/error.hpp"

namespace certet::command {
namespace {

/// On one line, whatever the names of files in it have in them.
Failure failure(Status status, std::string sentence) {
  std::ranges::replace_if(sentence, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return {status, std::move(sentence)};
}

}  // namespace

Failure current_failure() {
  try {
    throw;
  } catch (const Error& error) {
    return failure(status_of(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return failure(Status::too_large, "out of memory");
  } catch (const std::system_error& error) {
    // What a thread that finds no room for its stack throws.
    if (error.code() == std::errc::resource_unavailable_try_again)
      return failure(Status::too_large, "out of memory for another thread");
    return failure(Status::bad_input, error.what());
  } catch (const std::exception& error) {
    // oneTBB tells the same by this sentence alone.
    if (std::string_view(error.what()).starts_with("pthread_create has failed"))
      return failure(Status::too_large, "out of memory for another thread");
    return failure(Status::bad_input, error.what());
  }
}

}  // namespace certet::command
