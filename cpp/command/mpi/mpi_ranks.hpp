#pragma once
/// \file
/// The processes of an MPI job, as the engine asks for them.

#include <mpi.h>

#include "certet/ranks.hpp"
#include "failure.hpp"

namespace certet::command {

/// From MPI_Init to MPI_Finalize.
class MpiSession {
 public:
  MpiSession(int& argc, char**& argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

/// A rank that fails tells so where the others next meet, so that none waits for one that is
/// gone: each meeting begins with whether all have come to it.
class MpiRanks final : public Ranks {
 public:
  MpiRanks();
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  std::vector<std::vector<std::byte>> gather(std::span<const std::byte> own) override;

  /// Those that share its memory and processors, this one among them.
  [[nodiscard]] int on_this_machine() const;

  /// Meets the others and tells them that this rank has failed, unless it did so because another
  /// one had.  \returns what the first of those had to say that failed.
  Failure first_failure(const Failure& own);

 private:
  /// Whether all have come; else `failure_` is that of the first that has failed.
  bool all_have_come(const Failure* own);

  int rank_ = 0, count_ = 1;
  bool has_ended_ = false;
  Failure failure_{};
};

}  // namespace certet::command
