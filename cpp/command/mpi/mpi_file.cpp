#include "mpi_file.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "certet/error.hpp"
#include "certet/ranks.hpp"
#include "ending.hpp"
#include "files/formats/output_file.hpp"

namespace certet::command {
namespace {

namespace fs = std::filesystem;

/// The first rank makes the file and gives it its name; each opens it for itself alone, so that
/// one that fails does not leave the others waiting in a call that all have to make.  What a rank
/// writes at once is long and in one piece, of which to collect it from several makes nothing
/// faster.
class MpiFile final : public SharedFile {
 public:
  MpiFile(const fs::path& target, std::uint64_t bytes, Ranks& ranks)
      : target_(target), ranks_(ranks) {
    if (ranks.rank() == 0) {
      whole_.emplace(target);
      unfinished_.emplace(whole_->growing());
      whole_->reserve(bytes);
    }
    const std::string name = name_of_first();
    if (ranks.rank() != 0) unfinished_.emplace(name);
    check(MPI_File_open(MPI_COMM_SELF, name.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file_));
    is_open_ = true;
  }

  ~MpiFile() override {
    if (is_open_) MPI_File_close(&file_);
  }
  MpiFile(const MpiFile&) = delete;
  MpiFile& operator=(const MpiFile&) = delete;

  void write_at(std::uint64_t offset, std::span<const std::byte> bytes) override {
    constexpr std::size_t at_once = std::size_t{1} << 30;
    while (!bytes.empty()) {
      const auto size = static_cast<int>(std::min(bytes.size(), at_once));
      MPI_Status status{};
      check(MPI_File_write_at(file_, static_cast<MPI_Offset>(offset), bytes.data(), size, MPI_BYTE,
                              &status));
      int written = 0;
      MPI_Get_count(&status, MPI_BYTE, &written);
      if (written <= 0) fail("the disk takes no more");
      offset += static_cast<std::uint64_t>(written);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  void commit() override {
    check(MPI_File_sync(file_));
    is_open_ = false;
    check(MPI_File_close(&file_));
    meet(ranks_);
    if (whole_) whole_->commit();
    meet(ranks_);
    unfinished_.reset();
  }

  [[noreturn]] void fail(const std::string& reason) const override {
    throw Error(ErrorCode::write_failed, "cannot write '" + target_.string() + "': " + reason);
  }

 private:
  [[nodiscard]] std::string name_of_first() {
    const std::string own = whole_ ? fs::absolute(whole_->growing()).string() : std::string();
    const std::vector<char> name = gather_all(ranks_, std::span<const char>(own));
    return {name.begin(), name.end()};
  }

  void check(int error) const {
    if (error == MPI_SUCCESS) return;
    std::array<char, MPI_MAX_ERROR_STRING> text{};
    int length = 0;
    MPI_Error_string(error, text.data(), &length);
    fail("rank " + std::to_string(ranks_.rank()) + " says " +
         std::string(text.data(), static_cast<std::size_t>(length)));
  }

  fs::path target_;
  Ranks& ranks_;
  std::optional<Unfinished> unfinished_;
  std::optional<formats::OutputFile> whole_;  ///< of the first rank
  MPI_File file_{};
  bool is_open_ = false;
};

}  // namespace

std::unique_ptr<SharedFile> create_shared(const fs::path& file, std::uint64_t bytes, Ranks& ranks) {
  return std::make_unique<MpiFile>(file, bytes, ranks);
}

}  // namespace certet::command
