// Luminous intensity of lamps as their makers measure it: LM-63 files (IES), 1986 to 2019.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace pencil {

struct PhotometricData {
    LightProfile profile;  // 1 where the lamp is brightest
    double candela = 0;    // there
};

/// `name` is the file's name for messages. Photometry of type C; tilt tables are read over.
PhotometricData read_ies(std::string_view text, const std::string& name);

}  // namespace pencil
