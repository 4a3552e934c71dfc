#pragma once
/// \file
/// Voxels as they lie in files, read to the last byte or not at all.

#include <cstdint>
#include <filesystem>

namespace certet {

/// `bytes` bytes, behind `offset` bytes of the file and, once unpacked, `lead` more.
struct StoredPart {
  std::filesystem::path file;
  std::uint64_t offset = 0, lead = 0, bytes = 0;
  bool packed = false;  ///< by gzip or zlib
};

/// Whether a file begins as one packed by gzip does, whatever its name.
bool is_packed(const std::filesystem::path& file);

/// Checks, before memory is taken, that the part can be in its file: what is packed
/// cannot have shrunk more than deflate can shrink.
/// \throws Error `bad_input` naming the file.
void check_length(const StoredPart& part);

/// Writes `part.bytes` bytes.  What is packed is unpacked to its end, so that its
/// checksum is checked too.
/// \throws Error `bad_input` naming the file, where they are not all there.
void read_part(const StoredPart& part, char* to);

/// The same for nothing but the check.
void check_part(const StoredPart& part);

}  // namespace certet
