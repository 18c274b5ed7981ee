// Images and difference images of the page, as HTML.
#pragma once

#include <string>

#include "converge/report.h"

namespace pencil {

/// The reference, and every method's image and difference at about one second and at its longest time.
std::string picture_sections(const Report& report);

}  // namespace pencil
