#include "mpi_ranks.hpp"

#include <limits>
#include <string>

#include "certet/error.hpp"

namespace certet::command {
namespace {

ErrorCode code_of(Status status) {
  for (const ErrorCode code :
       {ErrorCode::bad_option, ErrorCode::bad_input, ErrorCode::empty_domain, ErrorCode::too_large,
        ErrorCode::write_failed, ErrorCode::cancelled, ErrorCode::check_failed})
    if (status_of(code) == status) return code;
  return ErrorCode::bad_input;
}

}  // namespace

// A file is written from whichever thread comes to it, one at a time.
MpiSession::MpiSession(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
}

MpiSession::~MpiSession() { MPI_Finalize(); }

MpiRanks::MpiRanks() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

int MpiRanks::on_this_machine() const {
  MPI_Comm machine{};
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
  int count = 1;
  MPI_Comm_size(machine, &count);
  MPI_Comm_free(&machine);
  return count;
}

bool MpiRanks::all_have_come(const Failure* own) {
  const int failed = own == nullptr ? count_ : rank_;
  int first = count_;
  MPI_Allreduce(&failed, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (first == count_) return true;
  has_ended_ = true;
  if (rank_ == first) failure_ = *own;
  int status = static_cast<int>(failure_.status);
  auto length = static_cast<int>(failure_.sentence.size());
  MPI_Bcast(&status, 1, MPI_INT, first, MPI_COMM_WORLD);
  MPI_Bcast(&length, 1, MPI_INT, first, MPI_COMM_WORLD);
  failure_.status = static_cast<Status>(status);
  failure_.sentence.resize(static_cast<std::size_t>(length));
  MPI_Bcast(failure_.sentence.data(), length, MPI_CHAR, first, MPI_COMM_WORLD);
  return false;
}

std::vector<std::vector<std::byte>> MpiRanks::gather(std::span<const std::byte> own) {
  if (own.size() > std::numeric_limits<int>::max() / static_cast<unsigned>(count_))
    throw Error(ErrorCode::too_large, "the ranks have more to tell each other than MPI takes");
  if (!all_have_come(nullptr)) throw Error(code_of(failure_.status), failure_.sentence);
  const auto size = static_cast<int>(own.size());
  std::vector<int> sizes(static_cast<std::size_t>(count_)), places(sizes.size());
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
  for (std::size_t r = 1; r < sizes.size(); ++r) places[r] = places[r - 1] + sizes[r - 1];
  std::vector<std::byte> bytes(static_cast<std::size_t>(places.back() + sizes.back()));
  MPI_Allgatherv(own.data(), size, MPI_BYTE, bytes.data(), sizes.data(), places.data(), MPI_BYTE,
                 MPI_COMM_WORLD);
  std::vector<std::vector<std::byte>> all(sizes.size());
  for (std::size_t r = 0; r < sizes.size(); ++r)
    all[r].assign(bytes.begin() + places[r], bytes.begin() + places[r] + sizes[r]);
  return all;
}

Failure MpiRanks::first_failure(const Failure& own) {
  if (!has_ended_) all_have_come(&own);
  return failure_;
}

}  // namespace certet::command
