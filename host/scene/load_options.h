// What a user may say to the reader of a scene, whatever its format.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pencil {

struct LoadOptions {
    std::map<std::string, std::string> defines;       // of the parameters that a scene leaves open: Mitsuba's <default>, its -D
    std::vector<std::filesystem::path> allowed = {};  // folders beside the scene's own that it may name files in
    bool strict = false;                              // what could only be approximated is an error
    bool camera = true;                               // the camera will be used: it matters if there is none
};

}  // namespace pencil
