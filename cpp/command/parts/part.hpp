#pragma once
/// \file
/// Parts of the program that need heavy libraries: modules of their own, which are loaded when an
/// input or an output wants them, so that no other run pays for them at its start.  A part has two
/// files here: what is in its module, and what stands in for it in the program, function by function.

namespace certet::command {

/// What a module tells by its one function, `extern "C" Part certet_part()`.
struct Part {
  const char* version;    ///< CERTET_VERSION of its build
  const void* functions;  ///< a table of them, of the type that both sides know
};

/// A module's table, loaded for good.  `name`, the `module` of its type, is that of its file in the
/// folder of modules, which the program has as its run path.
/// \throws Error `bad_option` where it is not installed, or is of another version.
const void* load_part(const char* name);

template <class Functions>
const Functions& part() {
  static const void* const functions = load_part(Functions::module);
  return *static_cast<const Functions*>(functions);
}

}  // namespace certet::command
