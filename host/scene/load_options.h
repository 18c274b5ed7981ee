// What a user may say to the reader of a scene, whatever its format.
#pragma once

#include <map>
#include <string>

namespace pencil {

struct LoadOptions {
    std::map<std::string, std::string> defines;  // of the parameters that a scene leaves open: Mitsuba's <default>, its -D
};

}  // namespace pencil
