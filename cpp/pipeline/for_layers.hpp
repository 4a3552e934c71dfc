#pragma once
/// \file
/// Work on layers, shared among threads.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <future>
#include <thread>
#include <vector>

namespace certet {

/// Calls work(layer) for every layer of [begin, end) from up to `threads`
/// threads (0: as many as the machine has); rethrows the first exception.
template <class Work>
void for_layers(std::int32_t begin, std::int32_t end, int threads, const Work& work) {
  if (threads <= 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::atomic<std::int32_t> next{begin};
  const auto run = [&] {
    for (std::int32_t layer = next++; layer < end; layer = next++) work(layer);
  };
  std::vector<std::future<void>> others;
  for (int t = 1; t < std::min(threads, end - begin); ++t)
    others.push_back(std::async(std::launch::async, run));
  run();
  for (auto& other : others) other.get();
}

}  // namespace certet
