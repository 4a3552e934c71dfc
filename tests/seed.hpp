#pragma once
/// \file
/// Random numbers whose seed is printed and can be given: CERTET_SEED=<number>.

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

/// The seed of this run.
inline std::uint64_t test_seed() {
  static const std::uint64_t seed = [] {
    const char* given = std::getenv("CERTET_SEED");
    const std::uint64_t chosen =
        given != nullptr ? std::stoull(given) : (std::uint64_t{std::random_device{}()} << 16);
    std::cout << "CERTET_SEED=" << chosen << '\n';
    return chosen;
  }();
  return seed;
}

/// A whole number in [low, high].
template <class Generator>
std::int32_t between(Generator& random, std::int32_t low, std::int32_t high) {
  return std::uniform_int_distribution<std::int32_t>(low, high)(random);
}

/// A number that depends on the seed and on `keys` alone, well mixed.
template <class... Keys>
constexpr std::uint64_t mixed(std::uint64_t seed, Keys... keys) {
  static_assert(sizeof...(keys) > 0);
  std::uint64_t h = seed;
  const auto mix = [&h](std::uint64_t key) {
    h += 0x9e3779b97f4a7c15U + key;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
    h ^= h >> 31;
  };
  (mix(static_cast<std::uint64_t>(keys)), ...);
  return h;
}

/// That of one of many trials.  `mixed` of both would be that of their sum: the trials of one seed
/// would be those of the next one, but for the first.
constexpr std::uint64_t trial_seed(std::uint64_t seed, std::uint64_t number) {
  return mixed(seed, 0, number);
}
