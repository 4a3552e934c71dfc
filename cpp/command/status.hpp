#pragma once
/// \file
/// What the program tells the shell.

#include "certet/error.hpp"

namespace certet::command {

/// Exit statuses; `certet --help` lists them.
enum class Status {
  ok = 0,
  check_failed = 1,      ///< `certet check`: the mesh breaks a property
  usage = 2,             ///< arguments that make no sense
  bad_input = 3,         ///< an input that cannot be read
  empty = 4,             ///< nothing is inside: no mesh
  too_large = 5,         ///< beyond memory or the coordinate range
  write_failed = 6,      ///< an output cannot be written, or cannot hold the mesh
  guarantee_broken = 7,  ///< a mesh outside its proven bounds (not written)
  interrupted = 130,
};

constexpr Status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_option: return Status::usage;
    case ErrorCode::bad_input: return Status::bad_input;
    case ErrorCode::empty_domain: return Status::empty;
    case ErrorCode::too_large: return Status::too_large;
    case ErrorCode::write_failed: return Status::write_failed;
    case ErrorCode::cancelled: return Status::interrupted;
    case ErrorCode::check_failed: return Status::guarantee_broken;
  }
  return Status::usage;
}

}  // namespace certet::command
