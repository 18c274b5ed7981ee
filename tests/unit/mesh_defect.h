// What a reader of meshes says of a damaged file.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "util/error.h"

namespace pencil {

/// The message with which `read(content)` refuses it; empty if it is accepted.
template <class Read>
std::string defect_of(Read read, const std::string& content) {
    try {
        read(content);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

/// `message` begins with `where` and holds `part`.
inline void expect_message(const std::string& message, const std::string& where, const std::string& part) {
    EXPECT_EQ(message.rfind(where, 0), 0U) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

}  // namespace pencil
