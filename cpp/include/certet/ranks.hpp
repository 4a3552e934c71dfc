#pragma once
/// \file
/// Those who make one mesh together, each with some of its layers: what the engine asks of them.

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace certet {

/// One of several processes, or of several threads that stand for them; ranks are numbered from 0.
class Ranks {
 public:
  virtual ~Ranks() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int count() const = 0;
  /// What each rank gives, in the order of ranks; every rank gets it.  All ranks call it equally
  /// often, and with the same in mind.
  /// \throws Error where one of them has failed, at all of them: that of the first.
  virtual std::vector<std::vector<std::byte>> gather(std::span<const std::byte> own) = 0;
};

/// The values of all ranks, in the order of ranks; each may give any number of them.
template <class T>
std::vector<T> gather_all(Ranks& ranks, std::span<const T> own) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> all;
  for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(own))) {
    const std::size_t begin = all.size();
    all.resize(begin + bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(all.data() + begin, bytes.data(), bytes.size());
  }
  return all;
}

/// One value of each rank.
template <class T>
std::vector<T> gather_each(Ranks& ranks, const T& own) {
  return gather_all(ranks, std::span<const T>(&own, 1));
}

/// Comes back when all ranks have come here, none of which has failed.
inline void meet(Ranks& ranks) { static_cast<void>(ranks.gather({})); }

}  // namespace certet
