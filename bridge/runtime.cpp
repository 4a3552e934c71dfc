#include "runtime.hpp"

#include <caml/callback.h>
#include <caml/memory.h>
#include <caml/mlvalues.h>
#include <caml/printexc.h>

#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "certified.hpp"

namespace certified::runtime {
namespace {

std::optional<std::thread::id> owner;
std::vector<Frame*> frames;

void demand_owner() {
  if (!owner) throw Failure("the OCaml runtime has not been started");
  if (*owner != std::this_thread::get_id())
    throw Failure("the OCaml runtime belongs to another thread");
}

value to_ocaml(std::int64_t n) {
  if (n < Min_long || n > Max_long)
    throw Failure(std::to_string(n) + " does not fit in 63 bits");
  return Val_long(n);
}

std::string describe(value exception) {
  char* text = caml_format_exception(exception);
  std::string sentence = text == nullptr ? "an OCaml exception" : text;
  caml_stat_free(text);
  return sentence;
}

/// The answer, to be read before anything is allocated in the OCaml heap.
value answer(const char* name, Arguments arguments, Frame* frame) {
  demand_owner();
  const value* function = caml_named_value(name);
  if (function == nullptr) throw Failure(std::string("there is no function ") + name);
  std::vector<value> values;
  for (const std::int64_t n : arguments) values.push_back(to_ocaml(n));
  if (values.empty()) values.push_back(Val_unit);
  const value result =
      caml_callbackN_exn(*function, static_cast<int>(values.size()), values.data());
  if (!Is_exception_result(result)) return result;
  const std::string sentence = describe(Extract_exception(result));
  if (frame != nullptr) frame->rethrow_parked();
  throw Failure(sentence);
}

}  // namespace

void start() {
  if (owner) return demand_owner();
  char name[] = "certified";
  char* arguments[] = {name, nullptr};
  const value result = caml_startup_exn(arguments);
  owner = std::this_thread::get_id();
  if (Is_exception_result(result)) throw Failure(describe(Extract_exception(result)));
}

Frame::Frame(const void* closures)
    : handle_(static_cast<std::int64_t>(frames.size())), closures_(closures) {
  demand_owner();
  frames.push_back(this);
}

Frame::~Frame() { frames.pop_back(); }

void Frame::rethrow_parked() {
  if (parked_) std::rethrow_exception(std::exchange(parked_, nullptr));
}

Frame& Frame::of(std::int64_t handle) {
  return *frames.at(static_cast<std::size_t>(handle));
}

std::int64_t call_int(const char* name, Arguments arguments, Frame* frame) {
  return Long_val(answer(name, arguments, frame));
}

std::vector<std::int64_t> call_ints(const char* name, Arguments arguments, Frame* frame) {
  const value array = answer(name, arguments, frame);
  std::vector<std::int64_t> numbers(Wosize_val(array));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = Long_val(Field(array, i));
  return numbers;
}

void call(const char* name, Arguments arguments, Frame* frame) {
  answer(name, arguments, frame);
}

}  // namespace certified::runtime
