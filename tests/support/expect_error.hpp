// SPDX-License-Identifier: MIT
// What an Error must be: the right exit code, and one sentence with the words that help.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <string>

#include "core/error.hpp"

namespace raytorus::test {

/// Runs it and checks the Error it throws. Every word must be in the message.
inline void expectError(std::invocable auto run, ExitCode code, std::initializer_list<std::string> words) {
    try {
        run();
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(error.exitCode, code) << message;
        for (const std::string& word : words) {
            EXPECT_NE(message.find(word), std::string::npos) << "\"" << word << "\" is not in: " << message;
        }
        EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
        EXPECT_FALSE(message.ends_with('.')) << message;
        return;
    }
    ADD_FAILURE() << "no Error was thrown";
}

/// Runs it and checks that its Error says this sentence, and nothing more.
inline void expectSentence(std::invocable auto run, ExitCode code, const std::string& sentence) {
    try {
        run();
        ADD_FAILURE() << "no Error was thrown, which would say: " << sentence;
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), sentence);
        EXPECT_EQ(error.exitCode, code) << sentence;
    }
}

}  // namespace raytorus::test
