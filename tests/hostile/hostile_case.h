// The corpus of hostile input: each case makes its files, runs the program once, and says how that must end. The numbers are those of the list in
// docs/stability.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {

using Arguments = std::vector<std::string>;

struct HostileCase {
    std::string name;
    int code = 3;      // exit status
    std::string says;  // part of stderr; where the status is 0, of stdout and stderr
    std::function<Arguments(const Folder&)> make;
    std::map<std::string, std::string> environment = {};
};

/// A case that reads one file by `pencil info`.
HostileCase reads(const std::string& name, int code, const std::string& says, const std::string& file,
                  const std::function<std::string()>& content);
/// The same of scene.xml, with this inside a whole scene of one triangle and a camera.
HostileCase scene_with(const std::string& name, int code, const std::string& says, const std::string& body);
/// The same, beside files of these names and bytes.
HostileCase scene_with(const std::string& name, int code, const std::string& says, const std::string& body,
                       const std::vector<std::pair<std::string, std::string>>& files);
/// `text` `count` times.
std::string repeated(const std::string& text, std::size_t count);
/// A whole scene around `body`.
std::string scene_around(const std::string& body);

std::vector<HostileCase> hostile_scenes();
std::vector<HostileCase> hostile_meshes();
std::vector<HostileCase> hostile_gltf();
std::vector<HostileCase> hostile_pictures();
std::vector<HostileCase> hostile_runs();

}  // namespace pencil_test
