// Files of this folder that are part of the program, put in by cmake/EmbedText.cmake.
#pragma once

namespace pencil {

extern const char* const page_css;
extern const char* const plot_script;

}  // namespace pencil
