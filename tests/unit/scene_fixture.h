// A temporary folder to write scenes and meshes into, and short ways to load them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/formats/load_scene.h"
#include "util/error.h"

namespace pencil::test {

class SceneTest : public ::testing::Test {
protected:
    void SetUp() override {
        const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("pencil_" + std::to_string(getpid()) + "_" + info->test_suite_name() + "_" + info->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& content) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::filesystem::remove(folder_ / name);  // a file truncated and written again is flushed to disk by some file systems: slow
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    Scene load_text(const std::string& text, const LoadOptions& options = {}) const {
        return load_scene(write("scene.xml", text), options);
    }

    /// Line 1 is <scene>, line 2 a sensor; `body` begins on line 3.
    static std::string in_scene(const std::string& body) {
        return "<scene version=\"3.0.0\">\n<sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/></sensor>\n" + body +
               "</scene>\n";
    }
    Scene load_body(const std::string& body, const LoadOptions& options = {}) const { return load_text(in_scene(body), options); }

    /// The message of the SceneError, or "" if the scene loads.
    std::string error_of(const std::string& text, const LoadOptions& options = {}) const {
        try {
            load_text(text, options);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::scene) << error.what();
            return error.what();
        }
        return "";
    }
    std::string error_of_body(const std::string& body) const { return error_of(in_scene(body)); }

    /// The error names scene.xml, the line and the text.
    void expect_error(const std::string& body, int line, const std::string& part) const {
        const std::string message = error_of_body(body);
        EXPECT_NE(message.find("scene.xml:" + std::to_string(line) + ": "), std::string::npos) << "no line " << line << " in: " << message;
        EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
    }

    /// The scene loads with a warning that names the line and the text, and does not load by --strict.
    void expect_approximation(const std::string& body, int line, const std::string& part) const {
        const std::string place = "scene.xml:" + std::to_string(line) + ": ";
        bool found = false;
        std::string all;
        for (const std::string& warning : load_body(body).warnings) {
            found = found || (warning.find(place) != std::string::npos && warning.find(part) != std::string::npos);
            all += warning + "\n";
        }
        EXPECT_TRUE(found) << "no \"" << part << "\" at line " << line << " in: " << all;
        LoadOptions strict;
        strict.strict = true;
        EXPECT_NE(error_of(in_scene(body), strict).find(part), std::string::npos) << part;
    }

    static bool has_warning(const Scene& scene, const std::string& part) {
        for (const std::string& warning : scene.warnings)
            if (warning.find(part) != std::string::npos) return true;
        return false;
    }

    std::filesystem::path folder_;
};

/// Twice the area vector of a triangle, counter-clockwise.
inline glm::dvec3 face_vector(const Scene& scene, std::size_t triangle) {
    const glm::uvec3 c = scene.triangles[triangle].corners;
    const glm::dvec3 a = scene.positions[c.y] - scene.positions[c.x], b = scene.positions[c.z] - scene.positions[c.x];
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline void expect_near(glm::dvec3 value, glm::dvec3 expected, double tolerance) {
    EXPECT_NEAR(value.x, expected.x, tolerance);
    EXPECT_NEAR(value.y, expected.y, tolerance);
    EXPECT_NEAR(value.z, expected.z, tolerance);
}

}  // namespace pencil::test
