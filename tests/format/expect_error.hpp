#pragma once
/// \file
/// Errors with a code, one sentence, and words that must be in it.

#include <gtest/gtest.h>

#include <string>

#include "certet/error.hpp"

namespace certet::test {

template <class Action>
void expect_error(ErrorCode code, const std::string& words, Action action) {
  try {
    action();
    ADD_FAILURE() << "no error, where one should say: " << words;
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.code(), code) << sentence;
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
}

}  // namespace certet::test
